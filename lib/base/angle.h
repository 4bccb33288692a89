// SPDX-License-Identifier: BSD-3-Clause
// Pi, and a degree in radians.  Device code has its own in float (kernels/math/math.h), comfort evalglare's of fewer
// digits.
#pragma once

namespace base {

constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180;

}  // namespace base
