// SPDX-License-Identifier: BSD-3-Clause
// See page_about.h.
#include "report/page_about.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "base/angle.h"
#include "base/printable.h"
#include "base/split.h"
#include "report/table.h"

namespace report {

using base::escaped;

std::string about_list(const Page& page) {
    std::string out;
    for (const auto& [name, text] : page.about)
        out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(text));
    return out.empty() ? "" : "<dl class=\"about\">\n" + out + "</dl>\n";
}

std::string criteria_table(const Page& page) {
    if (page.criteria.empty()) return "";
    std::string out =
        "<h2>Criteria</h2>\n<table class=\"numbers\"><thead><tr><th>Criterion</th><th></th><th></th><th>Value</th>"
        "</tr></thead><tbody>\n";
    for (const Criterion& c : page.criteria) {
        double value = NAN, low = NAN, high = NAN;
        for (const auto* numbers : {&page.numbers, &page.plan.numbers})
            for (const Page::Number& n : *numbers)
                if (n.name == c.metric) value = n.value, low = n.low, high = n.high;
        const bool known = std::isfinite(low) && std::isfinite(high);
        const auto shown = [half = (high - low) / 2](double v) { return rounded(v, half); };
        std::string words = "this report has no such number";
        if (std::isfinite(value) && known) words = shown(value) + " (" + shown(low) + " to " + shown(high) + ")";
        else if (std::isfinite(value)) words = rounded(value, NAN) + ", without an interval";
        out += fmt::format("<tr><td>{}</td><td>{} at {} {:g}</td><td>{}</td><td>{}</td></tr>\n",
                           escaped(c.name.empty() ? c.metric : c.name), escaped(c.metric), c.at_most ? "most" : "least",
                           c.limit, judged(c, value, low, high), words);
    }
    return out + "</tbody></table>\n";
}

// "Ev 1704 (1696 to 1712)"; "Ev.d -1142 ..." is a change; what pixels add is of no use here.
static std::string line_of_variant(const std::string& line) {
    const size_t end = line.find(' '), dot = line.substr(0, end).rfind('.');
    if (end == std::string::npos || dot == std::string::npos) return "<br>" + escaped(line);
    const std::string name = line.substr(0, dot), kind = line.substr(dot, end - dot);
    if (kind == ".px" || base::ends_with(name, ".px")) return "";
    return "<br>" + escaped(kind == ".d" ? name + " changed by" + line.substr(end) : line);
}

std::string variants_and_day(const Page& page) {
    std::string out;
    for (const Page::Variant& v : page.variants) {
        out += fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption><b>{0}</b>",
                           escaped(v.name), base::base64(v.png));
        for (const std::string& line : v.lines) out += line_of_variant(line);
        out += "</figcaption></figure>\n";
    }
    if (!out.empty())
        out =
            "<h2>Variants</h2>\n<p class=\"note\">Luminances in the scale above; changes are from what edits are "
            "compared "
            "with.</p>\n<div class=\"drawings variants\">\n" +
            out + "</div>\n";
    if (page.day.empty()) return out;
    out += "<h2>The day</h2>\n<table class=\"numbers\"><tbody>\n";
    for (const std::string& line : page.day) out += "<tr><td>" + escaped(line) + "</td></tr>\n";
    return out + "</tbody></table>\n";
}

const char* month_word(int month) {
    static const char* const words[] = {"January", "February", "March",     "April",   "May",      "June",
                                        "July",    "August",   "September", "October", "November", "December"};
    return month >= 1 && month <= 12 ? words[month - 1] : "";
}

std::string hour_words(const std::vector<std::string>& sky) {
    for (const std::string& line : sky) {
        size_t at = line.find("gensky ");
        if (at == std::string::npos) at = line.find("gendaylit ");
        int month = 0, day = 0, minutes = 0;
        char word[16] = "";
        if (at == std::string::npos || std::sscanf(line.c_str() + at, "%*s %d %d %15s", &month, &day, word) != 3)
            continue;
        const bool solar = word[0] == '+';
        double hour = 0;
        if (std::sscanf(word + solar, "%lf:%d", &hour, &minutes) < 1 || !(hour >= 0 && hour <= 24)) continue;
        const long all = std::lround(60 * hour) + minutes;
        if (*month_word(month))
            return fmt::format("{} {}, {}:{:02}{}", day, month_word(month), all / 60, all % 60,
                               solar ? " solar time" : "");
    }
    return "";
}

std::string where_and_when(const Page& page) {
    const base::Vec3 d = base::unit(page.view.vd);
    const double north = std::atan2(d.x, d.y) / base::degree;
    std::string out = d.z > .9 ? "The eye looks up" : "The eye looks down";
    if (std::fabs(d.z) <= .9)
        out = fmt::format(
            "The eye looks {} (north, if ahead is up: <svg class=\"compass\" viewBox=\"-8 -8 16 16\" role=\"img\" "
            "aria-label=\"{:.0f} degrees\"><path transform=\"rotate({:.0f})\" d=\"M0 7V-6M-4 -2L0 -7L4 -2\"/></svg>)",
            compass_word(north), -north, -north);
    const std::string hour = hour_words(page.sky);
    return "<p class=\"note\">" + out + (hour.empty() ? "" : ", on " + hour) + ".</p>\n";
}

const char* compass_word(double degrees) {
    static const char* const words[] = {"north", "north-east", "east", "south-east",
                                        "south", "south-west", "west", "north-west"};
    return words[size_t(std::lround(degrees / 45) % 8 + 8) % 8];
}

}  // namespace report
