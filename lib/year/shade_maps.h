// SPDX-License-Identifier: BSD-3-Clause
// Days by hours of shades that move: a map for each group, the darker the more closed; hours in doubt are hatched.
#pragma once
#include "display/canvas.h"
#include "year/shade_control.h"

namespace year {

// Below what the canvas has; each hour says its state and the rule that closes shades.
void add_shade_maps(display::Canvas& canvas, const ShadeYear& year);

}  // namespace year
