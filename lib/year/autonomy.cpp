// SPDX-License-Identifier: BSD-3-Clause
// See autonomy.h.
#include "year/autonomy.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "uncertainty/shared_counts.h"

namespace year {
namespace {

using uncertainty::half_samples;
using uncertainty::Images;
using uncertainty::Interval;

constexpr double rounding = 1e-9;

// A number of a sensor with its limits, and what it is in each half-sample.
struct Number {
    Bounded limits;
    Images images;
};

struct Numbers {
    Number autonomy;
    std::array<Number, usefulness_kinds> useful;
    Number sun_hours;
};

std::vector<uncertainty::Shared> hours_of(const Grid& grid, size_t sensor) {
    std::vector<uncertainty::Shared> hours;
    for (const GridHour& h : grid.hours) {
        const Lux& e = h.sensors[sensor];
        if (std::isnan(e.value)) continue;  // the weather file has no values of this hour
        hours.push_back({{double(e.value), double(e.error), 0, 0, h.degrees}, {}});
        if (grid.strata > 0 && !h.halves.empty()) hours.back().off = uncertainty::off(h.halves[sensor]);
    }
    return hours;
}

// Hours of a sensor from `from` on and below `to`, times `scale`.  Those with paths of their own are independent; those
// without values may be among them.
Number count(const Grid& grid, const std::vector<uncertainty::Shared>& hours, double from, double to, double alpha,
             double scale) {
    Number n;
    n.images = uncertainty::counts_within(hours, from, to);
    const Interval i = grid.shared ? uncertainty::count_within(hours, n.images, grid.strata, from, to, alpha)
                                   : uncertainty::count_within(uncertainty::apart(hours), from, to, alpha);
    const double missing = double(grid.hours.size() - hours.size());
    n.limits = {scale * n.images.whole, scale * i.low, scale * (i.high + missing)};
    n.images.whole *= scale;
    for (double& h : n.images.halves) h *= scale;
    return n;
}

Numbers judge_sensor(const Grid& grid, const Grid* direct, size_t sensor, const Goals& goals, double alpha) {
    Numbers y;
    const std::vector<uncertainty::Shared> hours = hours_of(grid, sensor);
    const double share = 1 / double(grid.hours.size());
    const auto& [low, middle, high] = goals.useful_lux;
    const double ends[usefulness_kinds + 1] = {-INFINITY, low, middle, high, INFINITY};
    y.autonomy = count(grid, hours, goals.autonomy_lux, INFINITY, alpha, share);
    for (size_t k = 0; k < usefulness_kinds; ++k) y.useful[k] = count(grid, hours, ends[k], ends[k + 1], alpha, share);
    if (direct) y.sun_hours = count(*direct, hours_of(*direct, sensor), goals.sun_lux, INFINITY, alpha, 1);
    return y;
}

// The mean over the sensors.
struct Mean {
    Number of;                  // limits: if all sensors err alike
    double down2 = 0, up2 = 0;  // squares of the distances of the limits if they err independently
};

template <class Select>
Mean mean(const std::vector<Numbers>& sensors, const Select& select) {
    Mean sum;
    const double share = 1 / double(sensors.size());
    for (const Numbers& s : sensors) {
        const Number n = select(s);
        const Bounded& b = n.limits;
        Bounded& limits = sum.of.limits;
        limits.value += share * b.value, limits.low += share * b.low, limits.high += share * b.high;
        sum.down2 += std::pow(share * (b.value - b.low), 2), sum.up2 += std::pow(share * (b.high - b.value), 2);
        sum.of.images.whole += share * n.images.whole;
        for (size_t k = 0; k < half_samples; ++k) sum.of.images.halves[k] += share * n.images.halves[k];
    }
    return sum;
}

// The limits by half-samples, not narrower than those of independent sensors and not wider than if all err alike;
// these where half-samples do not tell all (strata 0).
Bounded bounded(const Mean& m, double strata, double alpha) {
    const Bounded& outer = m.of.limits;
    if (!(strata > 0)) return outer;
    const Interval by_halves = uncertainty::limits_of(m.of.images, strata, alpha);
    const double low = std::min(by_halves.low, outer.value - std::sqrt(m.down2)),
                 high = std::max(by_halves.high, outer.value + std::sqrt(m.up2));
    return {outer.value, std::max(outer.low, low), std::min(outer.high, high)};
}

// 1 where a number is `least` or more.
Number reached(const Number& n, double least) {
    Number out;
    out.limits = {double(n.limits.value >= least), double(n.limits.low >= least), double(n.limits.high >= least)};
    out.images.whole = n.images.whole >= least;
    for (size_t k = 0; k < half_samples; ++k) out.images.halves[k] = n.images.halves[k] >= least;
    return out;
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
    std::vector<Numbers> sensors;
    for (size_t i = 0; i < grid.sensors(); ++i) {
        sensors.push_back(judge_sensor(grid, direct, i, goals, alpha));
        const Numbers& n = sensors.back();
        y.sensors.push_back({n.autonomy.limits, {}, n.sun_hours.limits});
        for (size_t k = 0; k < usefulness_kinds; ++k) y.sensors.back().useful[k] = n.useful[k].limits;
    }
    const auto over_sensors = [&](const Grid& of, const auto& number) {
        const bool is_whole =
            std::none_of(of.hours.begin(), of.hours.end(), [](const GridHour& h) { return is_missing(h); });
        return bounded(mean(sensors, number), is_whole ? of.strata : 0, alpha);
    };
    y.autonomy = over_sensors(grid, [](const Numbers& s) { return s.autonomy; });
    for (size_t k = 0; k < usefulness_kinds; ++k)
        y.useful[k] = over_sensors(grid, [k](const Numbers& s) { return s.useful[k]; });
    y.spatial =
        over_sensors(grid, [&](const Numbers& s) { return reached(s.autonomy, goals.autonomy_share - rounding); });
    y.exposed = over_sensors(direct ? *direct : grid,
                             [&](const Numbers& s) { return reached(s.sun_hours, goals.sun_hours + rounding); });
    return y;
}

}  // namespace year
