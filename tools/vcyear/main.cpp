// SPDX-License-Identifier: BSD-3-Clause
// vcyear - what a year of hours says of glare, from vcmetrics' tables of ptrace -wea, with intervals.
// The numbers live in lib/year; this file only connects.  See man/vcyear.1.
#include <algorithm>

#include "base/error.h"
#include "base/run.h"
#include "options.h"
#include "year/honeybee.h"
#include "year/next.h"
#include "year/plot.h"
#include "year/text.h"

namespace {

void choose_view(const std::string& name, std::vector<year::View>& views) {
    if (name.empty()) return;
    views.erase(std::remove_if(views.begin(), views.end(), [&](const year::View& v) { return v.name != name; }),
                views.end());
    if (views.empty()) base::fail("-view", "no view is called \"" + name + "\"");
}

std::string table(const std::vector<year::Verdict>& verdicts, report::TableFormat format) {
    const std::vector<std::string> names = year::column_names();
    std::string text = report::header_line(names, format);
    for (const year::Verdict& v : verdicts) text += report::table_line(names, year::cells(v), format);
    return text;
}

std::string answer(const Options& opt, const std::vector<year::View>& views) {
    const double alpha = 1 - opt.percent / 100;
    std::vector<year::Verdict> verdicts;
    for (const year::View& v : views) verdicts.push_back(year::judge(v, alpha));
    if (!opt.plot.empty()) year::write_plot(opt.plot, views, alpha);
    if (!opt.honeybee.empty()) year::write_honeybee(opt.honeybee, views);
    if (opt.next) return year::need_lines(views, verdicts);
    if (opt.worst > 0) return year::worst_lines(views, size_t(opt.worst), opt.command);
    if (opt.format) return table(verdicts, *opt.format);
    return year::summary(views, verdicts, opt.command);
}

int work(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    year::Tables tables = year::read_tables(opt.tables);
    if (tables.exact) base::warn(opt.tables.front(), "no intervals (vcmetrics -ci 95): values count as exact");
    else if (tables.no_pixels) base::warn(opt.tables.front(), "no column pixels: pictures count as 64 x 64");
    choose_view(opt.view, tables.views);
    const std::string text = answer(opt, tables.views);
    base::write_stdout(text.data(), text.size());
    base::flush_stdout();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("vcyear", [&] { return work(argc, argv); });
}
