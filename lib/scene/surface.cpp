// SPDX-License-Identifier: BSD-3-Clause
// Canonical form of surfaces, and which of them are unusable.  Lengths below 1e-6 count as zero, as in RADIANCE.
#include <cmath>
#include "base/error.h"
#include "base/vec.h"
#include "scene/builder.h"

namespace scene {

namespace {

using base::Vec3;
constexpr double tiny = 1e-6;

Vec3 at(const std::vector<double>& r, size_t i) { return {r[i], r[i + 1], r[i + 2]}; }

bool check_polygon(Primitive& p, const SceneBuilder& builder, std::string& fact) {
    std::vector<double>& r = p.reals;
    const Vec3 first = at(r, 0);
    if (r.size() > 9 && length(at(r, r.size() - 3) - first) <= tiny) r.resize(r.size() - 3);
    Vec3 sum;  // twice the vector area: the fan of triangles from the first vertex (Newell)
    for (size_t i = 3; i + 3 < r.size(); i += 3) sum = sum + cross(at(r, i) - first, at(r, i + 3) - first);
    const double area2 = length(sum);
    if (!(area2 > 0)) {
        fact = "a polygon without area";
        return false;
    }
    const Vec3 normal = sum * (1 / area2);
    double total = 0;
    for (size_t i = 0; i < r.size(); i += 3) {
        const double offset = dot(normal, at(r, i));
        if (i) {
            const double mean = total / (i / 3);
            if (std::fabs(std::fabs(mean) < 1e-5 ? offset - mean : 1 - offset / mean) > 1e-5) {
                base::warn(builder.place(p), "polygon vertices do not lie in a plane");
                break;
            }
        }
        total += offset;
    }
    return true;
}

// Cone, cup, cylinder, tube.  Negative radii swap inside and outside.
bool check_cone(Primitive& p, const SceneBuilder& builder, std::string& fact) {
    std::vector<double>& r = p.reals;
    const bool round = p.type == Type::cylinder || p.type == Type::tube;
    const double r0 = r[6], r1 = round ? r0 : r[7];
    bool outward = p.type == Type::cone || p.type == Type::cylinder;
    if (std::fabs(r0) <= tiny && std::fabs(r1) <= tiny) {
        fact = std::string("a ") + type_name(p.type) + " without radius";
        return false;
    }
    if (r0 < -tiny || r1 < -tiny) {
        if (r0 > tiny || r1 > tiny) {
            fact = std::string("a ") + type_name(p.type) + " with radii of opposite sign";
            return false;
        }
        base::warn(builder.place(p), "a negative radius turns the surface inside out");
        outward = !outward;
    }
    if (length(at(r, 3) - at(r, 0)) <= tiny) {
        fact = std::string("a ") + type_name(p.type) + " without length";
        return false;
    }
    r[6] = std::fabs(r0);
    if (!round) r[7] = std::fabs(r1);
    if (std::fabs(std::fabs(r0) - std::fabs(r1)) <= tiny) {
        r.resize(7);
        p.type = outward ? Type::cylinder : Type::tube;
    } else {
        p.type = outward ? Type::cone : Type::cup;
    }
    return true;
}

}  // namespace

bool normalize_surface(Primitive& p, const SceneBuilder& builder, std::string& fact) {
    std::vector<double>& r = p.reals;
    switch (p.type) {
    case Type::source:
        if (length(at(r, 0)) <= 0) base::fail(builder.place(p), "a source needs a direction");
        return true;
    case Type::sphere:
    case Type::bubble:
        if (std::fabs(r[3]) <= tiny) base::fail(builder.place(p), "a sphere without radius");
        if (r[3] < 0) {
            base::warn(builder.place(p), "a negative radius turns the surface inside out");
            p.type = p.type == Type::sphere ? Type::bubble : Type::sphere;
            r[3] = -r[3];
        }
        return true;
    case Type::polygon: return check_polygon(p, builder, fact);
    case Type::cone:
    case Type::cup:
    case Type::cylinder:
    case Type::tube: return check_cone(p, builder, fact);
    case Type::ring:
        if (r[6] < 0 || r[7] < 0 || std::fabs(r[6] - r[7]) <= tiny)
            fact = "a ring with a negative radius or without width";
        else if (length(at(r, 3)) <= tiny) fact = "a ring without direction";
        if (r[6] > r[7]) std::swap(r[6], r[7]);
        return fact.empty();
    default: return true;
    }
}

}  // namespace scene
