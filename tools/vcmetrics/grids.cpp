// SPDX-License-Identifier: BSD-3-Clause
// See grids.h.
#include "grids.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "action_plan.h"
#include "base/error.h"
#include "base/split.h"
#include "glare/actions.h"
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

constexpr GridNumber unknown{NAN, {NAN, NAN}};

void add_grid_error(const std::string& name, const uncertainty::NoisyValues& v, size_t i, bool halves,
                    std::string& cell) {
    if (v.degrees > 0)
        add_error(name, {v.error[i], v.degrees, halves ? point_halves(v, i) : uncertainty::Halves{}}, cell);
}

// "floor.mEDI.mean": of which pictures, and the column there.
std::pair<std::string, std::string> kind_and_column(const std::string& name) {
    std::string of, column;
    size_t from = 0;
    for (size_t dot = 0; dot != std::string::npos; from = dot + 1) {
        dot = name.find('.', from);
        const std::string word = name.substr(from, dot == std::string::npos ? dot : dot - from);
        const auto action = glare::action_column(word);
        if (action && action->metric == "Ev" && action->ratio)
            base::fail("-metrics",
                       name + ": the ratio is of views; of sensors there are " + action->action + " and EvV");
        if (action && action->metric == "Ev" && of.empty()) of = word;
        else column += (column.empty() ? "" : ".") + word;
    }
    return {of, column};
}

size_t grid_kind(std::vector<GridKind>& kinds, const std::string& illuminance) {
    for (size_t k = 0; k < kinds.size(); ++k)
        if (kinds[k].illuminance == illuminance) return k;
    kinds.push_back({illuminance});
    return kinds.size() - 1;
}

std::vector<GridCell> cells_of(const std::string& name, const image::Header& h, const std::string& place,
                               std::vector<GridKind>& kinds) {
    const auto [of, column] = kind_and_column(name);
    std::vector<GridCell> out;
    for (GridColumn c : grid_columns({column}, h.grids, place)) {
        if (!of.empty()) c.name = h.grids[c.grid].name + "." + of + c.name.substr(h.grids[c.grid].name.size());
        out.push_back({std::move(c), grid_kind(kinds, of)});
    }
    return out;
}

GridState begin(const Options& o, const image::Header& h, Progress progress) {
    refuse_options_of_views(o);
    GridState s;
    s.progress = std::move(progress);
    s.kinds.push_back({""});
    if (!o.points_files.empty() || !o.over_file.empty()) s.points = points_of(o, h.grids);
    if (!h.grids[0].sensors && !o.like_rtrace && !o.each)
        base::fail("", "the picture holds radiances along rays; -each or -like rtrace prints them");
    if (o.each)
        for (const std::string& name : o.metrics) grid_kind(s.kinds, kind_and_column(name).first);
    const bool default_numbers = o.metrics.empty() || o.each;
    for (const std::string& name : default_numbers ? base::split_list(default_grid_numbers, ',') : o.metrics)
        for (GridCell& c : cells_of(name, h, "-metrics", s.kinds)) s.columns.push_back(std::move(c));
    if (!o.until.empty())
        for (const Tolerance& t : parse_tolerances(o.until, "-until"))
            for (GridCell& c : cells_of(t.metric, h, "-until", s.kinds))
                s.rule.push_back(t), s.of_rule.push_back(std::move(c));
    return s;
}

bool is_complete(const GridState& s) {
    return std::all_of(s.kinds.begin(), s.kinds.end(), [](const GridKind& k) { return k.ended; });
}

// Pictures of actions that the rule does not name are rendered to their end.
bool grids_wait(const GridState& s) {
    for (size_t k = 1; k < s.kinds.size(); ++k) {
        const auto names = [&](const GridCell& c) { return c.kind == k; };
        if (!s.kinds[k].ended && std::none_of(s.of_rule.begin(), s.of_rule.end(), names)) return true;
    }
    return false;
}

bool rule_holds(const GridState& s) {
    for (size_t i = 0; i < s.rule.size(); ++i) {
        const GridKind& kind = s.kinds[s.of_rule[i].kind];
        if (kind.grids.empty() || !holds(s.rule[i], s.of_rule[i].column, kind.grids)) return false;
    }
    return true;
}

