// SPDX-License-Identifier: BSD-3-Clause
// The folder of results that honeybee-radiance-postprocess and honeybee-radiance read: a row for each view, a column
// for each hour that is not dark.
#pragma once
#include <string>
#include <vector>

#include "year/table.h"

namespace year {

// Writes views.dgp, sun-up-hours.txt and grids_info.json; makes the folder if it is not there.  Throws Error where the
// views do not have the same hours.
void write_honeybee(const std::string& folder, const std::vector<View>& views);

}  // namespace year
