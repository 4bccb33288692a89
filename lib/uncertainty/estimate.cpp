// SPDX-License-Identifier: BSD-3-Clause
// See estimate.h.
#include "uncertainty/estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "uncertainty/student.h"

namespace uncertainty {
namespace {

// A standard error below this share of the value is the rounding of floats.
constexpr double rounding = 1e-6;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The T with g(T) = t: g is (1 + G T/3)^3 / G + (G/6 - 1/G).
double unskewed(double t, double skewness) {
    if (std::fabs(skewness) < 1e-9) return t;
    return 3 / skewness * (std::cbrt(1 + skewness * (t - skewness / 6)) - 1);
}

}  // namespace

bool Estimate::known() const {
    return error >= 0 && degrees > 0 && (error > rounding * std::fabs(value) || frames >= least_frames);
}

double Estimate::error_after(int64_t n) const {
    const double falls = error * error - lasting * lasting;
    return std::sqrt(lasting * lasting + std::max(0., falls) * double(frames) / double(n));
}

double Estimate::error_known_after(int64_t n) const {
    if (!known()) return nan;
    return error > rounding * std::fabs(value) ? error_after(n) : 0;
}

Interval Estimate::around(double alpha, int64_t n) const {
    if (!known()) return {nan, nan};
    if (!(error > rounding * std::fabs(value))) return {0, 0};
    const double scale = error_after(n), skew = skewness * scale / error, t = student_quantile(alpha, degrees);
    return {-scale * unskewed(t, skew), -scale * unskewed(-t, skew)};
}

}  // namespace uncertainty
