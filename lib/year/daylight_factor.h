// SPDX-License-Identifier: BSD-3-Clause
// Mean daylight factor of a grid: what its sensors have of the illuminance outdoors under an overcast sky, which has no
// hour; from vcmetrics' table of one picture of the points.
#pragma once
#include <string>
#include <vector>

#include "report/table.h"
#include "year/verdict.h"

namespace year {

struct DaylightFactor {
    std::string name;  // of the grid
    Bounded mean;      // a share
};

// outdoor_lux: horizontal illuminance of the unobstructed sky.  Throws Error (place: the file) where it is no table of
// sensors.
std::vector<DaylightFactor> daylight_factors(const std::string& path, double outdoor_lux, double alpha);

std::string line_of(const DaylightFactor& factor, double outdoor_lux);
void add(report::Line& line, const DaylightFactor& factor);

}  // namespace year
