// SPDX-License-Identifier: BSD-3-Clause
// See en17037_text.h.
#include "year/en17037_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "year/text.h"

namespace year {
namespace {

std::string have(const Provision& p, const Demand& d) {
    return fmt::format("{:g} lx on {}", provision_lux[d.lux], percent_text(p.plane[d.lux]));
}

void add_levels(report::Line& line, const std::string& name, int low, int high) {
    report::add(line, name, report::text_cell(low == high ? level_name(low) : "undecided"));
    report::add(line, name + ".best", report::text_cell(level_name(high)));
    report::add(line, name + ".worst", report::text_cell(level_name(low)));
}

void add_shares(report::Line& line, const std::string& name, const DaylightShares& shares) {
    for (size_t k = 0; k < shares.size(); ++k)
        report::add_bounds(line, fmt::format("{}_{:g}", name, provision_lux[k]), shares[k].value, shares[k].low,
                           shares[k].high);
}

}  // namespace

std::string level_words(int low, int high) {
    return low == high ? level_name(low) : fmt::format("undecided, {} to {}", level_name(low), level_name(high));
}

std::string sun_hours_words(const Bounded& h) {
    return fmt::format("{:.2f} h", h.value) + (h.low < h.high ? fmt::format(" ({:.2f} to {:.2f})", h.low, h.high) : "");
}

std::string lacks_words(const Provision& p, int level) {
    std::string text;
    for (const Demand& d : demands(level, p.rooflight))
        if (!is_met(d, p.plane[d.lux].low))
            text += fmt::format("{} {} where {:g} % are asked", text.empty() ? "" : ",", have(p, d), 100 * d.share);
    return std::string(level_name(level)) + ":" + text;
}

std::string lines_of(const Provision& p) {
    std::string reached;
    for (const Demand& d : demands(std::max(p.level, 1), p.rooflight))
        reached += (reached.empty() ? "" : ", ") + have(p, d);
    const std::string line = fmt::format("provision EN 17037 {}: {} of the sensors in half of {} daylight hours\n",
                                         level_words(p.low, p.high), reached, p.hours);
    return p.low < highest_level ? line + "lacks     for " + lacks_words(p, p.low + 1) + "\n" : line;
}

void add(report::Line& line, const Provision& p) {
    add_levels(line, "provision", p.low, p.high);
    add_shares(line, "plane", p.plane);
}

void add(report::Line& line, const DaylightShares& sensor) { add_shares(line, "daylight", sensor); }

std::string line_of(const Sunlight& s) {
    const std::string best = s.days > 1 ? fmt::format(", the best of {} days", s.days) : "";
    return fmt::format("sunlight  EN 17037 {}: {} on {}{}, sun at {:g} degrees or more, steps of {:g} min\n",
                       level_words(s.low, s.high), sun_hours_words(s.hours), day_text(s.date), best, s.lowest_deg,
                       s.step_min);
}

void add(report::Line& line, const Sunlight& s) {
    add_levels(line, "sunlight", s.low, s.high);
    report::add(line, "day", report::text_cell(day_text(s.date)));
    report::add_bounds(line, "sunlight_hours", s.hours.value, s.hours.low, s.hours.high);
}

}  // namespace year
