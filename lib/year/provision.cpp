// SPDX-License-Identifier: BSD-3-Clause
// See provision.h.
#include "year/provision.h"

#include <algorithm>
#include <cmath>

#include "year/sensor_counts.h"

namespace year {
namespace {

// The highest level whose demands these shares of the plane meet: a level's are harder than those of the one below.
template <class Share>
int level_of(bool rooflight, const Share& share) {
    int level = 0;
    while (level < highest_level) {
        const std::vector<Demand> next = demands(level + 1, rooflight);
        const auto met = [&](const Demand& d) { return is_met(d, share(d.lux)); };
        if (!std::all_of(next.begin(), next.end(), met)) break;
        ++level;
    }
    return level;
}

}  // namespace

const char* level_name(int level) {
    const char* const names[highest_level + 1] = {"none", "minimum", "medium", "high"};
    return names[level];
}

std::vector<Demand> demands(int level, bool rooflight) {
    constexpr double half = .5, nearly_all = .95;
    const size_t target = size_t(level);
    if (rooflight) return {{target, nearly_all}};
    return {{target, half}, {target - 1, nearly_all}};
}

bool is_met(const Demand& demand, double share) { return share >= demand.share - count_rounding; }

Provision judge_provision(const Grid& grid, const DaylightHours& daylight, bool rooflight, double alpha) {
    const std::vector<size_t> hours = hours_in(daylight, grid);
    const double strata = strata_over(grid, hours);
    const double share = 1 / double(daylight.hours);
    std::array<std::vector<Number>, provision_lux.size()> has;
    Provision p;
    p.rooflight = rooflight;
    p.hours = daylight.hours;
    for (size_t i = 0; i < grid.sensors(); ++i) {
        const SensorHours of = hours_of(grid, hours, i);
        DaylightShares& sensor = p.sensors.emplace_back();
        for (size_t k = 0; k < has.size(); ++k) {
            const Number n = count(of, provision_lux[k], INFINITY, alpha, share);
            sensor[k] = n.limits;
            has[k].push_back(reached(n, .5 - count_rounding));
        }
    }
    for (size_t k = 0; k < has.size(); ++k) p.plane[k] = mean(has[k], strata, alpha);
    p.level = level_of(rooflight, [&](size_t k) { return p.plane[k].value; });
    p.low = level_of(rooflight, [&](size_t k) { return p.plane[k].low; });
    p.high = level_of(rooflight, [&](size_t k) { return p.plane[k].high; });
    return p;
}

}  // namespace year
