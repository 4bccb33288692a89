// SPDX-License-Identifier: BSD-3-Clause
// An estimate, its standard error, and the interval that follows by Student's t.
// With skewness G, the third moment of the error over the third power of the standard error,
//     g(T) = T + G T^2/3 + G^2 T^3/27 + G/6
// is Student's t to a higher order, and the inverse of g gives limits that lie farther off on the side of rare samples
// (P. Hall, On the removal of skewness by transformation, JRSS B 54, 1992).
#pragma once
#include <cstdint>

namespace uncertainty {

constexpr int64_t least_frames = 16;  // one in each of the sixteen sums; no rule holds before

struct Interval {
    double low, high;
    double half_width() const { return (high - low) / 2; }
};

struct Estimate {
    double value = 0;         // bias taken off; nan: none
    double error = 0;         // standard error at `frames`; nan: none
    double degrees = 0;       // of freedom
    double skewness = 0;      // of the error
    bool unreliable = false;  // Cochran's C: one part makes most of the error, the samples have heavy tails
    int64_t frames = 0;       // at which it was estimated
    double lasting = 0;       // the part of the error that more frames do not lessen

    // Parts that are all alike have no error, which is believed from `least_frames` on.
    bool known() const;
    double error_after(int64_t n) const;        // frames
    double error_known_after(int64_t n) const;  // 0: of rounding alone; nan: not known
    // Limits less the value, after n frames; alpha: probability that they miss the truth.  nan if unknown.
    Interval around(double alpha, int64_t n) const;
    double half_width(double alpha, int64_t n) const { return around(alpha, n).half_width(); }
};

}  // namespace uncertainty
