// SPDX-License-Identifier: BSD-3-Clause
// See grid_maps.h.
#include "year/grid_maps.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "display/point_map.h"

namespace year {
namespace {

// In the order of the years.
std::vector<std::vector<image::Point>> points_of(const std::vector<GridYear>& years,
                                                 const std::vector<std::string>& paths) {
    std::vector<std::vector<image::Point>> points(years.size());
    for (const image::PointFile& of : image::point_files(paths)) {
        const std::string& path = of.path;
        image::GridFile file = image::read_points(of);
        const auto year =
            std::find_if(years.begin(), years.end(), [&](const GridYear& y) { return y.name == file.name; });
        if (year == years.end()) base::fail(path, "the table has no grid \"" + file.name + "\"");
        if (file.points.size() != year->sensors.size())
            base::fail(path,
                       fmt::format("has {} points, the table {} sensors", file.points.size(), year->sensors.size()));
        points[size_t(year - years.begin())] = std::move(file.points);
    }
    for (size_t g = 0; g < years.size(); ++g)
        if (points[g].empty()) base::fail("-plot", "needs the points of \"" + years[g].name + "\": -points FILE");
    return points;
}

// limit: in the column's unit, as the numbers times `scale` are.
template <class Select>
display::MapColumn map_column(const std::vector<GridYear>& years, const std::string& unit, std::optional<double> limit,
                              double top, double scale, const Select& select) {
    display::MapColumn c{unit, limit, {}, {}, limit ? "hatched: undecided" : "", top};
    for (const GridYear& y : years) {
        c.values.emplace_back();
        if (limit) c.hatched.emplace_back();
        for (const SensorYear& s : y.sensors) {
            const Bounded& b = select(s);
            c.values.back().push_back(scale * b.value);
            if (limit) c.hatched.back().push_back(scale * b.low < *limit && *limit <= scale * b.high);
        }
    }
    return c;
}

}  // namespace

void write_maps(const std::string& path, const std::vector<GridYear>& years, const std::vector<std::string>& points,
                const Goals& g) {
    std::vector<std::string> names;
    for (const GridYear& y : years) names.push_back(y.name);
    std::vector<display::MapColumn> columns{
        map_column(years, fmt::format("DA of {:g} lx, % of hours", g.autonomy_lux), 100 * g.autonomy_share, 100, 100,
                   [](const SensorYear& s) -> const Bounded& { return s.autonomy; }),
        map_column(years, fmt::format("UDI of {:g} to {:g} lx, % of hours", g.useful_lux[1], g.useful_lux[2]), {}, 100,
                   100, [](const SensorYear& s) -> const Bounded& { return s.useful[autonomous]; })};
    if (years.front().sun_hours)
        columns.push_back(map_column(years, fmt::format("Sun of {:g} lx, hours", g.sun_lux), g.sun_hours, 0, 1,
                                     [](const SensorYear& s) -> const Bounded& { return s.sun_hours; }));
    display::write_canvas(path, display::point_maps(names, points_of(years, points), columns), "vcyear");
}

}  // namespace year
