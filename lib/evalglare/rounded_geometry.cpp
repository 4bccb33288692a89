// SPDX-License-Identifier: BSD-3-Clause
// The roundings that decide on which side of a border evalglare puts a pixel (rounded_geometry.h).
#include "evalglare/rounded_geometry.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#ifdef LUX_HAVE_LIBMVEC
#include <emmintrin.h>

extern "C" {
__m128d _ZGVbN2v_sin(__m128d);
__m128d _ZGVbN2v_cos(__m128d);
}
#endif

namespace evalglare {
namespace {

using base::pi;

// Nearly unit vectors take one Newton step of 1/sqrt; others the root.
Vec3 normalised(Vec3 v) {
    const double square = v.x * v.x + (v.y * v.y + v.z * v.z);
    if (square == 0) return v;
    const double scale = std::fabs(square - 1) <= 1e-6 ? 2 - (0.5 + 0.5 * square) : 1 / std::sqrt(square);
    return {v.x * scale, v.y * scale, v.z * scale};
}

Vec3 sum(double a, Vec3 u, double b, Vec3 v, double c, Vec3 w) {
    return {a * u.x + (b * v.x + c * w.x), a * u.y + (b * v.y + c * w.y), a * u.z + (b * v.z + c * w.z)};
}

constexpr double rad = base::degree;

// pip's build of evalglare takes the sines and cosines of a view's half angles from glibc's vector library, which is
// one bit off now and then: at a right angle, say.
#ifdef LUX_HAVE_LIBMVEC
double sine(double angle) { return _mm_cvtsd_f64(_ZGVbN2v_sin(_mm_set1_pd(angle))); }
double cosine(double angle) { return _mm_cvtsd_f64(_ZGVbN2v_cos(_mm_set1_pd(angle))); }
#else
double sine(double angle) { return angle == 90 * rad ? std::nextafter(1.0, 0.0) : std::sin(angle); }
double cosine(double angle) { return std::cos(angle); }
#endif

double planispheric(double half_angle) { return 2 * sine(half_angle) / (1 + cosine(half_angle)); }

double dot_from_last(Vec3 a, Vec3 b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }

}  // namespace

double RoundedGeometry::sigma_cosine(Vec3 d) const { return dot_from_last(again_, d); }

bool RoundedGeometry::angle_undefined(Vec3 d) const { return sigma_cosine(d) > 1 || dot(again_, d) > 1; }

double RoundedGeometry::tau_cosine(Vec3 d, double sigma) const {
    const Vec3 beside = normalised(d * (1 / std::cos(sigma)) - again_);
    return dot(normalised(view_.vu), beside);
}

RoundedGeometry::RoundedGeometry(const view::View& v) : ViewGeometry(v), view_(v) {
    forward_ = normalised(v.vd);
    right_ = normalised(cross(forward_, normalised(v.vu)));
    up_ = cross(right_, forward_);
    again_ = normalised(forward_);
    sky_ = cross(cross(again_, v.vu), again_);
    switch (v.type) {
    case 'a': across_ = v.vh * (1.0 / 180), along_ = v.vv * (1.0 / 180); break;
    case 'h': across_ = 2 * sine(v.vh * 0.5 * rad), along_ = 2 * sine(v.vv * 0.5 * rad); break;
    case 's': across_ = planispheric(v.vh * 0.5 * rad), along_ = planispheric(v.vv * 0.5 * rad); break;
    case 'c': across_ = v.vh * rad, along_ = 2 * std::tan(v.vv * (0.5 * rad)); break;
    default: across_ = 2 * std::tan(v.vh * (0.5 * rad)), along_ = 2 * std::tan(v.vv * (0.5 * rad)); break;
    }
}

bool RoundedGeometry::to_direction(double X, double Y, Vec3 forward, Vec3& d) const {
    double x = (X - 0.5) + view_.vs, y = (Y - 0.5) + view_.vl;  // in the order of pip's build
    if (view_.type == 'a') {
        x *= across_, y *= along_;
        const double D = std::sqrt(x * x + y * y);
        if (D > 1) return false;
        const double z = std::cos(pi * D), factor = D <= 1e-6 ? pi : std::sqrt(1 - z * z) / D;
        d = sum(z, forward, x * factor, right_, y * factor, up_);
        return true;
    }
    if (view_.type == 's') {
        x *= across_, y *= along_;
        const double m = x * x + y * y, z = (1 - m) / (1 + m);
        d = sum(z, forward, x * (1 + z), right_, y * (1 + z), up_);
        return true;
    }
    const Vec3 h = right_ * across_, v = up_ * along_;
    switch (view_.type) {
    case 'h': {
        const double z2 = 1 - (x * x * (across_ * across_) + y * y * (along_ * along_));
        if (z2 < 0) return false;
        d = sum(std::sqrt(z2), forward, x, h, y, v);
        return true;
    }
    case 'c': {
        const Vec3 level = forward * std::cos(x * across_) + right_ * std::sin(x * across_);
        d = normalised(level + v * y);
        return true;
    }
    default: d = normalised(sum(1, forward, x, h, y, v)); return true;
    }
}

Vec3 RoundedGeometry::direction(double X, double Y) const {
    Vec3 d;
    return to_direction(X, Y, forward_, d) ? d : Vec3{};
}

Vec3 RoundedGeometry::seen_direction(double X, double Y) const {
    Vec3 d;
    return to_direction(X, Y, again_, d) ? d : Vec3{};
}

view::EyeAngles RoundedGeometry::eye_angles(Vec3 d, bool picture_up) const {
    view::EyeAngles a = ViewGeometry::eye_angles(d, picture_up);
    const double sigma = std::acos(sigma_cosine(d));
    a.sigma_deg = sigma * view::evalglare_deg;
    a.tau_deg = std::acos(tau_cosine(d, sigma)) * view::evalglare_deg;
    a.behind = false;
    a.elevation_deg = 90 - std::acos(std::clamp(dot(sky_, d), -1.0, 1.0)) * view::evalglare_deg;
    return a;
}

double RoundedGeometry::position_index(Vec3 d, view::PositionModel model) const {
    if (model == view::PositionModel::guth && angle_undefined(d)) return 16;
    return ViewGeometry::position_index(d, model);
}

std::vector<double> RoundedGeometry::solid_angles(int width, int height) const {
    std::vector<double> out(size_t(width) * height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) out[size_t(height - 1 - y) * width + x] = solid_angle(x, y, width, height);
    return out;
}

double RoundedGeometry::solid_angle(int x, int y, int width, int height) const {
    const double left = (x + 0.5) / width - 0.5 / width, right = left + 1.0 / width;
    const double low = (height - 1 - y + 0.5) / height - 0.5 / height, high = low + 1.0 / height;
    Vec3 corner[4], normal[4];
    if (!to_direction(left, low, forward_, corner[0]) || !to_direction(left, high, forward_, corner[1]) ||
        !to_direction(right, high, forward_, corner[2]) || !to_direction(right, low, forward_, corner[3]))
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

}  // namespace evalglare
