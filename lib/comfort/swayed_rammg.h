// SPDX-License-Identifier: BSD-3-Clause
// RAMMG of swayed pictures, all in one walk down the rows.
#pragma once
#include <array>
#include <functional>
#include "comfort/rammg.h"
#include "comfort/swayed.h"

namespace comfort {

// As rammg() of each picture, but for the last bits of its sums.  Not for areas without the frame (interior,
// prototype_scale).  before_row: called with each row before it is looked at.
std::array<double, Signs::most> rammg(
    const Swayed& pictures, const Geometry& geometry, RammgArea area,
    const std::function<void(int)>& before_row = [](int) {});

}  // namespace comfort
