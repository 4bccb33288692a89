// SPDX-License-Identifier: BSD-3-Clause
// See text.h.
#include "year/text.h"

#include <fmt/format.h>

#include <cmath>

#include "base/run.h"
#include "base/split.h"

namespace year {
namespace {

constexpr Bounded unknown{NAN, NAN, NAN};

std::string class_text(const Verdict& v) {
    if (v.best == v.worst) return class_name(v.best);
    return fmt::format("undecided: {} to {}", class_name(v.best), class_name(v.worst));
}

std::string show(const Hour& h, const std::string& command) {
    return with_option(command, "-hours " + name_of(h.time));
}

std::string hours_so_far(size_t hours, size_t to_come) {
    return to_come ? fmt::format("{} of {}", hours, hours + to_come) : std::to_string(hours);
}

// The end of the line of hours.
std::string missing_text(size_t hours) { return hours ? fmt::format(", {} without values\n", hours) : "\n"; }

std::string five_lines(const View& view, const Verdict& v, const std::string& command) {
    std::string text = v.view.empty() ? "" : v.view + "\n";
    text += fmt::format("hours     {}, {} dark, {} undecided", hours_so_far(v.hours, v.to_come), v.dark, v.undecided) +
            missing_text(v.missing);
    text += fmt::format("above     0.35: {}   0.40: {}   0.45: {}\n", count_text(v.above[0]), count_text(v.above[1]),
                        count_text(v.above[2]));
    text += fmt::format("DGPe5     {:.3f} ({:.3f} to {:.3f}): EN 17037 {}{}\n", v.exceeded.value, v.exceeded.low,
                        v.exceeded.high, class_text(v), v.to_come ? ", of these hours alone" : "");
    text += fmt::format("autonomy  {} of the hours are not above 0.40\n", percent_text(v.autonomy));
    for (const Hour& h : worst_hours(view, 1))
        text += fmt::format("worst     {:.3f}: {}\n", h.dgp.value, show(h, command));
    return text;
}

void add(report::Line& line, const std::string& name, const Bounded& b) {
    report::add_bounds(line, name, b.value, b.low, b.high);
}

void add_useful(report::Line& line, const Useful& u) {
    add(line, "UDI_below", u[below]), add(line, "UDI_supplementary", u[supplementary]);
    add(line, "UDI_autonomous", u[autonomous]), add(line, "UDI_exceeded", u[exceeded]);
}

}  // namespace

std::string with_option(const std::string& command, const std::string& option) {
    const size_t first = command.find(' ');
    if (first == std::string::npos || base::ends_with(command, "...")) return command + " " + option;
    return command.substr(0, first + 1) + option + command.substr(first);
}

std::string count_text(const Bounded& n) {
    return n.low == n.high ? fmt::format("{:.0f}", n.value)
                           : fmt::format("{:.0f} ({:.0f} to {:.0f})", n.value, n.low, n.high);
}

std::string percent_text(const Bounded& s) {
    std::string text = fmt::format("{:.1f} %", 100 * s.value);
    if (s.low < s.high) text += fmt::format(" ({:.1f} to {:.1f})", 100 * s.low, 100 * s.high);
    return text;
}

std::string summary(const std::vector<View>& views, const std::vector<Verdict>& verdicts, const std::string& command) {
    std::string text;
    for (size_t k = 0; k < views.size(); ++k) text += five_lines(views[k], verdicts[k], command);
    if (views.size() > 1)
        text += fmt::format("all {} views: sGA {} have an autonomy of 95 %\n", views.size(),
                            percent_text(spatial_autonomy(verdicts)));
    return text;
}

std::string rest_line(size_t to_come, const std::string& command, const std::vector<std::string>& tables) {
    if (to_come == 0) return "";
    std::vector<std::string> words;
    for (const std::string& table : tables) words.insert(words.end(), {"-after", table == "-" ? "hours.tsv" : table});
    return "the rest  " + with_option(command, base::command_line(words)) + "\n";
}

report::Line line_of(const Verdict& v) {
    report::Line line;
    report::add(line, "view", report::text_cell(v.view.empty() ? "-" : v.view));
    report::add(line, "hours", double(v.hours)), report::add(line, "dark", double(v.dark));
    report::add(line, "undecided", double(v.undecided));
    add(line, "above_0.35", v.above[0]), add(line, "above_0.40", v.above[1]), add(line, "above_0.45", v.above[2]);
    add(line, "DGPe5", v.exceeded), add(line, "GA", v.autonomy);
    report::add(line, "class", report::text_cell(v.best == v.worst ? class_name(v.best) : "undecided"));
    report::add(line, "class.best", report::text_cell(class_name(v.best)));
    report::add(line, "class.worst", report::text_cell(class_name(v.worst)));
    report::add(line, "to_come", double(v.to_come));
    return line;
}

std::string worst_lines(const std::vector<View>& views, size_t n, const std::string& command) {
    std::string text;
    for (const View& view : views)
        for (const Hour& h : worst_hours(view, n))
            text += fmt::format("{:.3f}\t{}\t{}\n", h.dgp.value, view.name.empty() ? "-" : view.name, show(h, command));
    return text;
}

std::string summary(const GridYear& y, const Goals& g) {
    std::string text = fmt::format("{}\nhours     {}, {} dark, {} sensors", y.name, hours_so_far(y.hours, y.to_come),
                                   y.dark, y.sensors.size()) +
                       missing_text(y.missing);
    text += fmt::format("DA        {} of the hours have {:g} lx, mean of the sensors\n", percent_text(y.autonomy),
                        g.autonomy_lux);
    text += fmt::format("cDA       {}, hours of less light by their share of it; DAmax {} have {:g} lx\n",
                        percent_text(y.credited), percent_text(y.excessive), excess_factor * g.autonomy_lux);
    text += fmt::format("sDA       {} of the sensors have {:g} lx in {:g} % of the hours\n", percent_text(y.spatial),
                        g.autonomy_lux, 100 * g.autonomy_share);
    text += fmt::format("UDI       {} below {:g} lx, {} supplementary, {} autonomous ({:g} to {:g} lx), {} exceeded\n",
                        percent_text(y.useful[below]), g.useful_lux[0], percent_text(y.useful[supplementary]),
                        percent_text(y.useful[autonomous]), g.useful_lux[1], g.useful_lux[2],
                        percent_text(y.useful[exceeded]));
    if (y.sun_hours)
        text += fmt::format("ASE       {} of the sensors have {:g} lx of sun in more than {:g} of {} hours\n",
                            percent_text(y.exposed), g.sun_lux, g.sun_hours, *y.sun_hours);
    return text;
}

report::Line line_of(const GridYear& y) {
    report::Line line;
    report::add(line, "grid", report::text_cell(y.name)), report::add(line, "sensors", double(y.sensors.size()));
    report::add(line, "hours", double(y.hours)), report::add(line, "dark", double(y.dark));
    add(line, "DA", y.autonomy), add(line, "sDA", y.spatial);
    add_useful(line, y.useful);
    add(line, "ASE", y.sun_hours ? y.exposed : unknown);
    add(line, "cDA", y.credited), add(line, "DAmax", y.excessive);
    report::add(line, "to_come", double(y.to_come));
    return line;
}

report::Line line_of(const GridYear& y, size_t sensor) {
    const SensorYear& s = y.sensors[sensor];
    report::Line line;
    report::add(line, "grid", report::text_cell(y.name)), report::add(line, "point", double(sensor));
    add(line, "DA", s.autonomy);
    add_useful(line, s.useful);
    add(line, "sun_hours", y.sun_hours ? s.sun_hours : unknown);
    add(line, "cDA", s.credited), add(line, "DAmax", s.excessive);
    return line;
}

}  // namespace year
