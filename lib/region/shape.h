// SPDX-License-Identifier: BSD-3-Clause
// A shape as a field over one view: value() > 0 inside, < 0 outside, and never farther from 0 than the distance to
// the shape's border, in radians (directions) or pixels (picture).  So a cell whose points all lie within r of the
// point evaluated is wholly inside or outside as soon as |value| > r: rasterize() refines only where it must.
// In a parallel view directions are those from an eye very far behind the picture, which is what that view is.
#pragma once
#include <functional>
#include "region/region.h"

namespace region {

struct Point {
    Vec3 dir;     // unit; from the (perhaps far) eye
    double x, y;  // pixels from the lower left corner
};

struct Space {
    view::Projector projector;
    int nx, ny;
    Vec3 eye;       // where directions start
    double behind;  // distance of the far eye behind the picture plane of a parallel view, else 0
    Space(const view::View& view, int nx, int ny);
    // false where the view shows nothing
    bool point(double x, double y, Point& p) const;
    // A direction exists and, in an angular fisheye, is not behind the eye (the pixels vcmetrics counts).
    bool counts(double x, double y) const;
};

struct Field {
    std::function<double(const Point&)> value;  // none: of a surface or a modifier
    bool in_picture = false;                    // value is in pixels, not in radians
    // Distance from the eye to the shape along p.dir, for shapes in space where value(p) >= 0; 0 = cannot be hidden.
    std::function<double(const Point&)> distance = [](const Point&) { return 0.; };
    std::function<bool(Vec3)> contains = [](Vec3) { return false; };  // box3d, sphere3d: a point in space
};
Field cone(Vec3 axis, double half_rad);

// Throws Error (place = the shape's) if this view cannot have it.  Not for surface and modifier.
Field make_field(const Shape& shape, const Space& space);

}  // namespace region
