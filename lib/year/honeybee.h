// SPDX-License-Identifier: BSD-3-Clause
// The folder of results that honeybee-radiance-postprocess and honeybee-radiance read: a row for each view or sensor, a
// column for each hour that is not dark.
#pragma once
#include <string>
#include <vector>

#include "year/table.h"

namespace year {

// Write grids_info.json, sun-up-hours.txt and schedule.txt (8,760 lines, 1: an hour of the table), and make the folder
// if it is not there.  Throw Error where the views, or the grids, do not have the same hours.

// views.dgp.
void write_honeybee(const std::string& folder, const std::vector<View>& views);
// GRID.ill and __static_apertures__/default/total/GRID.npy; direct/GRID.npy beside it unless `direct` is empty,
// which has the grids in the same order.
void write_honeybee(const std::string& folder, const std::vector<Grid>& grids, const std::vector<Grid>& direct);

}  // namespace year
