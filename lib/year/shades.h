// SPDX-License-Identifier: BSD-3-Clause
// Shades that are closed in the hours in which any view has a DGP above a limit while they are open.
#pragma once
#include <vector>

#include "year/verdict.h"

namespace year {

struct Shaded {
    std::vector<View> views;
    Bounded closed;  // hours
};

// closed: the same views with closed shades, in at least the hours in which they may be closed.  Where an interval
// holds the limit shades may be either, and the hour's interval holds both.  Throws Error (place: the view).
Shaded with_shades(std::vector<View> open, const std::vector<View>& closed, double limit);

}  // namespace year
