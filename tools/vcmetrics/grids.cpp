// SPDX-License-Identifier: BSD-3-Clause
// See grids.h.
#include "grids.h"

#include <fmt/core.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/split.h"
#include "display/point_map.h"
#include "image/grey.h"
#include "image/header.h"
#include "report/errors.h"
#include "report/sum.h"
#include "run.h"
#include "shared_paths.h"

namespace {
using namespace report;

// Points of -points, in the order of the grids.
std::vector<image::Point> points_of(const Options& o, const std::vector<image::Grid>& grids) {
    std::vector<image::Point> all;
    const std::vector<image::PointFile> files = image::point_files(o.points_files);
    for (size_t g = 0; g < files.size(); g++) {
        image::GridFile file = image::read_points(files[g]);
        if (g >= grids.size() || grids[g].hash != file.hash)
            base::fail(files[g].path, "these are not the points of the picture, in the order in which it has them");
        all.insert(all.end(), file.points.begin(), file.points.end());
    }
    if (all.size() != image::count_of(grids))
        base::fail(o.over_file.empty() ? "-points" : "-over", "needs all point files of ptrace: -points FILE");
    return all;
}

// A picture of points has no view, and is compared with no other.
void refuse_options_of_views(const Options& o) {
    const std::pair<const char*, bool> of_views[] = {
        {"-against", !o.against.empty()},      {"-go-on", o.go_on},
        {"-c", !o.check_file.empty()},         {"-sources", o.list_sources},
        {"-regions", !o.regions_file.empty()}, {"-like", o.mode != OutputMode::vcmetrics}};
    for (const auto& [name, given] : of_views)
        if (given) base::fail(name, "works on pictures of a view, not on pictures of points");
}

std::string grid_errors(const uncertainty::NoisyValues& v, size_t i, bool halves) {
    std::string cell;
    if (v.degrees > 0)
        add_error("E", {v.error[i], v.degrees, halves ? point_halves(v, i) : uncertainty::Halves{}}, cell);
    return cell.empty() ? "-" : cell;
}

GridState begin(const Options& o, const image::Header& h, Progress progress) {
    refuse_options_of_views(o);
    GridState s;
    s.progress = std::move(progress);
    if (!o.points_files.empty() || !o.over_file.empty()) s.points = points_of(o, h.grids);
    if (!h.grids[0].sensors && !o.like_rtrace && !o.each)
        base::fail("", "the picture holds radiances along rays; -each or -like rtrace prints them");
    const std::vector<std::string> names = o.metrics.empty() ? base::split_list(default_grid_numbers, ',') : o.metrics;
    s.columns = grid_columns(names, h.grids, "-metrics");
    if (!o.until.empty())
        for (const Tolerance& t : parse_tolerances(o.until, "-until"))
            for (const GridColumn& c : grid_columns({t.metric}, h.grids, "-until"))
                s.rule.push_back(t), s.of_rule.push_back(c);
    return s;
}

bool rule_holds(const GridState& s) {
    for (size_t i = 0; i < s.rule.size(); ++i)
        if (!holds(s.rule[i], s.of_rule[i], s.grids)) return false;
    return true;
}

// Of the first share of the rule, or of the table.
double limit_of_map(const GridState& s) {
    for (const std::vector<GridColumn>& columns : {s.of_rule, s.columns})
        for (const GridColumn& c : columns)
            if (c.kind == GridColumn::Kind::share) return c.argument;
    return 300;
}

Line grid_row(const Options& o, const GridState& s, int64_t frame, double seconds) {
    Line line;
    add(line, "frame", double(frame)), add(line, "seconds", number_cell(seconds, 4));
    if (!s.header.sky_name.empty()) add(line, "sky", text_cell(s.header.sky_name));
    if (!s.header.state.empty()) add(line, "state", text_cell(s.header.state));
    if (s.header.edit) add(line, "edit", double(*s.header.edit));
    for (const GridColumn& c : s.columns) {
        const GridNumber v = grid_number(c, s.grids, 1 - o.ci.value_or(.95));
        if (o.ci) add_bounds(line, c.name, v.value, v.limits.low, v.limits.high);
        else add(line, c.name, v.value);
    }
    return line;
}

// Of point i of grid g.
Line point_row(const Options& o, const GridState& s, size_t g, size_t i) {
    const image::Grid& grid = s.header.grids[g];
    const std::string paths = paths_of(s.header);
    Line line;
    if (!s.header.sky_name.empty()) add(line, "sky", text_cell(s.header.sky_name));
    if (!s.header.state.empty()) add(line, "state", text_cell(s.header.state));
    add(line, "grid", text_cell(grid.name));
    if (s.points.empty()) {
        add(line, "point", double(i));
    } else {
        const image::Point& p = s.points[grid.first + i];
        add(line, "x", p.p.x), add(line, "y", p.p.y), add(line, "z", p.p.z);
        add(line, "dx", p.dir.x), add(line, "dy", p.dir.y), add(line, "dz", p.dir.z);
    }
    const uncertainty::Interval limits = point_limits(s.grids[g], i, 1 - o.ci.value_or(.95));
    add(line, "E", s.grids[g].value[i]), add(line, "lo", limits.low), add(line, "hi", limits.high);
    add(line, errors_column, text_cell(grid_errors(s.grids[g], i, prints_halves(o, s.header))));
    if (!paths.empty()) add(line, paths_column, text_cell(paths));
    if (s.header.hour) add(line, hour_column, text_cell(i == 0 ? hour_of(s.header) : "-"));
    return line;
}

}  // namespace

