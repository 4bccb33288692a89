// SPDX-License-Identifier: BSD-3-Clause
// See sensors.h.
#include "sensors.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "year/body_clock.h"
#include "year/daylight_factor.h"
#include "year/en17037_text.h"
#include "year/grid_maps.h"
#include "year/honeybee.h"
#include "year/leed.h"
#include "year/months.h"
#include "year/text.h"

namespace {

// The same grids under direct sun alone, in the same order.
std::vector<year::Grid> direct_of(const std::vector<year::Grid>& read, const std::vector<year::Grid>& grids) {
    std::vector<year::Grid> direct;
    for (const year::Grid& grid : grids) {
        const auto found =
            std::find_if(read.begin(), read.end(), [&](const year::Grid& g) { return g.name == grid.name; });
        if (found == read.end()) base::fail("-direct", "has no grid \"" + grid.name + "\"");
        direct.push_back(*found);
    }
    return direct;
}

void refuse_options_of_views(const Options& o) {
    const std::pair<const char*, bool> of_views[] = {
        {"-next", o.next}, {"-worst", o.worst > 0}, {"-view", !o.view.empty()}, {"-report", !o.report.empty()}};
    for (const auto& [name, given] : of_views)
        if (given) base::fail(name, "is of views, not of sensors");
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

// -months: a row for each grid and month, or each of its sensors.
std::string rows_of_months(const Options& o, const std::vector<year::Grid>& grids) {
    std::vector<report::Line> lines;
    for (const year::Grid& g : grids)
        for (const int month : year::months_of(g)) {
            const year::GridYear y = year::judge(year::of_month(g, month), nullptr, o.goals, 1 - o.percent / 100);
            for (size_t k = 0; k < (o.each ? y.sensors.size() : 1); ++k)
                lines.push_back(year::with_month(o.each ? line_of(y, k) : line_of(y), month));
        }
    return report::table(lines, o.format.value_or(report::TableFormat::tsv));
}

// What options add to the lines and to the row of a grid.
class Additions {
public:
    Additions(const Options& o, const std::vector<year::Grid>& grids) : outdoor_lux_(o.outdoor_lux) {
        const double alpha = 1 - o.percent / 100;
        if (!o.en17037.empty()) {
            const year::DaylightHours daylight = year::daylight_hours(weather::read_weather(o.en17037));
            for (const year::Grid& g : grids)
                provisions_.push_back(year::judge_provision(g, daylight, o.rooflight, alpha));
        }
        if (o.overcast.empty()) return;
        const std::vector<year::DaylightFactor> read = year::daylight_factors(o.overcast, outdoor_lux_, alpha);
        for (const year::Grid& g : grids) {
            const auto found = std::find_if(read.begin(), read.end(), [&](const auto& f) { return f.name == g.name; });
            if (found == read.end()) base::fail("-overcast", "has no grid \"" + g.name + "\"");
            factors_.push_back(*found);
        }
    }
    std::string lines(size_t grid) const {
        return (provisions_.empty() ? "" : year::lines_of(provisions_[grid])) +
               (factors_.empty() ? "" : year::line_of(factors_[grid], outdoor_lux_));
    }
    void add(size_t grid, report::Line& row) const {
        if (!provisions_.empty()) year::add(row, provisions_[grid]);
        if (!factors_.empty()) year::add(row, factors_[grid]);
    }
    void add(size_t grid, size_t sensor, report::Line& row) const {
        if (!provisions_.empty()) year::add(row, provisions_[grid].sensors[sensor]);
    }

private:
    double outdoor_lux_;
    std::vector<year::Provision> provisions_;
    std::vector<year::DaylightFactor> factors_;
};

}  // namespace

std::string answer_of_sensors(const Options& o, const Counted& c) {
    refuse_options_of_views(o);
    const std::vector<year::Grid>& grids = c.tables.grids;
    if (!o.sun_steps.empty() && c.shades) base::fail("-sunlight", "is of one state of shades: -state says which");
    if (!o.sun_steps.empty()) return sunlight(o, grids);
    std::vector<year::Grid> direct;
    if (!o.direct.empty()) direct = direct_of(c.direct, grids);
    std::vector<year::GridYear> years;
    for (size_t g = 0; g < grids.size(); ++g)
        years.push_back(year::judge(grids[g], direct.empty() ? nullptr : &direct[g], o.goals, 1 - o.percent / 100));
    if (!o.plot.empty()) year::write_maps(o.plot, years, o.points, o.goals);
    if (!o.honeybee.empty()) year::write_honeybee(o.honeybee, grids, direct);
    if (o.months) return rows_of_months(o, grids);
    const Additions additions(o, grids);
    std::vector<report::Line> lines;
    std::string text;
    for (size_t g = 0; g < years.size(); ++g) {
        for (size_t k = 0; k < (o.each ? years[g].sensors.size() : 1); ++k) {
            lines.push_back(o.each ? line_of(years[g], k) : line_of(years[g]));
            o.each ? additions.add(g, k, lines.back()) : additions.add(g, lines.back());
        }
        text += year::summary(years[g], o.goals) + additions.lines(g);
        const auto clock = year::judge_body_clock(c.tables, grids[g].name, o.goals.autonomy_share, 1 - o.percent / 100);
        if (clock) text += year::line_of_sensors(*clock);
        if (clock && !o.each) year::add_sensors(lines.back(), *clock);
        if (!o.each) year::add_shades(lines.back(), c.groups);
    }
    text += c.shade_lines();
    size_t to_come = 0;
    for (const year::GridYear& y : years) to_come += y.to_come;
    text += year::rest_line(to_come, o.command, o.tables);
    if (o.leed) {
        year::Leed leed = year::judge_leed(years, o.goals);
        if (!c.shades) leed.lacks.push_back("shades stand still, LM-83 moves them: -shades 'sun 2% 1000'");
        text += year::lines_of(leed);
    }
    return o.format || o.each ? report::table(lines, o.format.value_or(report::TableFormat::tsv)) : text;
}
