// SPDX-License-Identifier: BSD-3-Clause
// Extent of the surfaces of a scene.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "flatten/pack.h"
#include "flatten/surfaces.h"

namespace flatten {

using base::Vec3;
using scene::Type;

void grow(Box& box, Vec3 p) {
    for (int k = 0; k < 3; k++) {
        box.lo[k] = std::min(box.lo[k], p[k]);
        box.hi[k] = std::max(box.hi[k], p[k]);
    }
}

// Near the origin the scene keeps its own coordinates.
Vec3 centre_of(const Box& box) {
    if (box.lo.x > box.hi.x) return {};
    const Vec3 mid = (box.lo + box.hi) * 0.5;
    if (length(mid) <= length(box.hi - box.lo)) return {};
    return {std::round(mid.x), std::round(mid.y), std::round(mid.z)};
}

// 16 in a room of some metres: hits are exact to 2^-20 of it.
double least_reach_of(double radius) {
    constexpr double ordinary = 16, small = .5, large = 1024;
    if (!(radius > 0) || radius >= small) return ordinary;
    return std::ldexp(ordinary, std::max(-100, std::ilogb(radius / large)));
}

Box surface_bounds(const scene::Scene& s) {
    Box box;
    for (const scene::Object& o : s.objects) {
        if (!scene::is_surface(o.type) || o.type == Type::source || o.type == Type::mesh || o.type == Type::instance)
            continue;
        const auto r = s.reals(o);
        const size_t points = o.type == Type::polygon                                                    ? r.size() / 3
                              : o.type == Type::sphere || o.type == Type::bubble || o.type == Type::ring ? 1
                                                                                                         : 2;
        const double round = o.type == Type::polygon || r.size() < 4 ? 0
                             : points == 2          ? std::max(std::fabs(r[6]), r.size() > 7 ? std::fabs(r[7]) : 0)
                             : o.type == Type::ring ? std::max(r[6], r[7])
                                                    : std::fabs(r[3]);
        for (size_t i = 0; i < points && 3 * i + 2 < r.size(); i++) {
            const Vec3 p = vec_at(r, 3 * i), d{round, round, round};
            if (!within_reach(p) || !(round < farthest)) base::fail(s.place(o), "a coordinate is beyond 1e18");
            grow(box, p - d);
            grow(box, p + d);
        }
    }
    return box;
}

}  // namespace flatten
