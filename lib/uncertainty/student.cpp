// SPDX-License-Identifier: BSD-3-Clause
// P(|T| > t) = I_x(d/2, 1/2) with x = d/(d + t^2), the incomplete beta function by its continued fraction
// (Abramowitz and Stegun 26.5.8, 26.7.1).
#include "uncertainty/student.h"

#include <array>
#include <cmath>
#include <limits>

namespace uncertainty {
namespace {

// The fraction converges for x < (a+1)/(a+b+2); Lentz's method.
double beta_fraction(double a, double b, double x) {
    constexpr double tiny = 1e-300;
    const auto apart = [](double v) { return std::fabs(v) < tiny ? tiny : v; };
    double c = 1, d = 1 / apart(1 - (a + b) * x / (a + 1)), value = d;
    for (int m = 1; m < 500; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 / apart(1 + even * d), c = apart(1 + even / c), value *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / apart(1 + odd * d), c = apart(1 + odd / c), value *= d * c;
        if (std::fabs(d * c - 1) < 1e-15) break;
    }
    return value;
}

double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    return x < (a + 1) / (a + b + 2) ? front * beta_fraction(a, b, x) / a : 1 - front * beta_fraction(b, a, 1 - x) / b;
}

}  // namespace

double student_outside(double t, double degrees) {
    return incomplete_beta(degrees / 2, 0.5, degrees / (degrees + t * t));
}

double student_quantile(double outside, double degrees) {
    if (!(degrees > 0)) return std::numeric_limits<double>::infinity();
    struct Known {
        double outside = 0, degrees = 0, quantile = 0;
    };
    static thread_local std::array<Known, 8> all;  // columns and lines ask for the same few again and again
    static thread_local size_t oldest = 0;
    for (const Known& k : all)
        if (k.outside == outside && k.degrees == degrees) return k.quantile;
    double low = 0, high = 1;
    while (student_outside(high, degrees) > outside && high < 1e12) high *= 2;
    for (double middle = 0.5 * high; low < middle && middle < high; middle = (low + high) / 2)
        (student_outside(middle, degrees) > outside ? low : high) = middle;
    Known& known = all[oldest++ % all.size()];
    known = {outside, degrees, (low + high) / 2};
    return known.quantile;
}

double normal_of_student(double t, double degrees) {
    if (std::isinf(degrees)) return t;
    const double scale = (8 * degrees + 1) / (8 * degrees + 3);
    return std::copysign(scale * std::sqrt(degrees * std::log1p(t * t / degrees)), t);
}

double student_of_normal(double z, double degrees) {
    if (std::isinf(degrees)) return z;
    const double scaled = z * (8 * degrees + 3) / (8 * degrees + 1);
    return std::copysign(std::sqrt(degrees * std::expm1(scaled * scaled / degrees)), z);
}

}  // namespace uncertainty
