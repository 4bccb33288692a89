// SPDX-License-Identifier: BSD-3-Clause
// vcyear - what a year of hours says of glare, or of daylight at sensors, from vcmetrics' tables of ptrace -wea, with
// intervals.
// The numbers live in lib/year; this file only connects.  See man/vcyear.1.
#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "base/run.h"
#include "options.h"
#include "year/en17037_text.h"
#include "year/grid_maps.h"
#include "year/honeybee.h"
#include "year/next.h"
#include "year/plot.h"
#include "year/shades.h"
#include "year/text.h"

namespace {

void choose_view(const std::string& name, std::vector<year::View>& views) {
    if (name.empty()) return;
    views.erase(std::remove_if(views.begin(), views.end(), [&](const year::View& v) { return v.name != name; }),
                views.end());
    if (views.empty()) base::fail("-view", "no view is called \"" + name + "\"");
}

// The same grids under direct sun alone, in the same order.
std::vector<year::Grid> read_direct(const std::vector<std::string>& paths, const std::vector<year::Grid>& grids) {
    std::vector<year::Grid> read = year::read_tables(paths).grids, direct;
    for (const year::Grid& grid : grids) {
        const auto found =
            std::find_if(read.begin(), read.end(), [&](const year::Grid& g) { return g.name == grid.name; });
        if (found == read.end()) base::fail("-direct", "has no grid \"" + grid.name + "\"");
        direct.push_back(std::move(*found));
    }
    return direct;
}

void refuse_options_of_views(const Options& o) {
    const std::pair<const char*, bool> of_views[] = {
        {"-next", o.next}, {"-worst", o.worst > 0}, {"-view", !o.view.empty()}, {"-closed", !o.closed.empty()}};
    for (const auto& [name, given] : of_views)
        if (given) base::fail(name, "is of views, not of sensors");
}

std::vector<year::Provision> provisions_of(const Options& o, const std::vector<year::Grid>& grids) {
    std::vector<year::Provision> provisions;
    if (o.en17037.empty()) return provisions;
    const year::DaylightHours daylight = year::daylight_hours(weather::read_weather(o.en17037));
    for (const year::Grid& g : grids)
        provisions.push_back(year::judge_provision(g, daylight, o.rooflight, 1 - o.percent / 100));
    return provisions;
}

// -sunlight: a line for each grid, or -each point.
std::string sunlight(const Options& o, const std::vector<year::Grid>& grids) {
    const weather::Weather day = weather::read_weather(o.sun_steps);
    std::vector<report::Line> lines;
    std::string text;
    for (const year::Grid& g : grids) {
        std::vector<size_t> points(g.sensors());
        std::iota(points.begin(), points.end(), size_t(0));
        for (size_t k = 0; k < (o.each ? points.size() : 1); ++k) {
            const year::Sunlight s =
                year::judge_sunlight(g, o.each ? std::vector<size_t>{k} : points, day, o.lowest_deg);
            report::add(lines.emplace_back(), "grid", report::text_cell(g.name));
            if (o.each) report::add(lines.back(), "point", double(k));
            year::add(lines.back(), s);
            text += g.name + "\n" + year::line_of(s);
        }
    }
    return o.format || o.each ? report::table(lines, o.format.value_or(report::TableFormat::tsv)) : text;
}

std::string answer(const Options& o, const std::vector<year::Grid>& grids) {
    refuse_options_of_views(o);
    if (!o.sun_steps.empty()) return sunlight(o, grids);
    std::vector<year::Grid> direct;
    if (!o.direct.empty()) direct = read_direct(o.direct, grids);
    std::vector<year::GridYear> years;
    for (size_t g = 0; g < grids.size(); ++g)
        years.push_back(year::judge(grids[g], direct.empty() ? nullptr : &direct[g], o.goals, 1 - o.percent / 100));
    if (!o.plot.empty()) year::write_maps(o.plot, years, o.points, o.goals);
    if (!o.honeybee.empty()) year::write_honeybee(o.honeybee, grids, direct);
    const std::vector<year::Provision> provisions = provisions_of(o, grids);
    std::vector<report::Line> lines;
    std::string text;
    for (size_t g = 0; g < years.size(); ++g) {
        for (size_t k = 0; k < (o.each ? years[g].sensors.size() : 1); ++k)
            lines.push_back(o.each ? line_of(years[g], k) : line_of(years[g]));
        text += year::summary(years[g], o.goals);
        if (provisions.empty()) continue;
        if (!o.each) year::add(lines.back(), provisions[g]);
        text += year::lines_of(provisions[g]);
    }
    return o.format || o.each ? report::table(lines, o.format.value_or(report::TableFormat::tsv)) : text;
}

void refuse_options_of_sensors(const Options& o) {
    const std::pair<const char*, bool> of_sensors[] = {{"-direct", !o.direct.empty()},
                                                       {"-each", o.each},
                                                       {"-points", !o.points.empty()},
                                                       {"-en17037", !o.en17037.empty()},
                                                       {"-sunlight", !o.sun_steps.empty()}};
    for (const auto& [name, given] : of_sensors)
        if (given) base::fail(name, "is of sensors (vcmetrics -each), not of views");
}

std::string answer(const Options& opt, std::vector<year::View> views) {
    refuse_options_of_sensors(opt);
    std::string shades;
    if (!opt.closed.empty()) {
        year::Shaded shaded = year::with_shades(std::move(views), year::read_tables(opt.closed).views, opt.close_dgp);
        views = std::move(shaded.views);
        shades = year::shades_line(shaded.closed, opt.close_dgp);
    }
    const double alpha = 1 - opt.percent / 100;
    std::vector<year::Verdict> verdicts;
    for (const year::View& v : views) verdicts.push_back(year::judge(v, alpha));
    if (!opt.plot.empty()) year::write_plot(opt.plot, views, alpha);
    if (!opt.honeybee.empty()) year::write_honeybee(opt.honeybee, views);
    if (opt.next) return year::need_lines(views, verdicts, alpha);
    if (opt.worst > 0) return year::worst_lines(views, size_t(opt.worst), opt.command);
    std::vector<report::Line> lines;
    for (const year::Verdict& v : verdicts) lines.push_back(year::line_of(v));
    if (opt.format) return report::table(lines, *opt.format);
    return year::summary(views, verdicts, opt.command) + shades;
}

int work(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    year::Tables tables = year::read_tables(opt.tables);
    if (tables.no_errors)
        base::warn(opt.tables.front(), "no column errors (of an earlier vcmetrics): .lo and .hi count as of 95 %");
    if (tables.exact) base::warn(opt.tables.front(), "no intervals (vcmetrics -ci 95): values count as exact");
    else if (tables.no_pixels) base::warn(opt.tables.front(), "no column pixels: pictures count as 64 x 64");
    if (tables.grids.empty()) choose_view(opt.view, tables.views);
    const std::string text = tables.grids.empty() ? answer(opt, tables.views) : answer(opt, tables.grids);
    base::write_stdout(text.data(), text.size());
    base::flush_stdout();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("vcyear", [&] { return work(argc, argv); });
}
