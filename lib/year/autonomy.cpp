// SPDX-License-Identifier: BSD-3-Clause
// See autonomy.h.
#include "year/autonomy.h"

#include <cmath>

#include "base/error.h"
#include "year/sensor_counts.h"

namespace year {
namespace {

struct Numbers {
    Number autonomy, credited, excessive;
    std::array<Number, usefulness_kinds> useful;
    Number sun_hours;
};

Numbers judge_sensor(const SensorHours& hours, const SensorHours* direct, const Goals& goals, double alpha) {
    Numbers y;
    const double share = 1 / double(hours.known.size() + hours.missing);
    const auto& [low, middle, high] = goals.useful_lux;
    const double ends[usefulness_kinds + 1] = {-INFINITY, low, middle, high, INFINITY};
    y.autonomy = count(hours, goals.autonomy_lux, INFINITY, alpha, share);
    y.credited = credit(hours, goals.autonomy_lux, alpha, share);
    y.excessive = count(hours, excess_factor * goals.autonomy_lux, INFINITY, alpha, share);
    for (size_t k = 0; k < usefulness_kinds; ++k) y.useful[k] = count(hours, ends[k], ends[k + 1], alpha, share);
    if (direct) y.sun_hours = count(*direct, goals.sun_lux, INFINITY, alpha, 1);
    return y;
}

}  // namespace

GridYear judge(const Grid& grid, const Grid* direct, const Goals& goals, double alpha) {
    if (direct && direct->sensors() != grid.sensors())
        base::fail("-direct", "has other sensors in " + grid.name + " than the table");
    GridYear y;
    y.name = grid.name;
    y.hours = grid.hours.size();
    y.to_come = grid.to_come;
    for (const GridHour& h : grid.hours) y.dark += is_dark(h), y.missing += is_missing(h);
    if (direct) y.sun_hours = direct->hours.size();
    const std::vector<size_t> hours = all_hours(grid), sun_hours = all_hours(direct ? *direct : grid);
    std::vector<Numbers> sensors;
    for (size_t i = 0; i < grid.sensors(); ++i) {
        const SensorHours sun = direct ? hours_of(*direct, sun_hours, i) : SensorHours{};
        sensors.push_back(judge_sensor(hours_of(grid, hours, i), direct ? &sun : nullptr, goals, alpha));
        const Numbers& n = sensors.back();
        y.sensors.push_back({n.autonomy.limits, n.credited.limits, n.excessive.limits, {}, n.sun_hours.limits});
        for (size_t k = 0; k < usefulness_kinds; ++k) y.sensors.back().useful[k] = n.useful[k].limits;
    }
    const auto over_sensors = [&](double strata, const auto& number) {
        std::vector<Number> numbers;
        for (const Numbers& s : sensors) numbers.push_back(number(s));
        return mean(numbers, strata, alpha);
    };
    const double strata = strata_over(grid, hours);
    y.autonomy = over_sensors(strata, [](const Numbers& s) { return s.autonomy; });
    y.credited = over_sensors(strata, [](const Numbers& s) { return s.credited; });
    y.excessive = over_sensors(strata, [](const Numbers& s) { return s.excessive; });
    for (size_t k = 0; k < usefulness_kinds; ++k)
        y.useful[k] = over_sensors(strata, [k](const Numbers& s) { return s.useful[k]; });
    y.spatial = over_sensors(
        strata, [&](const Numbers& s) { return reached(s.autonomy, goals.autonomy_share - count_rounding); });
    y.exposed = over_sensors(strata_over(direct ? *direct : grid, sun_hours),
                             [&](const Numbers& s) { return reached(s.sun_hours, goals.sun_hours + count_rounding); });
    return y;
}

}  // namespace year
