// SPDX-License-Identifier: BSD-3-Clause
// See arcs.h.  Inside or outside is decided in the gnomonic projection along the axis, where arcs are straight lines.
#include "region/arcs.h"
#include <algorithm>
#include <cmath>

namespace region {
using namespace base;

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

void Arcs::add(Vec3 a, Vec3 b) {
    Vec3 n = cross(a, b - a);  // not cross(a, b), whose rounding tilts the plane of a short arc
    double l = length(n);
    if (!(l > 1e-15)) return;  // no length
    n = n * (1 / l);
    arcs_.push_back({a, b, n, cross(n, a), cross(b, n)});
}

// Compared by the squared chord c2 = 4 sin^2(angle/2), which loses nothing near 0.
double Arcs::distance(Vec3 d) const {
    double nearest = 4;
    for (const Arc& arc : arcs_) {
        double c2;
        if (dot(arc.inside_a, d) >= 0 && dot(arc.inside_b, d) >= 0) {
            double s = dot(arc.normal, d);
            c2 = 2 * s * s / (1 + std::sqrt(std::max(0.0, 1 - s * s)));
        } else {
            Vec3 to_a = d - arc.a, to_b = d - arc.b;
            c2 = std::min(dot(to_a, to_a), dot(to_b, to_b));
        }
        nearest = std::min(nearest, c2);
    }
    return 2 * std::asin(std::min(1.0, std::sqrt(nearest) / 2));
}

SphericalPolygon::SphericalPolygon(const std::vector<Vec3>& corners, Vec3 axis) : axis_(axis) {
    Vec3 other = std::fabs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    e1_ = unit(cross(other, axis));
    e2_ = cross(axis, e1_);
    for (size_t i = 0; i < corners.size(); ++i) {
        Vec3 c = corners[i];
        corners_.push_back({dot(c, e1_) / dot(c, axis), dot(c, e2_) / dot(c, axis)});
        arcs_.add(c, corners[(i + 1) % corners.size()]);
    }
}

bool SphericalPolygon::inside(Vec3 d) const {
    double w = dot(d, axis_);
    if (w <= 0) return false;
    double u = dot(d, e1_) / w, v = dot(d, e2_) / w;
    bool in = false;
    for (size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
        const Uv &a = corners_[i], &b = corners_[j];
        if ((a.v > v) != (b.v > v) && u < a.u + (v - a.v) / (b.v - a.v) * (b.u - a.u)) in = !in;
    }
    return in;
}

double SphericalPolygon::value(Vec3 d) const {
    double distance = arcs_.distance(d);
    return inside(d) ? distance : -distance;
}

}  // namespace region
