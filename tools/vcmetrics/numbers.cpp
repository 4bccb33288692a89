// SPDX-License-Identifier: BSD-3-Clause
// See numbers.h.
#include "numbers.h"

#include <cmath>
#include <limits>

#include "glare/formulas.h"

using namespace glare;

// The interval lies around the value without bias, which the column itself may show or not.  Between looks this is
// the last look's value and interval; a value that has no bias is the present frame's, and its interval narrows as
// frames grow.
Number number_of(const Options& o, const Column& c, const uncertainty::Estimate& e, double value, int64_t frame) {
    const bool shows_estimate = c.printed_unbiased && !(c.of_filled && std::isnan(e.value));
    Number out{shows_estimate ? e.value : value, 0, {std::nan(""), std::nan("")}, {std::nan(""), 0}};
    out.middle = c.has_bias() ? e.value : out.value;
    const int64_t n = c.has_bias() ? e.frames : frame;
    if (o.ci) out.off = e.around(1 - *o.ci, n), out.error = {e.error_known_after(n), e.degrees};
    return out;
}

Number difference_of(const Options& o, const uncertainty::Estimate& d) {
    return {d.value, d.value, d.around(1 - o.ci.value_or(.95), d.frames), {d.error_known_after(d.frames), d.degrees}};
}

Number unknown_number(const Column& c) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Number n{c.words ? double(dgp_class(nan)) : nan, nan, {nan, nan}, {}};
    n.error.error = nan;
    return n;
}
