// SPDX-License-Identifier: BSD-3-Clause
// See autonomy.h.
#include "year/autonomy.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace year {
namespace {

constexpr double rounding = 1e-9, any_lux = 1e9;

// Hours of a sensor from `from` on and below `to`, times `scale`.
Between count(const std::vector<uncertainty::Uncertain>& hours, double from, double to, double alpha, double scale) {
    const auto is = [&](const uncertainty::Uncertain& u) { return u.value >= from && u.value < to; };
    const uncertainty::Interval n = uncertainty::count_within(hours, from, to, alpha);
    return {scale * double(std::count_if(hours.begin(), hours.end(), is)), scale * n.low, scale * n.high};
}

std::vector<uncertainty::Uncertain> hours_of(const Grid& grid, size_t sensor) {
    std::vector<uncertainty::Uncertain> hours;
    for (const GridHour& h : grid.hours) {
        const Lux& e = h.sensors[sensor];
        if (std::isnan(e.value)) hours.push_back({0, 0, any_lux});
        else hours.push_back({double(e.value), double(e.error), 0, 0, double(e.degrees)});
    }
    return hours;
}

SensorYear judge_sensor(const Grid& grid, const Grid* direct, size_t sensor, const Goals& goals, double alpha) {
    SensorYear y;
    const std::vector<uncertainty::Uncertain> hours = hours_of(grid, sensor);
    const double share = 1 / double(hours.size());
    const auto& [low, middle, high] = goals.useful_lux;
    const double ends[usefulness_kinds + 1] = {-INFINITY, low, middle, high, INFINITY};
    y.autonomy = count(hours, goals.autonomy_lux, INFINITY, alpha, share);
    for (size_t k = 0; k < usefulness_kinds; ++k) y.useful[k] = count(hours, ends[k], ends[k + 1], alpha, share);
    if (direct) y.sun_hours = count(hours_of(*direct, sensor), goals.sun_lux, INFINITY, alpha, 1);
    return y;
}

// The mean of `of` over the sensors, at their values and limits.
template <class Of>
Between mean(const std::vector<SensorYear>& sensors, const Of& of) {
    Between sum;
    for (const SensorYear& s : sensors) {
        const Between b = of(s);
        sum.value += b.value, sum.low += b.low, sum.high += b.high;
    }
    const double n = double(sensors.size());
    return {sum.value / n, sum.low / n, sum.high / n};
}

// 1 where a number is `least` or more.
Between reached(const Between& b, double least) {
    return {double(b.value >= least), double(b.low >= least), double(b.high >= least)};
}

}  // namespace

GridYear judge(const Grid& grid, const Grid* direct, const Goals& goals, double alpha) {
    if (direct && direct->sensors() != grid.sensors())
        base::fail("-direct", "has other sensors in " + grid.name + " than the table");
    GridYear y;
    y.name = grid.name;
    y.hours = grid.hours.size();
    for (const GridHour& h : grid.hours) y.dark += is_dark(h), y.missing += is_missing(h);
    if (direct) y.sun_hours = direct->hours.size();
    for (size_t i = 0; i < grid.sensors(); ++i) y.sensors.push_back(judge_sensor(grid, direct, i, goals, alpha));
    y.autonomy = mean(y.sensors, [](const SensorYear& s) { return s.autonomy; });
    for (size_t k = 0; k < usefulness_kinds; ++k)
        y.useful[k] = mean(y.sensors, [k](const SensorYear& s) { return s.useful[k]; });
    y.spatial =
        mean(y.sensors, [&](const SensorYear& s) { return reached(s.autonomy, goals.autonomy_share - rounding); });
    y.exposed = mean(y.sensors, [&](const SensorYear& s) { return reached(s.sun_hours, goals.sun_hours + rounding); });
    return y;
}

}  // namespace year
