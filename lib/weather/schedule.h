// SPDX-License-Identifier: BSD-3-Clause
// Files that say which hours of a year are meant.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "weather/weather.h"

namespace weather {

// Either hours of the weather or a value for each hour of the clock.
struct Schedule {
    std::vector<int> minutes;  // Time::minute_of_year() of hours
    bool by_name = false;      // which are names in the file
    std::vector<bool> used;    // 366 * 24 hours of the clock
};

// Lines: the name of an hour, and anything behind it; hours of the year, each larger than the one before, which stand
// for the hour in which they lie (Honeybee's sun-up-hours.txt); one value for each hour (8,760 or 8,784 of them); or
// Daysim's month,day,hour,value.  An hour counts from this value on: used_from, else .1 as Honeybee has it, and with
// Daysim anything above 0.  Blank lines, "#" and a first line of column names are passed over.
Schedule read_schedule(const std::string& path, const Weather& weather, std::optional<double> used_from);

}  // namespace weather
