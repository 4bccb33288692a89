// SPDX-License-Identifier: BSD-3-Clause
// An estimate with what is known of its error, and the interval that follows.
//
// Student's t alone supposes that errors are as often positive as negative.  Of a skew mean G is known, the third
// moment of its error over the third power of the standard error; then
//     g(T) = T + G T^2/3 + G^2 T^3/27 + G/6
// is Student's to a higher order (P. Hall, On the removal of skewness by transformation, JRSS B 54, 1992), and its
// inverse gives limits that lie further off on the side of the samples that have not come yet.
#pragma once
#include <cstdint>

namespace comfort {

struct Interval {
    double low, high;
    double half_width() const { return (high - low) / 2; }
};

struct Estimate {
    double value = 0;     // without the bias of noise; nan if there is none
    double error = 0;     // standard error at `frames`; nan if there is none
    double degrees = 0;   // of freedom
    double skewness = 0;  // of the error
    bool tails = false;   // one part makes most of the error: the samples have heavy tails
    int64_t frames = 0;   // when it was worked out

    bool known() const;  // there is an error that may be believed: no spread at all may not
    // The interval that misses the truth with probability `outside`, after n frames, less the value: nan if unknown.
    Interval around(double outside, int64_t n) const;
    double half_width(double outside, int64_t n) const { return around(outside, n).half_width(); }
};

}  // namespace comfort
