// SPDX-License-Identifier: BSD-3-Clause
// The roundings that decide on which side of a border evalglare puts a pixel (evalglare_geometry.h).
#include "comfort/evalglare_geometry.h"
#include "base/angle.h"
#include <cmath>

namespace comfort {
namespace {

using base::pi;

// Nearly unit vectors take one Newton step of 1/sqrt; others the root.
Vec3 normalised(Vec3 v) {
    const double square = v.x * v.x + (v.y * v.y + v.z * v.z);
    if (square == 0) return v;
    const double scale = std::fabs(square - 1) <= 1e-6 ? 1.5 - 0.5 * square : 1 / std::sqrt(square);
    return {v.x * scale, v.y * scale, v.z * scale};
}

Vec3 sum(double a, Vec3 u, double b, Vec3 v, double c, Vec3 w) {
    return {a * u.x + (b * v.x + c * w.x), a * u.y + (b * v.y + c * w.y), a * u.z + (b * v.z + c * w.z)};
}

constexpr double rad = base::degree;

// evalglare's sine of a right angle comes from its compiler's vector library, one bit below 1.
double half_sine(double angle_deg) {
    return angle_deg == 180 ? std::nextafter(1.0, 0.0) : std::sin(angle_deg * 0.5 * rad);
}
double planispheric(double angle_deg) { return 2 * half_sine(angle_deg) / (1 + std::cos(angle_deg * 0.5 * rad)); }

}  // namespace

EvalglareRays::EvalglareRays(const view::View& v) : view_(v) {
    forward_ = normalised(v.vd);
    right_ = normalised(cross(forward_, normalised(v.vu)));
    up_ = cross(right_, forward_);
    switch (v.type) {
    case 'a': across_ = v.vh * (1.0 / 180), along_ = v.vv * (1.0 / 180); break;
    case 'h': across_ = 2 * half_sine(v.vh), along_ = 2 * half_sine(v.vv); break;
    case 's': across_ = planispheric(v.vh), along_ = planispheric(v.vv); break;
    case 'c': across_ = v.vh * rad, along_ = 2 * std::tan(v.vv * (0.5 * rad)); break;
    default: across_ = 2 * std::tan(v.vh * (0.5 * rad)), along_ = 2 * std::tan(v.vv * (0.5 * rad)); break;
    }
}

bool EvalglareRays::direction(double X, double Y, Vec3& d) const {
    double x = X + (view_.vs - 0.5), y = Y + (view_.vl - 0.5);
    if (view_.type == 'a') {
        x *= across_, y *= along_;
        const double D = std::sqrt(x * x + y * y);
        if (D > 1) return false;
        const double z = std::cos(pi * D), factor = D <= 1e-6 ? pi : std::sqrt(1 - z * z) / D;
        d = sum(z, forward_, x * factor, right_, y * factor, up_);
        return true;
    }
    if (view_.type == 's') {
        x *= across_, y *= along_;
        const double m = x * x + y * y, z = (1 - m) / (1 + m);
        d = sum(z, forward_, x * (1 + z), right_, y * (1 + z), up_);
        return true;
    }
    const Vec3 h = right_ * across_, v = up_ * along_;
    switch (view_.type) {
    case 'h': {
        const double z2 = 1 - (x * x * (across_ * across_) + y * y * (along_ * along_));
        if (z2 < 0) return false;
        d = sum(std::sqrt(z2), forward_, x, h, y, v);
        return true;
    }
    case 'c': {
        const Vec3 level = forward_ * std::cos(x * across_) + right_ * std::sin(x * across_);
        d = normalised(level + v * y);
        return true;
    }
    default: d = normalised(sum(1, forward_, x, h, y, v)); return true;
    }
}

double EvalglareRays::omega(int x, int y, int width, int height) const {
    const double left = (x + 0.5) / width - 0.5 / width, right = left + 1.0 / width;
    const double low = (height - 1 - y + 0.5) / height - 0.5 / height, high = low + 1.0 / height;
    Vec3 corner[4], normal[4];
    if (!direction(left, low, corner[0]) || !direction(left, high, corner[1]) || !direction(right, high, corner[2]) ||
        !direction(right, low, corner[3]))
        return 0;
    for (int k = 0; k < 4; ++k) {
        normal[k] = normalised(cross(corner[k], corner[(k + 1) % 4] - corner[k]));
        if (dot(normal[k], normal[k]) == 0) return 0;
    }
    double angle[4];
    for (int k = 0; k < 4; ++k) angle[k] = std::acos(dot(normal[k], normal[(k + 1) % 4]));
    const double total = 4 * pi - (angle[0] + angle[1]) - (angle[2] + angle[3]) - 2 * pi;
    return total >= 0 && total <= 2 * pi ? total : 0;
}

}  // namespace comfort
