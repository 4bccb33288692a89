// SPDX-License-Identifier: BSD-3-Clause
// The daylight hours of EN 17037: the half of a year's hours that has the most diffuse horizontal irradiance, as the
// weather file has it (docs/en17037.md).
#pragma once
#include <string>
#include <vector>

#include "weather/weather.h"
#include "year/table.h"

namespace year {

struct DaylightHours {
    std::string path;                 // of the weather file
    size_t hours = 0;                 // half of the year's: 4380
    std::vector<weather::Time> lit;   // those of them that are not dark, by time
    std::vector<weather::Time> dark;  // the others: 0 lx everywhere
    std::vector<int> unlit = {};      // minutes of the year of all hours for which the file has no light, rising
};

// Of hours that are alike the earlier ones.  Throws Error (place: the file, or the line) where the file has no whole
// year, or an hour by day no diffuse irradiance.
DaylightHours daylight_hours(const weather::Weather& year);

// Their indices in grid.hours; dark ones need not be there.  Throws Error (place: the grid) where others are missing,
// or where the table has light and the file has none.
std::vector<size_t> hours_in(const DaylightHours& daylight, const Grid& grid);

}  // namespace year
