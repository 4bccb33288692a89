// SPDX-License-Identifier: BSD-3-Clause
// See daylight_factor.h.
#include "year/daylight_factor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "year/sensor_counts.h"
#include "year/table_row.h"

namespace year {
namespace {

Number factor_of(const SensorHours& sky, double outdoor_lux, double alpha) {
    const uncertainty::Shared& e = sky.known.front();
    const double half = e.of.error > 0 ? e.of.error * errors_of(alpha, e.of.degrees) : 0;
    Number n{{e.of.value, std::max(e.of.value - half, 0.), e.of.value + half}, {}};
    n.images.whole = e.of.value / outdoor_lux;
    for (size_t k = 0; k < uncertainty::half_samples; ++k) n.images.halves[k] = e.half(k) / outdoor_lux;
    n.limits = {n.limits.value / outdoor_lux, n.limits.low / outdoor_lux, n.limits.high / outdoor_lux};
    return n;
}

}  // namespace

std::vector<DaylightFactor> daylight_factors(const std::string& path, double outdoor_lux, double alpha) {
    std::vector<Grid> grids;
    std::optional<Columns> c;
    const auto add = [&](const report::NumberTable& t, const report::NumberRow& row) {
        if (!c) c.emplace(t, Columns::Of::one_sky);
        const std::string& name = row.labels[*c->grid];
        auto grid = std::find_if(grids.begin(), grids.end(), [&](const Grid& g) { return g.name == name; });
        if (grid == grids.end()) grid = grids.insert(grids.end(), {name, {GridHour{}}});
        GridHour& sky = grid->hours.front();
        if (row.labels[*c->point] != std::to_string(sky.sensors.size()))
            base::fail(path, name + ": point " + row.labels[*c->point] + " where " +
                                 std::to_string(sky.sensors.size()) +
                                 " comes next: one picture of the points is wanted");
        add_sensor(*c, row, path, sky);
        if (!(sky.sensors.back().value >= 0 && sky.sensors.back().error >= 0))
            base::fail(path, name + ": point " + row.labels[*c->point] + " has no value with an interval");
        grid->strata = sky.strata;
    };
    if (!report::each_row(path, add)) base::fail(path, "is not a table of vcmetrics");
    std::vector<DaylightFactor> factors;
    for (Grid& g : grids) {
        std::vector<Number> sensors;
        if (!g.hours.front().halves.empty()) g.hours.front().halves.resize(g.sensors());
        for (size_t i = 0; i < g.sensors(); ++i) sensors.push_back(factor_of(hours_of(g, {0}, i), outdoor_lux, alpha));
        factors.push_back({g.name, mean(sensors, g.strata, alpha)});
    }
    return factors;
}

std::string line_of(const DaylightFactor& f, double outdoor_lux) {
    std::string text = fmt::format("DF        {:.2f} %", 100 * f.mean.value);
    if (f.mean.low < f.mean.high) text += fmt::format(" ({:.2f} to {:.2f})", 100 * f.mean.low, 100 * f.mean.high);
    return text + fmt::format(" of {:g} lx outdoors, mean of the sensors\n", outdoor_lux);
}

void add(report::Line& line, const DaylightFactor& f) {
    report::add_bounds(line, "DF", f.mean.value, f.mean.low, f.mean.high);
}

}  // namespace year
