// SPDX-License-Identifier: BSD-3-Clause
// Exposure to sunlight of EN 17037: how long a cloudless day's sun reaches an opening, counted in steps of a few
// minutes from a table of direct sun at points of it (docs/en17037.md has the sources).
#pragma once
#include <array>
#include <vector>

#include "weather/weather.h"
#include "year/verdict.h"

namespace year {

constexpr std::array<double, 3> sunlight_hours{1.5, 3, 4};  // minimum, medium, high

struct Sunlight {
    weather::Date date;
    Bounded hours;    // steps in which a part of the sun may or may not be hidden widen it
    size_t days = 0;  // of which this date has most
    double step_min = 0, lowest_deg = 0;
    int low = 0, high = 0;  // levels (level_name) of the limits
};

// Of a room whose openings have these points: the sun at any of them counts.  day: the weather file of the table, whose
// steps say where the sun stands; lowest_deg: height below which it does not count.  Throws Error (place: the grid, or
// the file) for days outside 1 February to 21 March, steps above five minutes, and days that are not whole.
Sunlight judge_sunlight(const Grid& grid, const std::vector<size_t>& points, const weather::Weather& day,
                        double lowest_deg);

}  // namespace year
