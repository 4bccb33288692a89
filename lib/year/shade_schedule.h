// SPDX-License-Identifier: BSD-3-Clause
// A file that says which state shades have in which hour.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "weather/date.h"

namespace year {

struct ShadeSchedule {
    std::map<int, std::string> states;  // by Time::minute_of_year(), of hours by their names
    std::vector<size_t> numbers;        // of each hour of the clock in a leap year: 0 is the most open state; or empty
};

// Lines: an hour's name, the group, the state; without a group: of all; what `vcyear -moves` writes.  Or a number for
// each hour, 8,760 or 8,784 of them, as Honeybee's dynamic schedules have them, also as .json; or Daysim's
// month,day,hour,number. Throws Error (place: the line).
ShadeSchedule read_shade_schedule(const std::string& path, const std::string& group);

// Its number among the states of the group, from the most open on; 0 where the schedule does not name the hour.
size_t state_at(const ShadeSchedule& schedule, const weather::Time& time, const std::vector<std::string>& states,
                const std::string& place);

}  // namespace year