Line grid_row(const Options& o, const GridState& s, int64_t frame, double seconds) {
    Line line;
    add(line, "frame", double(frame)), add(line, "seconds", number_cell(seconds, 4));
    if (!s.header.sky_name.empty()) add(line, "sky", text_cell(s.header.sky_name));
    if (!s.header.state.empty()) add(line, "state", text_cell(s.header.state));
    if (s.header.edit) add(line, "edit", double(*s.header.edit));
    for (const auto& [c, k] : s.columns) {
        const std::vector<uncertainty::NoisyValues>& grids = s.kinds[k].grids;
        const GridNumber v = grids.empty() ? unknown : grid_number(c, grids, 1 - o.ci.value_or(.95));
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
    std::string errors;
    for (const GridKind& k : s.kinds) {
        GridNumber v = unknown;
        if (!k.grids.empty())
            v = {k.grids[g].value[i], point_limits(k.grids[g], i, 1 - o.ci.value_or(.95))},
            add_grid_error(k.illuminance.empty() ? "E" : k.illuminance, k.grids[g], i, prints_halves(o, s.header),
                           errors);
        if (!k.illuminance.empty()) add_bounds(line, k.illuminance, v.value, v.limits.low, v.limits.high);
        else add(line, "E", v.value), add(line, "lo", v.limits.low), add(line, "hi", v.limits.high);
    }
    add(line, errors_column, text_cell(errors.empty() ? "-" : errors));
    if (!paths.empty()) add(line, paths_column, text_cell(paths));
    if (s.header.hour) add(line, hour_column, text_cell(i == 0 ? hour_of(s.header) : "-"));
    return line;
}

// None: nothing is measured in it, and the ordinary picture has come.  V by itself is an ordinary one.
std::optional<size_t> kind_of(const GridState& s, const image::Header& h) {
    const std::string illuminance = h.action ? glare::illuminance_of(*h.action) : "";
    for (size_t k = 0; k < s.kinds.size(); ++k)
        if (s.kinds[k].illuminance == illuminance) return k;
    if (s.kinds[0].frames >= 0) return std::nullopt;
    require_pictures_of("", h, "");
    return 0;
}

}  // namespace

GridStep step(const Options& o, GridState s, image::Picture& p, int64_t frame, double seconds) {
    const image::Header& h = p.header;
    if (image::count_of(h.grids) > size_t(p.width) * size_t(p.height))
        base::fail("", "GRID= lines have more points than pixels");
    const bool begun = !s.kinds.empty(),
               first = !begun || !(h.grids == s.header.grids);  // they change in a live stream
    const auto has_come = [](const GridKind& k) { return k.frames >= 0; };
    const bool other = begun && (h.sky_name != s.header.sky_name || h.state != s.header.state ||
                                 (!h.action && std::any_of(s.kinds.begin() + 1, s.kinds.end(), has_come)));
    std::string text;
    if (other) tell_if_alone(o, s), text = rows_of_points(o, s);
    std::vector<std::string> names = std::move(s.names);
    if (first) s = begin(o, h, std::move(s.progress));
    s.names = std::move(names);
    if (other) s.held_back.clear();
    if (other)
        for (GridKind& kind : s.kinds) kind = {kind.illuminance};
    const std::optional<size_t> at = kind_of(s, h);
    if (!at) return {std::move(s), text, {}};
    s.progress = begin(o, std::move(s.progress), image::label(h), h.frames.value_or(0));
    s.header = h;
    if (s.progress.done) return {std::move(s), text, {}};
    const bool plain = !o.each && !o.like_rtrace && !(o.last && is_followed(h, frame));
    std::vector<float> grey = image::grey_of(p.rgb);
    if (!h.unknown.empty()) grey.assign(grey.size(), std::numeric_limits<float>::quiet_NaN());
    const int64_t n = h.frames.value_or(0);
    GridKind& kind = s.kinds[*at];
    if (n <= kind.frames || kind.frames < 0) kind.parts.restart(), s.held = 0;
    kind.frames = n, kind.ended = !is_followed(h, frame);
    if (!p.parts.empty()) kind.parts.resume(p.parts, grey, n);
    else kind.parts.add(grey.data(), grey.size(), n, h.seed);
    if (*at == 0) s.rgb = std::move(p.rgb);
    kind.grids.clear();
    for (const image::Grid& g : h.grids)
        kind.grids.push_back(
            uncertainty::noisy_values(kind.parts.parts(), grey.data(), g.first, g.count, image::lumens_per_watt));
    if (plain || o.each) {
        const Line line = plain ? grid_row(o, s, frame, seconds) : point_row(o, s, 0, 0);
        if (line.names != s.names) text += header_line(line.names, o.format);
        s.names = line.names;
        s.held_back = plain ? table_line(line, o.format) : "";
        if (plain && !(o.last && !is_complete(s))) text += std::exchange(s.held_back, "");
    }
    // Two pictures in a row: of many looks at a rule, single ones find that it holds before it does.
    if (!s.rule.empty()) s.held = n >= uncertainty::least_frames && rule_holds(s) ? s.held + 1 : 0;
    Verdict verdict;
    std::tie(s.progress, verdict) =
        decide(o, {s.held >= 2 && !grids_wait(s), "-until holds", ""}, std::move(s.progress),
               {n, seconds, nullptr, false, p.width, p.height, h.last_frame == frame});
    return {std::move(s), text, verdict};
}

void tell_if_alone(const Options& o, const GridState& s) {
    if ((o.ci || o.each) && s.kinds[0].parts.parts().size() == 1)
        base::warn(image::label(s.header), std::string("no intervals: ") + no_batches);
}

std::string rows_of_points(const Options& o, const GridState& s) {
    std::string text = s.held_back;
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