GridStep step(const Options& o, GridState s, image::Picture& p, int64_t frame, double seconds) {
    const image::Header& h = p.header;
    const std::string label = image::label(h);
    s.progress = begin(o, std::move(s.progress), label, h.frames.value_or(0));
    if (s.progress.done) return {std::move(s), "", {}};
    if (image::count_of(h.grids) > size_t(p.width) * size_t(p.height))
        base::fail("", "GRID= lines have more points than pixels");
    const bool plain = !o.each && !o.like_rtrace && !(o.last && is_followed(h, frame)),
               other_sky = h.sky_name != s.header.sky_name || h.state != s.header.state;
    if (!s.columns.empty() && other_sky) tell_if_alone(o, s);
    const bool first = s.columns.empty() || !(h.grids == s.header.grids);  // points change in a live stream
    std::string text = !s.columns.empty() && other_sky ? rows_of_points(o, s) : "";
    std::vector<std::string> names = std::move(s.names);
    if (first) s = begin(o, h, std::move(s.progress));
    s.names = std::move(names);
    std::vector<float> grey = image::grey_of(p.rgb);
    if (!h.unknown.empty()) grey.assign(grey.size(), std::numeric_limits<float>::quiet_NaN());
    const int64_t n = h.frames.value_or(0);
    if (first || n <= s.parts.frames() || other_sky) s.parts.restart(), s.held = 0;
    if (!p.parts.empty()) s.parts.resume(p.parts, grey, n);
    else s.parts.add(grey.data(), grey.size(), n, h.seed);
    s.header = h;
    s.rgb = std::move(p.rgb);
    s.grids.clear();
    for (const image::Grid& g : h.grids)
        s.grids.push_back(
            uncertainty::noisy_values(s.parts.parts(), grey.data(), g.first, g.count, image::lumens_per_watt));
    if (plain || o.each) {
        const Line line = plain ? grid_row(o, s, frame, seconds) : point_row(o, s, 0, 0);
        if (line.names != s.names) text += header_line(line.names, o.format);
        s.names = line.names;
        if (plain) text += table_line(line, o.format);
    }
    // Two pictures in a row: of many looks at a rule, single ones find that it holds before it does.
    if (!s.rule.empty()) s.held = n >= uncertainty::least_frames && rule_holds(s) ? s.held + 1 : 0;
    Verdict verdict;
    std::tie(s.progress, verdict) = decide(o, {s.held >= 2, "-until holds", ""}, std::move(s.progress),
                                           {n, seconds, nullptr, false, p.width, p.height, h.last_frame == frame});
    return {std::move(s), text, verdict};
}

void draw_map(const Options& o, const GridState& s) {
    const double certain = o.ci.value_or(.95), alpha = 1 - certain;
    const bool lux = s.header.grids[0].sensors;
    display::MapColumn values{lux ? "lx" : "cd/m2", limit_of_map(s), {}, {}, {}}, widths = values;
    values.says_hatched = fmt::format("hatched: the {:g} % interval holds it", 100 * certain);
    widths.unit += fmt::format(", half of the {:g} % interval", 100 * certain);
    widths.limit = std::nullopt;
    std::vector<std::string> names;
    std::vector<std::vector<image::Point>> points;
    for (size_t g = 0; g < s.grids.size(); ++g) {
        const image::Grid& grid = s.header.grids[g];
        if (grid.name == grid_outside) continue;
        names.push_back(grid.name);
        const auto first = s.points.begin() + long(grid.first);
        points.emplace_back(first, first + long(grid.count));
        values.values.push_back(s.grids[g].value);
        values.hatched.emplace_back(), widths.values.emplace_back();
        for (size_t i = 0; i < grid.count; ++i) {
            const uncertainty::Interval limits = point_limits(s.grids[g], i, alpha);
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

void tell_if_alone(const Options& o, const GridState& s) {
    if ((o.ci || o.each) && s.parts.parts().size() == 1)
        base::warn(image::label(s.header), std::string("no intervals: ") + no_batches);
}

std::string rows_of_points(const Options& o, const GridState& s) {
    std::string text;
    const std::vector<image::Grid>& grids = s.header.grids;
    if (o.like_rtrace)
        for (size_t i = 0; i < image::count_of(grids); ++i)
            text += fmt::format("{:.6e}\t{:.6e}\t{:.6e}\t\n", double(s.rgb[3 * i]), double(s.rgb[3 * i + 1]),
                                double(s.rgb[3 * i + 2]));
    if (!o.each) return text;
    for (size_t g = 0; g < grids.size(); ++g)
        for (size_t i = 0; i < grids[g].count; ++i) text += table_line(point_row(o, s, g, i), o.format);
    return text;
}
