// SPDX-License-Identifier: BSD-3-Clause
// The heat map of a year: days from the left to the right, hours from the top down, the colour by DGP; hours whose
// interval holds a limit are hatched.  Where only some days have hours a column is as wide as they are apart.
#pragma once
#include <string>
#include <vector>

#include "year/verdict.h"

namespace year {

// One map below the other; the ending of the name says whether it is .svg or .png.
void write_plot(const std::string& path, const std::vector<View>& views, double alpha);

}  // namespace year
