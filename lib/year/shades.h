// SPDX-License-Identifier: BSD-3-Clause
// The year of views and sensors whose shades move: each hour as it is in the state that shades have then.  Where that
// is in doubt an hour may be as in any state that they may have: a view's interval holds all of them, sensors keep the
// hours side by side (GridHour::instead).
#pragma once
#include <string>
#include <vector>

#include "year/shade_control.h"

namespace year {

std::vector<View> with_shades(std::vector<View> open, const ShadeStates& states, const ShadeYear& year);
std::vector<Grid> with_shades(std::vector<Grid> open, const ShadeStates& states, const ShadeYear& year);

}  // namespace year
