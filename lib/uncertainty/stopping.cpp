// SPDX-License-Identifier: BSD-3-Clause
// See stopping.h.
#include "uncertainty/stopping.h"

#include <cmath>

namespace uncertainty {
namespace {

// Two-sided level of one look.
constexpr double level_of_a_look = 0.01;

}  // namespace

bool narrow_enough(const Estimate& e, double half_width) {
    return !e.unreliable && e.half_width(alpha, e.frames) <= half_width;  // a nan is not
}

bool class_is_known(const Estimate& e, const std::function<int(double)>& class_of) {
    const Interval off = e.around(level_of_a_look, e.frames);
    return std::isfinite(off.half_width()) && class_of(e.value + off.low) == class_of(e.value + off.high);
}

}  // namespace uncertainty
