// SPDX-License-Identifier: BSD-3-Clause
// Picture plane <-> directions for RADIANCE's six projections, and the solid angle of a pixel.
// With d, h, u the unit view, right and up vectors and (x,y) = (X - .5 + vs, Y - .5 + vl), a pixel's plane
// coordinates are a = sx x, b = sy y; each type says what (a,b) means (see the switch).
#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "base/hypot.h"
#include "view/density.h"

namespace view {
namespace {
using base::degree;
}

Projector::Projector(const View& v) : view_(v) {
    validate(v);
    d_ = unit(v.vd);
    h_ = unit(cross(d_, unit(v.vu)));
    u_ = cross(h_, d_);
    switch (v.type) {
    case 'v': sx_ = 2 * std::tan(v.vh / 2 * degree), sy_ = 2 * std::tan(v.vv / 2 * degree); break;
    case 'l': sx_ = v.vh, sy_ = v.vv; break;
    case 'a': sx_ = v.vh / 180, sy_ = v.vv / 180; break;  // angle from d in units of 180 degrees
    case 'h': sx_ = 2 * std::sin(v.vh / 2 * degree), sy_ = 2 * std::sin(v.vv / 2 * degree); break;
    case 's': sx_ = 2 * std::tan(v.vh / 4 * degree), sy_ = 2 * std::tan(v.vv / 4 * degree); break;
    default: sx_ = v.vh * degree, sy_ = 2 * std::tan(v.vv / 2 * degree); break;  // c
    }
}

// The ray's D before normalisation (types v and c need its length for the clipping planes).
bool Projector::unnormalised(double X, double Y, Vec3& D) const {
    const double a = sx_ * (X - .5 + view_.vs), b = sy_ * (Y - .5 + view_.vl);
    const double q2 = a * a + b * b;
    switch (view_.type) {
    case 'v': D = d_ + h_ * a + u_ * b; return true;
    case 'l': D = d_; return true;
    case 'a': {
        const double q = std::sqrt(q2);
        if (q > 1) return false;
        const double k = q > 0 ? std::sin(base::pi * q) / q : base::pi;
        D = d_ * std::cos(base::pi * q) + h_ * (k * a) + u_ * (k * b);
        return true;
    }
    case 'h':
        if (q2 > 1) return false;
        D = d_ * std::sqrt(1 - q2) + h_ * a + u_ * b;
        return true;
    case 's': {
        const double z = (1 - q2) / (1 + q2);
        D = d_ * z + h_ * ((1 + z) * a) + u_ * ((1 + z) * b);
        return true;
    }
    default: D = d_ * std::cos(a) + h_ * std::sin(a) + u_ * b; return true;  // c
    }
}

std::optional<Vec3> Projector::direction(double X, double Y) const {
    Vec3 D;
    if (!unnormalised(X, Y, D)) return std::nullopt;
    return unit(D);
}

std::optional<Projector::Ray> Projector::ray(double X, double Y) const {
    Vec3 D;
    if (!unnormalised(X, Y, D)) return std::nullopt;
    const double len = length(D);
    Ray r;
    r.origin = view_.vp + D * view_.vo;
    if (view_.type == 'l') r.origin = r.origin + h_ * (sx_ * (X - .5 + view_.vs)) + u_ * (sy_ * (Y - .5 + view_.vl));
    r.dir = D * (1 / len);
    // Planes for v and c, spheres for the fisheyes (len = 1 there).
    r.tmax = view_.va > 0 ? (view_.va - view_.vo) * len : 0;
    return r;
}

bool Projector::plane_of(double a, double b, double& X, double& Y) const {
    X = a / sx_ + .5 - view_.vs;
    Y = b / sy_ + .5 - view_.vl;
    return true;
}

bool Projector::locate_direction(Vec3 dir, double& X, double& Y) const {
    const double z = dot(dir, d_), a = dot(dir, h_), b = dot(dir, u_);
    switch (view_.type) {
    case 'v': return z > 0 && plane_of(a / z, b / z, X, Y);
    case 'l': return false;
    case 'a': {
        const double s = base::hypot(a, b);  // sine of the angle from d
        if (s == 0 && z < 0) return false;   // straight behind: the whole rim
        const double k = s > 0 ? std::atan2(s, z) / base::pi / s : 0;
        return plane_of(a * k, b * k, X, Y);
    }
    case 'h': return z >= 0 && plane_of(a, b, X, Y);
    case 's': return z > -1 && plane_of(a / (1 + z), b / (1 + z), X, Y);
    default: {  // c
        const double s = base::hypot(z, a);
        return s > 0 && plane_of(std::atan2(a, z), b / s, X, Y);
    }
    }
}

// Signed area of a spherical triangle (Van Oosterom & Strackee 1983).  The triple product is taken of edges, not
// corners: their differences keep all digits when the pixel is small.
static double triangle(Vec3 a, Vec3 b, Vec3 c) {
    const double volume = dot(a, cross(b - a, c - a));
    return 2 * std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

double solid_angle_density(const Projector& p, double X, double Y) {
    const double h = 1e-4;
    const auto c = p.direction(X, Y);
    if (!c) return 0;
    const auto slope = [&](double dx, double dy) {
        const auto a = p.direction(X + dx, Y + dy), b = p.direction(X - dx, Y - dy);
        if (a && b) return (*a - *b) * (1 / (2 * h));
        if (a) return (*a - *c) * (1 / h);
        if (b) return (*c - *b) * (1 / h);
        return Vec3{};
    };
    return length(cross(slope(h, 0), slope(0, h)));
}

double pixel_solid_angle(const Projector& p, int i, int j, int nx, int ny) {
    if (p.view().type == 'l') return 0;
    Vec3 corner[4];
    for (int k = 0; k < 4; ++k) {
        const int right = k == 1 || k == 2, top = k >= 2;  // around the pixel
        const auto dir = p.direction((i + right) / double(nx), (j + top) / double(ny));
        if (!dir) return 0;
        corner[k] = *dir;
    }
    return std::fabs(triangle(corner[0], corner[1], corner[2]) + triangle(corner[0], corner[2], corner[3]));
}

}  // namespace view
