// SPDX-License-Identifier: BSD-3-Clause
// Applies a transform to a primitive, type by type.  s = |scale|; a mirror reverses polygons (as -I does: twice is
// nothing).
#include <algorithm>
#include <cmath>
#include "scene/transform.h"
#include "scene/types.h"

namespace scene {

namespace {

void move_point(const Xform& x, double* p) {
    const base::Vec3 q = point(x, {p[0], p[1], p[2]});
    for (int j = 0; j < 3; j++) p[j] = q[j];
}
void move_vector(const Xform& x, double* p) {
    const base::Vec3 q = vector(x, {p[0], p[1], p[2]});
    for (int j = 0; j < 3; j++) p[j] = q[j];
}

void reverse_vertices(std::vector<double>& r) {
    for (size_t i = 0, j = r.size(); i + 3 <= j; i += 3) {
        j -= 3;
        for (int k = 0; i < j && k < 3; k++) std::swap(r[i + k], r[j + k]);
    }
}

Type inside_out(Type t) {
    switch (t) {
    case Type::sphere: return Type::bubble;
    case Type::bubble: return Type::sphere;
    case Type::cone: return Type::cup;
    case Type::cup: return Type::cone;
    case Type::cylinder: return Type::tube;
    case Type::tube: return Type::cylinder;
    default: return t;
    }
}

// "relay>source": every part gets the prefix.
std::string prefixed_path(const std::string& path, const std::string& prefix) {
    std::string s = prefix + ".";
    for (char c : path) {
        s += c;
        if (c == '>') s += prefix + ".";
    }
    return s;
}

}  // namespace

void apply(const Transform& t, Primitive& p) {
    const Xform& x = t.matrix;
    const double s = std::fabs(x.scale);
    double* r = p.reals.data();
    if (is_surface(p.type)) {
        if (!t.prefix.empty()) p.name = t.prefix + "." + p.name;
        if (!t.modifier.empty()) p.modifier = t.modifier;
        if (t.invert) p.type = inside_out(p.type);
    }
    switch (p.type) {
    case Type::source: move_vector(x, r); break;
    case Type::sphere:
    case Type::bubble:
        move_point(x, r);
        r[3] *= s;
        break;
    case Type::polygon:
        for (size_t i = 0; i < p.reals.size(); i += 3) move_point(x, r + i);
        if (t.invert != (x.scale < 0)) reverse_vertices(p.reals);
        break;
    case Type::cone:
    case Type::cup:
    case Type::cylinder:
    case Type::tube:
        move_point(x, r);
        move_point(x, r + 3);
        for (size_t i = 6; i < p.reals.size(); i++) r[i] *= s;
        break;
    case Type::ring:
        move_point(x, r);
        move_vector(x, r + 3);
        if (t.invert)
            for (int i = 3; i < 6; i++) r[i] = -r[i];
        r[6] *= s, r[7] *= s;
        break;
    case Type::glow: r[3] *= s; break;
    case Type::spotlight: move_vector(x, r + 4); break;
    case Type::dielectric:
    case Type::interface:  // transmission is per unit length
        for (size_t i = 0; i < p.reals.size(); i++)
            if ((i & 3) < 3 && (p.type == Type::interface || i < 3)) r[i] = std::pow(r[i], 1 / s);
        break;
    case Type::mist:
        for (size_t i = 0; i < std::min<size_t>(3, p.reals.size()); i++) r[i] /= s;
        if (!t.prefix.empty())
            for (std::string& name : p.strings) name = prefixed_path(name, t.prefix);
        break;
    case Type::colortext:
    case Type::brighttext:
    case Type::mixtext:
        move_point(x, r);
        move_vector(x, r + 3);
        move_vector(x, r + 6);
        break;
    default:
        if (transform_from(p.type) >= 0 && !t.words.empty()) {
            if (t.words[0] != "-i") p.strings.insert(p.strings.end(), {"-i", "1"});
            p.strings.insert(p.strings.end(), t.words.begin(), t.words.end());
        }
    }
}

}  // namespace scene
