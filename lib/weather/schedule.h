// SPDX-License-Identifier: BSD-3-Clause
// Files that say which hours of a year are meant.
#pragma once
#include <string>
#include <vector>

#include "weather/weather.h"

namespace weather {

// Either hours by name or a value for each hour of the year.
struct Schedule {
    std::vector<int> minutes;  // Time::minute_of_year() of hours by name
    std::vector<bool> used;    // 366 * 24 hours of the clock
};

// Lines: the name of an hour, and anything behind it; one value, above 0 for hours that are used (8,760 or 8,784 of
// them); or Daysim's month,day,hour,value.  Blank lines, "#" and a first line of column names are passed over.
Schedule read_schedule(const std::string& path, const Weather& weather);

}  // namespace weather
