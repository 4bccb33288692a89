// SPDX-License-Identifier: BSD-3-Clause
// How the half-samples of a value differ (half_samples.h), in a byte each, so that a table can hand them over: in
// proportion alone, for the root of their mean square stands for the value's standard error.
#pragma once
#include <array>
#include <vector>

#include "uncertainty/half_samples.h"

namespace uncertainty {

constexpr int largest_code = 31;

using HalfCodes = std::array<int8_t, half_samples>;  // -31 to 31; all 0: they are alike

struct Halves {
    HalfCodes codes{};
    double strata = 0;  // degrees of freedom of what they say; 0: they are not known
};

// values: of each half-sample.  Their mean is taken off: it has the bias of their noise.
Halves halves_of(const std::vector<double>& values, double strata);

// By how many standard errors each half-sample is off.  Where they are alike the error is none of frames, and counts
// as the same in all values.
std::array<double, half_samples> off(const HalfCodes& codes);

}  // namespace uncertainty
