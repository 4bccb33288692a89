// SPDX-License-Identifier: BSD-3-Clause
// Maps of sensors (-over plan.svg): see grids.h.
#include <fmt/core.h>

#include <cmath>

#include "display/point_map.h"
#include "grids.h"

namespace {
using namespace report;

// The kind of the numbers that a run is about: what its map shows.
const GridKind& first_kind(const GridState& s) { return s.kinds[s.columns.empty() ? 0 : s.columns[0].kind]; }

// Of the first share of the rule, or of the table.
double limit_of_map(const GridState& s) {
    for (const std::vector<GridCell>& columns : {s.of_rule, s.columns})
        for (const GridCell& c : columns)
            if (c.column.kind == GridColumn::Kind::share) return c.column.argument;
    return 300;
}

}  // namespace

void draw_map(const Options& o, const GridState& s) {
    const double certain = o.ci.value_or(.95), alpha = 1 - certain;
    const bool lux = s.header.grids[0].sensors;
    display::MapColumn values{lux ? "lx" : "cd/m2", limit_of_map(s), {}, {}, {}}, widths = values;
    values.says_hatched = fmt::format("hatched: the {:g} % interval holds it", 100 * certain);
    widths.unit += fmt::format(", half of the {:g} % interval", 100 * certain);
    widths.limit = std::nullopt;
    std::vector<std::string> names;
    std::vector<std::vector<image::Point>> points;
    const std::vector<uncertainty::NoisyValues>& grids = first_kind(s).grids;
    if (grids.empty()) return;
    for (size_t g = 0; g < grids.size(); ++g) {
        const image::Grid& grid = s.header.grids[g];
        if (grid.name == grid_outside) continue;
        names.push_back(grid.name);
        const auto first = s.points.begin() + long(grid.first);
        points.emplace_back(first, first + long(grid.count));
        values.values.push_back(grids[g].value);
        values.hatched.emplace_back(), widths.values.emplace_back();
        for (size_t i = 0; i < grid.count; ++i) {
            const uncertainty::Interval limits = point_limits(grids[g], i, alpha);
            values.hatched.back().push_back(limits.low < *values.limit && *values.limit <= limits.high);
            widths.values.back().push_back(limits.half_width());
        }
    }
    const auto words = [&](size_t g, size_t i) {
        const double value = values.values[g][i], width = widths.values[g][i];
        const base::Vec3 p = points[g][i].p;
        const std::string noise = std::isfinite(width) ? " \u00b1 " + rounded(width, width) : "";
        return fmt::format("{}: {}{} {} at {:.6g}, {:.6g}, {:.6g}", names[g], rounded(value, width), noise, values.unit,
                           p.x, p.y, p.z);
    };
    display::write_canvas(o.over_file, display::point_maps(names, points, {values, widths}, words), o.command);
}
