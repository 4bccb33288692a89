// SPDX-License-Identifier: BSD-3-Clause
// Borders on the sphere of directions: distances to great-circle arcs, and polygons made of them.
// A straight edge in space is seen as the arc (shorter than pi) between its ends' directions.
#pragma once
#include <vector>
#include "base/vec.h"

namespace region {
using base::Vec3;

double angle_between(Vec3 a, Vec3 b);  // radians, unit vectors, accurate for small angles too

class Arcs {
public:
    void add(Vec3 a, Vec3 b);       // unit directions
    double distance(Vec3 d) const;  // radians to the nearest arc; pi if there is none
private:
    struct Arc {
        Vec3 a, b, normal, inside_a, inside_b;
    };
    std::vector<Arc> arcs_;
};

// Even-odd polygon of directions that all lie within 90 degrees of `axis`; seams cancel, as in RADIANCE's polygons.
class SphericalPolygon {
public:
    SphericalPolygon(const std::vector<Vec3>& corners, Vec3 axis);
    double value(Vec3 d) const;  // signed distance to the border, > 0 inside
private:
    bool inside(Vec3 d) const;
    Vec3 axis_, e1_, e2_;
    struct Uv {
        double u, v;
    };
    std::vector<Uv> corners_;  // in the plane that touches the sphere at the axis
    Arcs arcs_;
};

}  // namespace region
