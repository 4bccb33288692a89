// SPDX-License-Identifier: BSD-3-Clause
// sqrt(a^2 + b^2) to .501 units in the last place, without overflow or underflow on the way.  The C library's differs
// in the last bit from one version and processor to the next, and as of glibc 2.35 is a symbol of its own.
#pragma once
#include <cmath>
#include <utility>

namespace base {

// What x * x, rounded to `square`, leaves out: the halves of x have products without an error (Dekker 1971).
inline double square_error(double x, double square) {
    const double far = 134217729 * x, high = far - (far - x), low = x - high;  // 2^27 + 1
    return ((high * high - square) + 2 * high * low) + low * low;
}

inline double hypot(double a, double b) {
    if (std::isinf(a) || std::isinf(b)) return INFINITY;
    a = std::fabs(a), b = std::fabs(b);
    if (a < b) std::swap(a, b);
    if (!(b > 0)) return a + b;  // also NaN
    if (a > 0x1p500) return hypot(a * 0x1p-600, b * 0x1p-600) * 0x1p600;
    if (a < 0x1p-400) return hypot(a * 0x1p600, b * 0x1p600) * 0x1p-600;
    const double aa = a * a, bb = b * b, h = std::sqrt(aa + bb), hh = h * h;
    const double left =
        ((aa - hh) + bb) + ((square_error(a, aa) - square_error(h, hh)) + square_error(b, bb));  // a^2 + b^2 - h^2
    return h + left / (2 * h);
}

}  // namespace base
