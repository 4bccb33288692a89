// SPDX-License-Identifier: BSD-3-Clause
// The shapes' fields.  In space: q = point - eye; a shape covers the directions that reach it.
// Disc (centre c, unit normal n, both from the eye, n away from it; h = n.c > 0): direction d meets the plane inside
// the radius r if |h d - (n.d) c| < r (n.d) with both sides taken along the plane; that difference changes by at most
// r + |c| per radian.
#include "region/shape.h"
#include <algorithm>
#include <cmath>
#include <memory>
#include <fmt/format.h>
#include "base/angle.h"
#include "base/error.h"
#include "region/arcs.h"
#include "region/picture.h"
#include "region/zone.h"

namespace region {
using namespace base;

Space::Space(const view::View& view, int nx_, int ny_) : projector(view), nx(nx_), ny(ny_), eye(view.vp), behind(0) {
    if (view.type != 'l') return;
    behind = 1e7 * std::max(view.vh, view.vv);
    eye = view.vp - behind * projector.forward();
}

bool Space::point(double x, double y, Point& p) const {
    p.x = x;
    p.y = y;
    double X = x / nx, Y = y / ny;
    if (behind > 0) {
        const view::View& v = projector.view();
        p.dir = unit(behind * projector.forward() + ((X - .5 + v.vs) * v.vh) * projector.right() +
                     ((Y - .5 + v.vl) * v.vv) * projector.up());
        return true;
    }
    std::optional<Vec3> d = projector.direction(X, Y);
    if (d) p.dir = *d;
    return bool(d);
}

bool Space::counts(double x, double y) const {
    Point p;
    return point(x, y, p) && (projector.view().type != 'a' || dot(p.dir, projector.forward()) >= 0);
}

namespace {

const double beyond_any = 10;  // beyond any angle

Field nowhere() {
    return {[](const Point&) { return -beyond_any; }};
}

// height: of its plane above the eye, 0 for one of directions.
Field polygon(const std::vector<Vec3>& corners, Vec3 axis, double height = 0) {
    return {[outline = SphericalPolygon(corners, axis)](const Point& p) { return outline.value(p.dir); }, false,
            [axis, height](const Point& p) { return height / dot(axis, p.dir); }};
}

// c, n: from the eye.
Field disc(Vec3 c, Vec3 n, double r) {
    const double h = dot(c, n), steepest = r + length(c);
    const Vec3 in_plane = c - n * h;
    return {[=](const Point& p) {
                const double w = dot(n, p.dir);
                const Vec3 along = p.dir - n * w;
                return (r * w - length(h * along - w * in_plane)) / steepest;
            },
            false, [=](const Point& p) { return h / dot(n, p.dir); }};
}

Field sphere(Vec3 centre, double r, Vec3 eye) {
    const Vec3 c = centre - eye;
    const bool around = length(c) <= r;
    const double half = around ? 0 : std::asin(r / length(c));
    return {[=, axis = around ? Vec3() : unit(c)](const Point& p) {
                return around ? beyond_any : half - angle_between(p.dir, axis);
            },
            false,
            [=](const Point& p) {
                const double b = dot(c, p.dir);
                return around ? 0 : b - std::sqrt(std::max(0.0, b * b - dot(c, c) + r * r));
            },
            [=](Vec3 q) { return length(q - eye - c) <= r * (1 + 1e-9) + 1e-6; }};
}

// The outline of a box is made of the edges between a face turned to the eye and one turned away.
class Box {
public:
    Box(const std::vector<double>& n, Vec3 eye) : eye_(eye) {
        for (int k = 0; k < 3; ++k) {
            lo_[k] = std::min(n[size_t(k)], n[size_t(k) + 3]) - eye[k];
            hi_[k] = std::max(n[size_t(k)], n[size_t(k) + 3]) - eye[k];
        }
        around_ = lo_.x <= 0 && lo_.y <= 0 && lo_.z <= 0 && hi_.x >= 0 && hi_.y >= 0 && hi_.z >= 0;
        if (around_) return;
        auto faces_eye = [&](int axis, int side) { return side ? hi_[axis] < 0 : lo_[axis] > 0; };
        for (int k = 0; k < 3; ++k)  // edges along axis k lie between faces of axes i and j
            for (int a = 0; a < 2; ++a)
                for (int b = 0; b < 2; ++b) {
                    int i = (k + 1) % 3, j = (k + 2) % 3;
                    if (faces_eye(i, a) == faces_eye(j, b)) continue;
                    Vec3 p, q;
                    p[i] = q[i] = a ? hi_[i] : lo_[i];
                    p[j] = q[j] = b ? hi_[j] : lo_[j];
                    p[k] = lo_[k];
                    q[k] = hi_[k];
                    outline_.add(unit(p), unit(q));
                }
    }
    double value(const Point& p) const {
        if (around_) return beyond_any;
        double t0, d = outline_.distance(p.dir);
        return hit(p.dir, t0) ? d : -d;
    }
    double distance(const Point& p) const {
        double t0 = 0;
        return !around_ && hit(p.dir, t0) ? t0 : 0;
    }
    bool contains(Vec3 q) const {
        q = q - eye_;
        const double e = 1e-6;
        for (int k = 0; k < 3; ++k)
            if (q[k] < lo_[k] - e || q[k] > hi_[k] + e) return false;
        return true;
    }

private:
    bool hit(Vec3 d, double& t0) const {
        double t1 = INFINITY;
        t0 = 0;
        for (int k = 0; k < 3; ++k) {
            if (d[k] == 0) {
                if (lo_[k] > 0 || hi_[k] < 0) return false;
                continue;
            }
            double a = lo_[k] / d[k], b = hi_[k] / d[k];
            t0 = std::max(t0, std::min(a, b));
            t1 = std::min(t1, std::max(a, b));
        }
        return t0 <= t1;
    }
    Vec3 eye_, lo_, hi_;
    bool around_;
    Arcs outline_;
};

Field box_field(const std::vector<double>& numbers, Vec3 eye) {
    const auto box = std::make_shared<Box>(numbers, eye);
    return {[box](const Point& p) { return box->value(p); }, false, [box](const Point& p) { return box->distance(p); },
            [box](Vec3 q) { return box->contains(q); }};
}

Vec3 triple(const std::vector<double>& n, size_t at) { return {n[at], n[at + 1], n[at + 2]}; }

Field polygon3d(const Shape& s, const Space& space) {
    std::vector<Vec3> points;
    for (size_t i = 0; i < s.numbers.size(); i += 3) points.push_back(triple(s.numbers, i));
    Vec3 normal, centre;
    for (size_t i = 0; i < points.size(); ++i) centre = centre + points[i] * (1.0 / double(points.size()));
    for (size_t i = 0; i < points.size(); ++i)  // Newell's normal: twice the area
        normal = normal + cross(points[i] - centre, points[(i + 1) % points.size()] - centre);
    double area = length(normal), size = 0;
    for (Vec3 p : points) size = std::max(size, length(p - centre));
    if (!(area > 1e-12 * size * size) || size == 0) fail(s.place, "the polygon has no area");
    normal = normal * (1 / area);
    for (size_t i = 0; i < points.size(); ++i) {
        double off = std::fabs(dot(points[i] - centre, normal));
        if (off > 1e-3 * size)
            fail(s.place, fmt::format("the polygon is not flat: point {} lies {:.3g} off its plane", i + 1, off));
    }
    double height = dot(centre - space.eye, normal);
    if (height < 0) normal = -normal, height = -height;
    std::vector<Vec3> corners;
    for (Vec3 p : points) {
        Vec3 d = p - space.eye;
        if (!(dot(d, normal) > 1e-9 * size)) return nowhere();  // seen edge on
        corners.push_back(unit(d));
    }
    return polygon(corners, normal, height);
}

Field disc3d(const Shape& s, const Space& space) {
    Vec3 centre = triple(s.numbers, 0) - space.eye, normal = unit(triple(s.numbers, 3));
    if (dot(centre, normal) < 0) normal = -normal;
    if (dot(centre, normal) <= 1e-9 * s.numbers[6]) return nowhere();  // edge on
    return disc(centre, normal, s.numbers[6]);
}

Field polygon_direction(const Shape& s, const Space& space) {
    if (space.behind > 0) fail(s.place, "a polygon of directions needs a view with an eye point, not -vtl");
    std::vector<Vec3> corners;
    Vec3 sum, winding;
    for (size_t i = 0; i < s.numbers.size(); i += 3) {
        Vec3 d = triple(s.numbers, i);
        if (length(d) == 0) fail(s.place, fmt::format("direction {} of the polygon is zero", i / 3 + 1));
        corners.push_back(unit(d));
        sum = sum + corners.back();
    }
    for (size_t i = 0; i < corners.size(); ++i)
        winding = winding + cross(corners[i], corners[(i + 1) % corners.size()]);
    for (Vec3 axis : {unit(sum), unit(winding), unit(-winding)}) {
        bool good = true;
        for (Vec3 c : corners) good = good && dot(c, axis) > 1e-6;
        if (good) return polygon(corners, axis);
    }
    fail(s.place, "the polygon's directions do not lie within one hemisphere");
}

Field circle(const Shape& s, const Space& space) {
    if (space.behind > 0) fail(s.place, "a circle of directions needs a view with an eye point, not -vtl");
    const std::vector<double>& n = s.numbers;
    Vec3 axis;
    Point p;
    switch (s.frame) {
    case Frame::direction: axis = unit(triple(n, 0)); break;
    case Frame::point:
        axis = triple(n, 0) - space.eye;
        if (length(axis) == 0) fail(s.place, "the circle's point is the eye point");
        axis = unit(axis);
        break;
    case Frame::view: axis = space.projector.forward(); break;
    case Frame::pixel:
    case Frame::fraction: {
        // A pixel x y is meant by its centre, as evalglare's -t means it.
        double x = s.frame == Frame::pixel ? n[0] + .5 : n[0] * space.nx,
               y = s.frame == Frame::pixel ? n[1] + .5 : n[1] * space.ny;
        if (!(x >= 0 && y >= 0 && x <= space.nx && y <= space.ny))
            fail(s.place,
                 fmt::format("the circle's centre is not in the picture ({} x {} pixels)", space.nx, space.ny));
        if (!space.point(x, y, p)) fail(s.place, "the circle's centre is outside the view's image");
        axis = p.dir;
    }
    }
    return cone(axis, n.back() / 2 * base::degree);
}

}  // namespace

Field cone(Vec3 axis, double half_rad) {
    return {[=](const Point& p) { return half_rad - angle_between(p.dir, axis); }};
}

Field make_field(const Shape& s, const Space& space) {
    switch (s.kind) {
    case Kind::polygon3d: return polygon3d(s, space);
    case Kind::disc3d: return disc3d(s, space);
    case Kind::box3d: return box_field(s.numbers, space.eye);
    case Kind::sphere3d: return sphere(triple(s.numbers, 0), s.numbers[3], space.eye);
    case Kind::circle: return circle(s, space);
    case Kind::polygon_direction: return polygon_direction(s, space);
    case Kind::rect:
    case Kind::polygon: return make_picture_shape(s, space);
    case Kind::mask: return make_mask_field(s, space);
    case Kind::zone: return make_zone(s, space);
    case Kind::surface:
    case Kind::modifier: break;
    }
    fail(s.place, "a question to the scene is not a shape");
}

}  // namespace region
