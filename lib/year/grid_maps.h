// SPDX-License-Identifier: BSD-3-Clause
// Maps of a year of sensors: daylight autonomy, useful illuminance, hours of direct sun.
#pragma once
#include <string>
#include <vector>

#include "year/autonomy.h"

namespace year {

// points: files of the grids, in any order, or a folder of them.  A sensor whose interval holds the limit is hatched.
// The ending of the name says whether it is .svg or .png.  Throws Error (place: the file) for points of other grids.
void write_maps(const std::string& path, const std::vector<GridYear>& years, const std::vector<std::string>& points,
                const Goals& goals);

}  // namespace year
