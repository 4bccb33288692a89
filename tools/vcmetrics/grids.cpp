// SPDX-License-Identifier: BSD-3-Clause
// See grids.h.
#include "grids.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/run.h"
#include "base/split.h"
#include "image/grey.h"
#include "image/header.h"
#include "report/until.h"

namespace {
using namespace report;

// Points of -points, in the order of the grids.
std::vector<image::Point> points_of(const Options& o, const std::vector<image::Grid>& grids) {
    std::vector<image::Point> all;
    for (const std::string& path : o.points_files) {
        const size_t g = size_t(&path - o.points_files.data());
        image::GridFile file = image::read_points(path);
        if (g >= grids.size() || grids[g].hash != file.hash)
            base::fail(path, "these are not the points of the picture, in the order in which it has them");
        all.insert(all.end(), file.points.begin(), file.points.end());
    }
    if (all.size() != image::count_of(grids)) base::fail("-each", "needs all point files of ptrace: -points FILE");
    return all;
}

}  // namespace

void GridRun::begin(const image::Header& h) {
    if (!h.grids[0].sensors && !o_.like_rtrace && !o_.each)
        base::fail("", "the picture holds radiances along rays; -each or -like rtrace prints them");
    const std::vector<std::string> names =
        o_.metrics.empty() ? base::split_list(default_grid_numbers, ',') : o_.metrics;
    columns_ = grid_columns(names, h.grids, "-metrics");
    std::vector<std::string> asked;
    if (!o_.until.empty())
        for (const Tolerance& t : parse_tolerances(o_.until, "-until")) asked.push_back(t.metric);
    for (const std::string& name : asked) {
        std::vector<GridColumn> one = grid_columns({name}, h.grids, "-until");
        if (one.size() > 1) base::fail("-until", "\"" + name + "\" is of several grids: name one");
        asked_.push_back(one[0]);
    }
    names_ = {"frame", "seconds"};
    if (!h.sky_name.empty()) names_.push_back("sky");
    for (const GridColumn& c : columns_) {
        names_.push_back(c.name);
        if (o_.ci) names_.push_back(c.name + ".lo"), names_.push_back(c.name + ".hi");
    }
}

bool GridRun::rule_holds(double alpha) {
    const std::vector<Tolerance> rule = parse_tolerances(o_.until, "-until");
    for (size_t i = 0; i < rule.size(); ++i) {
        const GridNumber n = grid_number(asked_[i], grids_, alpha);
        if (!(n.limits.high - n.limits.low <= 2 * rule[i].of(n.value))) return false;
    }
    return true;
}

bool GridRun::add(const image::Picture& p, int64_t frame, double seconds, std::string& text) {
    const image::Header& h = p.header;
    if (image::count_of(h.grids) > size_t(p.width) * size_t(p.height))
        base::fail("", "GRID= lines have more points than pixels");
    const bool first = columns_.empty(), plain = !o_.each && !o_.like_rtrace;
    if (first) begin(h);
    const std::vector<float> grey = image::grey_of(p.rgb);
    const int64_t n = h.frames.value_or(0);
    if (first || n <= parts_.frames() || h.sky_name != last_.header.sky_name) parts_.restart(), held_ = 0;
    if (!p.parts.empty()) parts_.resume(p.parts, grey, n);
    else parts_.add(grey.data(), grey.size(), n, h.seed);
    last_ = p;
    grids_.clear();
    for (const image::Grid& g : h.grids)
        grids_.push_back(
            uncertainty::noisy_values(parts_.parts(), grey.data(), g.first, g.count, image::lumens_per_watt));
    if (plain) {
        if (first) text += header_line(names_, o_.format);
        std::vector<Cell> cells = {number_cell(double(frame)), number_cell(seconds, 4)};
        if (!h.sky_name.empty()) cells.push_back(text_cell(h.sky_name));
        for (const GridColumn& c : columns_) {
            const GridNumber v = grid_number(c, grids_, 1 - o_.ci.value_or(.95));
            cells.push_back(number_cell(v.value));
            if (o_.ci) cells.push_back(number_cell(v.limits.low)), cells.push_back(number_cell(v.limits.high));
        }
        text += table_line(names_, cells, o_.format);
    }
    // Two looks in a row, since a rule that is looked at often holds by chance at one of them.
    if (!asked_.empty()) held_ = n >= uncertainty::least_frames && rule_holds(.05) ? held_ + 1 : 0;
    done_ = held_ >= 2;
    if (done_) base::say(fmt::format("vcmetrics: stopped after {} frames: -until holds", n));
    return done_ || (o_.max_frames && n >= *o_.max_frames) || (o_.max_seconds && seconds >= *o_.max_seconds);
}

std::string GridRun::end(int& status) const {
    status = o_.until.empty() || done_ ? 0 : 4;
    if (status == 4) base::say("vcmetrics: the input ended, and -until does not hold");
    std::string text;
    const std::vector<image::Grid>& grids = last_.header.grids;
    if (o_.like_rtrace)
        for (size_t i = 0; i < image::count_of(grids); ++i)
            text += fmt::format("{:.6e}\t{:.6e}\t{:.6e}\t\n", double(last_.rgb[3 * i]), double(last_.rgb[3 * i + 1]),
                                double(last_.rgb[3 * i + 2]));
    if (!o_.each) return text;
    const std::vector<std::string> names = {"grid", "x", "y", "z", "dx", "dy", "dz", "E", "lo", "hi"};
    text += header_line(names, o_.format);
    const std::vector<image::Point> points = points_of(o_, grids);
    for (size_t g = 0; g < grids.size(); ++g)
        for (size_t i = 0; i < grids[g].count; ++i) {
            const image::Point& point = points[grids[g].first + i];
            const uncertainty::Interval limits = point_limits(grids_[g], i, 1 - o_.ci.value_or(.95));
            std::vector<Cell> cells = {text_cell(grids[g].name)};
            for (const double v : {point.p.x, point.p.y, point.p.z, point.dir.x, point.dir.y, point.dir.z,
                                   grids_[g].value[i], limits.low, limits.high})
                cells.push_back(number_cell(v));
            text += table_line(names, cells, o_.format);
        }
    return text;
}
