// SPDX-License-Identifier: BSD-3-Clause
// Daylight provision of EN 17037 by illuminances: a target on half of the plane and a minimum on 95 % of it, in half of
// the daylight hours (docs/en17037.md has the sources).
#pragma once
#include <array>
#include <vector>

#include "year/daylight_hours.h"
#include "year/verdict.h"

namespace year {

constexpr int highest_level = 3;
const char* level_name(int level);  // 0 none, 1 minimum, 2 medium, 3 high

constexpr std::array<double, 4> provision_lux{100, 300, 500, 750};

// What a level asks: this illuminance on this share of the plane.
struct Demand {
    size_t lux;  // of provision_lux
    double share;
};
std::vector<Demand> demands(int level, bool rooflight);

// Shares of the daylight hours in which a sensor has provision_lux.
using DaylightShares = std::array<Bounded, provision_lux.size()>;

struct Provision {
    bool rooflight = false;        // horizontal openings: the target on 95 %, no minimum
    size_t hours = 0;              // daylight hours
    std::array<Bounded, 4> plane;  // share of the sensors that have provision_lux in half of them
    std::vector<DaylightShares> sensors;
    int level = 0, low = 0, high = 0;  // of the values, of the lower and of the upper limits
};

bool is_met(const Demand& demand, double share);

// alpha: probability that an interval misses.
Provision judge_provision(const Grid& grid, const DaylightHours& daylight, bool rooflight, double alpha);

}  // namespace year
