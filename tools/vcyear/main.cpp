// SPDX-License-Identifier: BSD-3-Clause
// vcyear - what a year of hours says of glare, or of daylight at sensors, from vcmetrics' tables of ptrace -wea, with
// intervals.
// The numbers live in lib/year; this file only connects.  See man/vcyear.1.
#include <algorithm>

#include "base/error.h"
#include "base/run.h"
#include "image/stream.h"
#include "options.h"
#include "page.h"
#include "sensors.h"
#include "shaded.h"
#include "year/body_clock.h"
#include "year/honeybee.h"
#include "year/months.h"
#include "year/next.h"
#include "year/plot.h"
#include "year/text.h"

namespace {

void refuse_options_of_sensors(const Options& o, const Counted& c) {
    const std::pair<const char*, bool> of_sensors[] = {{"-direct", !o.direct.empty() && !c.shades},
                                                       {"-each", o.each},
                                                       {"-points", !o.points.empty()},
                                                       {"-en17037", !o.en17037.empty() && o.planes.empty()},
                                                       {"-sunlight", !o.sun_steps.empty() && o.openings.empty()},
                                                       {"-overcast", !o.overcast.empty()},
                                                       {"-leed", o.leed}};
    for (const auto& [name, given] : of_sensors)
        if (given) base::fail(name, "is of sensors (vcmetrics -each), not of views");
}

// -months: a row for each view and month.
std::string months(const Options& opt, const std::vector<year::View>& views, double alpha) {
    std::vector<report::Line> lines;
    for (const year::View& v : views)
        for (const int month : year::months_of(v))
            lines.push_back(year::with_month(year::line_of(year::judge(year::of_month(v, month), alpha)), month));
    return report::table(lines, opt.format.value_or(report::TableFormat::tsv));
}

std::string answer_of_views(const Options& opt, const Counted& c) {
    refuse_options_of_sensors(opt, c);
    const std::vector<year::View>& views = c.tables.views;
    const double alpha = 1 - opt.percent / 100;
    if (opt.months) return months(opt, views, alpha);
    std::vector<year::Verdict> verdicts;
    std::vector<year::BodyClock> clocks;
    for (const year::View& v : views) {
        verdicts.push_back(year::judge(v, alpha));
        if (auto clock = year::judge_body_clock(c.tables, v.name, opt.goals.autonomy_share, alpha))
            clocks.push_back(*clock);
    }
    if (!opt.plot.empty()) year::write_plot(opt.plot, views, alpha, c.shades ? &*c.shades : nullptr);
    if (!opt.honeybee.empty()) year::write_honeybee(opt.honeybee, views);
    if (!opt.report.empty()) image::write_bytes(opt.report, year::page_text(page_of(opt, c, verdicts, clocks)));
    if (opt.next) return year::need_lines(views, verdicts, alpha);
    if (opt.worst > 0) return year::worst_lines(views, size_t(opt.worst), opt.command);
    std::vector<report::Line> lines;
    for (const year::Verdict& v : verdicts) lines.push_back(year::line_of(v)), year::add_shades(lines.back(), c.groups);
    std::string light;
    for (const year::BodyClock& clock : clocks) {
        light += year::line_of_view(clock);
        for (size_t k = 0; k < views.size(); ++k)
            if (views[k].name == clock.name) year::add_view(lines[k], clock);
    }
    if (opt.format) return report::table(lines, *opt.format);
    size_t to_come = 0;
    for (const year::View& v : views) to_come += v.to_come;
    return year::summary(views, verdicts, opt.command) + light + c.shade_lines() +
           year::rest_line(to_come, opt.command, opt.tables);
}

int work(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    const Counted counted = read_counted(opt);
    const year::Tables& tables = counted.tables;
    if (tables.no_errors)
        base::warn(opt.tables.front(), "no column errors (of an earlier vcmetrics): .lo and .hi count as of 95 %");
    if (tables.exact) base::warn(opt.tables.front(), "no intervals (vcmetrics -ci 95): values count as exact");
    else if (tables.no_pixels) base::warn(opt.tables.front(), "no column pixels: pictures count as 64 x 64");
    const std::string text = tables.grids.empty() ? answer_of_views(opt, counted) : answer_of_sensors(opt, counted);
    base::write_stdout(text.data(), text.size());
    base::flush_stdout();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("vcyear", [&] { return work(argc, argv); });
}
