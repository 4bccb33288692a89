// SPDX-License-Identifier: BSD-3-Clause
// See page.h.
#include "year/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>

#include "base/printable.h"
#include "report/page_style.h"
#include "weather/light.h"
#include "year/plot.h"
#include "year/text.h"

namespace year {
namespace {

using base::escaped;

constexpr size_t few_days = 200;  // of fewer ones the class is told to be theirs
constexpr const char* style = R"(
.class0 { color: #1d7a4c; } .class1 { color: #8a7200; } .class2 { color: #c05a00; } .class3 { color: #aa1432; }
.verdicts td { font-variant-numeric: tabular-nums; white-space: normal; }
.verdicts small { color: var(--soft); display: block; }
.verdicts td:nth-child(2) { font-weight: 600; } .verdicts td:first-child, .verdicts small { white-space: nowrap; }
.parts td, .parts th:first-child { white-space: normal; } .parts small { color: var(--soft); display: block; }
.parts td:nth-child(2) { font-weight: 600; } .parts td:nth-child(4) { font-size: 8.5pt; width: 36%; }
.parts td { overflow-wrap: normal; } .parts td:nth-child(3) { width: 19%; }
.room .arrow { fill: currentColor; } .room path { stroke: currentColor; }
.room text { paint-order: stroke; stroke: #fff; stroke-width: .2em; font-weight: 600; text-anchor: start; }
.beside { display: flex; gap: 14px; align-items: flex-start; }
.hours { display: grid; grid-template-columns: repeat(auto-fill, minmax(38mm, 1fr)); gap: 8px; }
.hours img { width: 100%; }
.map svg { height: auto; } .map svg text { text-anchor: start; } .map a path { cursor: pointer; }
.map a:hover path, .map a:focus path { fill: #fffa; stroke: #000; }
.command span { display: none; } .command span:target { display: inline; font-weight: 600; }
figure:target { outline: 3px solid #1c1c1c; }
@media (max-width: 600px) { .beside { display: block; } }
@media print { .command { display: none; } }
)";

size_t days_of(const View& view) {
    std::set<int> days;
    for (const Hour& h : view.hours) days.insert(h.time.date.in_leap_year());
    return days.size();
}

std::string thousands(size_t n) {
    std::string text = std::to_string(n);
    for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(size_t(at), ",");
    return text;
}

std::string hours_of(const Verdict& v) {
    return thousands(v.hours) + (v.to_come ? " of " + thousands(v.hours + v.to_come) : "") + " hours";
}

// "class of 12 days": of what the class is where it is not of a year.
std::string class_of_what(const Page& page) {
    std::string text = "Class of EN 17037";
    const size_t days = days_of(page.views[0]);
    if (days < few_days) text += fmt::format(", of {} days", days);
    if (page.verdicts[0].to_come) text += ", of a year that was cut off";
    return text;
}

std::string between(const Bounded& b, double scale, int digits, const char* unit) {
    const std::string value = fmt::format("{:.{}f}{}", scale * b.value, digits, unit);
    if (b.low == b.high) return value;
    return value + fmt::format("<small>{:.{}f} to {:.{}f}</small>", scale * b.low, digits, scale * b.high, digits);
}

std::string verdict_table(const Page& page) {
    std::string out = fmt::format(
        "<table class=\"verdicts\"><thead><tr><th>View</th><th>{}</th><th>DGPe5</th><th>Hours above 0.40</th>"
        "<th>Undecided hours</th><th>Not above 0.40</th></tr></thead><tbody>\n",
        class_of_what(page));
    std::vector<size_t> order(page.views.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return page.verdicts[a].exceeded.value < page.verdicts[b].exceeded.value;
    });
    for (const size_t k : order) {
        const Verdict& v = page.verdicts[k];
        const std::string words = v.best == v.worst
                                      ? class_name(v.worst)
                                      : fmt::format("undecided: {} to {}", class_name(v.best), class_name(v.worst));
        out += fmt::format(
            "<tr><td>{}</td><td class=\"class{}\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escaped(v.view.empty() ? "the view" : v.view), v.worst, words, between(v.exceeded, 1, 3, ""),
            between(v.above[1], 1, 0, ""), v.undecided, between(v.autonomy, 100, 1, " %"));
    }
    return out + fmt::format(
                     "</tbody></table>\n<p class=\"note\">At most 5 % of the hours are above DGPe5: up to 0.35 is the "
                     "class high, 0.40 medium, 0.45 minimum. An hour is undecided where its interval holds one of "
                     "these. Small: the {:g} % interval.</p>\n",
                     100 * page.certainty);
}

std::string body_clocks(const Page& page) {
    std::string out;
    for (const BodyClock& c : page.clocks) out += (out.empty() ? "" : "; ") + escaped(words_of_view(c));
    if (out.empty()) return out;
    return "<p class=\"clock\">Daylight for the body clock, melanopic EDI at the eye: " + out + ".</p>\n";
}

std::string commands(const Page& page) {
    constexpr const char* name = "HOUR";
    const std::string command = escaped(with_option(page.command, std::string("-hours ") + name));
    const size_t at = command.find(name), end = at + std::strlen(name);
    std::string out;
    for (size_t k = 0; k < page.views.size(); ++k) {
        const View& view = page.views[k];
        out += fmt::format("<p class=\"command\">{}{}: <code>{}", view.name.empty() ? "" : escaped(view.name) + ", ",
                           "command of the hour that is clicked", command.substr(0, at));
        for (const Hour& h : view.hours)
            if (!picture_of(page, view.name, h.time))
                out += fmt::format("<span id=\"{}\">{}</span>", place_of(k, h.time), weather::name_of(h.time));
        out += command.substr(end) + "</code></p>\n";
    }
    return out;
}

void add_fact(std::string& list, const char* name, const std::string& html) {
    if (!html.empty()) list += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html);
}

// Which hours count, and what the file has besides.
std::string counted_hours(const Page& page) {
    const View& view = page.views[0];
    const Verdict& v = page.verdicts[0];
    double first = 24, last = 0;
    for (const Hour& h : view.hours) first = std::min(first, h.time.hour), last = std::max(last, h.time.hour);
    std::string text = fmt::format(
        "{} of {} days, from {} to {}, the first at {:02}:{:02}, the last at {:02}:{:02} (their middles, standard "
        "time); {} "
        "dark ones count as free of glare",
        hours_of(v), days_of(view), weather::day_text(view.hours.front().time.date),
        weather::day_text(view.hours.back().time.date), int(first), int(std::lround(60 * first)) % 60, int(last),
        int(std::lround(60 * last)) % 60, thousands(v.dark));
    if (v.missing) text += fmt::format(", {} without values count as undecided", thousands(v.missing));
    if (!page.weather) return text;
    std::set<int> there;
    for (const Hour& h : view.hours) there.insert(h.time.minute_of_year());
    size_t left_out = 0, lit = 0;
    for (const weather::Hour& h : page.weather->hours)
        if (!there.count(h.time.minute_of_year())) ++left_out, lit += h.direct_wm2 + h.diffuse_wm2 > 0;
    return text +
           fmt::format(". Left out: {} hours of the file, {} of them with light", thousands(left_out), thousands(lit));
}

std::string place_text(const weather::Weather& w) {
    return escaped(w.place) + fmt::format(", {:.2f}° {}, {:.2f}° {}, UTC{:+g}", std::fabs(w.latitude_deg),
                                          w.latitude_deg < 0 ? "south" : "north", std::fabs(w.longitude_deg),
                                          w.longitude_deg < 0 ? "east" : "west", -w.meridian_deg / 15 + 0.);
}

std::string weather_text(const weather::Weather& w) {
    std::string text = escaped(w.path.substr(w.path.rfind('/') + 1));
    text += w.source.empty() ? "; it states no source" : "; its source: " + escaped(w.source);
    for (const std::string& comment : w.comments) text += "<br>" + escaped(comment);
    return text;
}

std::string lines(const std::vector<std::string>& all) {
    std::string out;
    for (const std::string& line : all) out += "<code>" + escaped(line) + "</code>\n";
    return out;
}

std::string origin(const Page& page) {
    std::string list;
    if (page.weather)
        add_fact(list, "Place", place_text(*page.weather)), add_fact(list, "Weather", weather_text(*page.weather));
    add_fact(list, "Hours", counted_hours(page));
    add_fact(
        list, "Method",
        fmt::format(
            "DGPf of each hour with a sun and a sky of its own (Perez) from the file's irradiances, nothing "
            "interpolated; {}. Intervals of {:g} % cover noise and pixels, not the model, the weather, or how people "
            "differ from the formula.",
            page.views[0].shared ? "hours share one set of paths and are counted in half-samples"
                                 : "each hour has paths of its own",
            100 * page.certainty));
    add_fact(list, "Model", lines({page.command}));
    std::vector<std::string> made;
    for (const image::Picture& p : page.pictures)
        for (const std::string& line : p.header.lines)
            if (line.find("ptrace ") != std::string::npos && std::find(made.begin(), made.end(), line) == made.end())
                made.push_back(line);
    add_fact(list, "Pictures", lines(made));
    std::string files;
    for (const std::string& file : page.files) files += (files.empty() ? "" : ", ") + file;
    add_fact(list, "Files", lines({files}));
    add_fact(list, "Program", escaped(page.version));
    return "<h2>What it rests on</h2>\n<dl>\n" + list + "</dl>\n";
}

}  // namespace

std::string page_text(const Page& page) {
    const size_t days = days_of(page.views[0]);
    const std::string glare = fmt::format("Glare in {} of {}", hours_of(page.verdicts[0]),
                                          days < few_days ? fmt::format("{} days", days) : "a year"),
                      heading = page.parts.any() ? "Daylight and glare by EN 17037" : glare,
                      title = page.title.empty() && page.weather ? page.weather->place : page.title;
    const auto link = [&](size_t view, const Hour& h) { return "#" + place_of(view, h.time); };
    std::string out = fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0}</title>\n<style>{1}{2}</style>\n</head>\n<body>\n<section>\n<h1>{0}</h1>\n"
        "<p class=\"title\">{3}</p>\n",
        heading, report::page_style, style, escaped(title));
    if (page.parts.any()) out += parts_table(page.parts, page.verdicts, page.certainty) + "<h2>" + glare + "</h2>\n";
    out += verdict_table(page) + body_clocks(page) + shades_section(page);
    const std::string plan = plan_figure(page), hours = hour_figures(page);
    if (!plan.empty()) out += "<h2>Plan</h2>\n" + plan;
    if (!hours.empty()) out += "<h2>Hours as the views see them</h2>\n" + hours;
    out += "</section>\n<section>\n<h2>Days by hours</h2>\n<div class=\"map\">" +
           plot_text(page.views, 1 - page.certainty, page.shades ? &*page.shades : nullptr, link) + "</div>\n" +
           commands(page);
    return out + origin(page) + "</section>\n</body>\n</html>\n";
}

}  // namespace year
