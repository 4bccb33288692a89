// SPDX-License-Identifier: BSD-3-Clause
// When an estimate suffices to stop.
// A rule on widths never looks at the value, so that repeated looks cost little coverage (Chow and Robbins, Annals of
// Mathematical Statistics 36, 1965; Glynn and Whitt, Annals of Applied Probability 2, 1992, for simulations).
// A rule on the class depends on the value, and each look is a chance to be wrong: all looks have the same level, by
// which all of them together are wrong with probability alpha (Pocock, Biometrika 64, 1977).
#pragma once
#include <functional>

#include "uncertainty/estimate.h"

namespace uncertainty {

constexpr double alpha = 0.05;

bool narrow_enough(const Estimate& estimate, double half_width);

// All of an interval at Pocock's level lies in one class.
bool class_is_known(const Estimate& estimate, const std::function<int(double)>& class_of);

}  // namespace uncertainty
