// SPDX-License-Identifier: BSD-3-Clause
// The results of a year of hours for the sensors of a grid, with the intervals of sensor_counts.h.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "year/verdict.h"

namespace year {

// sDA and ASE after IES LM-83-12, Approved Method: IES Spatial Daylight Autonomy (sDA) and Annual Sunlight Exposure
// (ASE); UDI after J. Mardaljevic et al., Daylighting metrics: is there a relation between useful daylight illuminance
// and daylight glare probability?, Proceedings of BSO12, 2012.
// cDA and DAmax after Z. Rogers, in C. Reinhart, J. Mardaljevic and Z. Rogers, Dynamic daylight performance metrics for
// sustainable building design, Leukos 3, 2006.
constexpr double excess_factor = 10;  // of autonomy_lux

struct Goals {
    double autonomy_lux = 300, autonomy_share = .5;
    std::array<double, 3> useful_lux{100, 300, 3000};  // rising
    double sun_lux = 1000, sun_hours = 250;
};

enum Usefulness { below, supplementary, autonomous, exceeded };
constexpr size_t usefulness_kinds = 4;
using Useful = std::array<Bounded, usefulness_kinds>;

struct SensorYear {
    Bounded autonomy;   // share of the hours with autonomy_lux or more
    Bounded credited;   // cDA: the same, hours of less light by what they have of it
    Bounded excessive;  // DAmax: with excess_factor times as much or more
    Useful useful;      // shares of the hours
    Bounded sun_hours;  // hours with sun_lux or more of direct sun
};

struct GridYear {
    std::string name;
    std::vector<SensorYear> sensors;
    size_t hours = 0, dark = 0, missing = 0, to_come = 0;
    std::optional<size_t> sun_hours;        // of the run with direct sun alone
    Bounded autonomy, credited, excessive;  // means over the sensors
    Useful useful;
    Bounded spatial;  // sDA: share of the sensors whose autonomy is autonomy_share or more
    Bounded exposed;  // ASE: share of the sensors with more than sun_hours of direct sun
};

// direct: the same sensors under direct sun alone; null: not known.  alpha: probability that an interval misses.
GridYear judge(const Grid& grid, const Grid* direct, const Goals& goals, double alpha);

}  // namespace year
