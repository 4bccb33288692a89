// SPDX-License-Identifier: BSD-3-Clause
// See body_clock.h.
#include "year/body_clock.h"

#include <fmt/format.h>

#include <algorithm>

#include "year/autonomy.h"
#include "year/text.h"

namespace year {
namespace {

Bounded hours_of_share(const BodyClock& c, const Bounded& share) {
    const double n = double(c.hours);
    return {n * share.value, n * share.low, n * share.high};
}

void add_bounded(report::Line& line, const std::string& name, const Bounded& b) {
    report::add_bounds(line, name, b.value, b.low, b.high);
}

std::string column_of(const char* start, size_t k) { return fmt::format("{}{:g}", start, edi_limits[k]); }

}  // namespace

std::optional<BodyClock> judge_body_clock(const Tables& tables, const std::string& name, double asked_share,
                                          double alpha) {
    const auto found =
        std::find_if(tables.edi.begin(), tables.edi.end(), [&](const Grid& g) { return g.name == name; });
    if (found == tables.edi.end()) return std::nullopt;
    const Grid& grid = *found;
    BodyClock out{grid.name, grid.hours.size(), grid.sensors(), asked_share, {}, {}};
    for (size_t k = 0; k < edi_limits.size(); ++k) {
        Goals goals;
        goals.autonomy_lux = edi_limits[k], goals.autonomy_share = asked_share;
        const GridYear year = judge(grid, nullptr, goals, alpha);
        out.lit[k] = year.autonomy, out.of_sensors[k] = year.spatial;
    }
    return out;
}

std::string words_of_view(const BodyClock& c) {
    std::string text = c.name.empty() ? "" : c.name + ": ";
    for (size_t k = 0; k < edi_limits.size(); ++k)
        text += fmt::format("{}{:g} lx in {}", k ? ", " : "", edi_limits[k], count_text(hours_of_share(c, c.lit[k])));
    return text + fmt::format(" of {} hours", c.hours);
}

std::string line_of_view(const BodyClock& c) { return "mEDI      " + words_of_view(c) + "\n"; }

std::string line_of_sensors(const BodyClock& c) {
    std::string text = "mEDI      ";
    for (size_t k = 0; k < edi_limits.size(); ++k)
        text += fmt::format("{}{:g} lx in {} of the hours, in {:g} % of them at {} of the sensors", k ? "; " : "",
                            edi_limits[k], percent_text(c.lit[k]), 100 * c.asked_share, percent_text(c.of_sensors[k]));
    return text + "\n";
}

void add_view(report::Line& line, const BodyClock& c) {
    for (size_t k = 0; k < edi_limits.size(); ++k)
        add_bounded(line, column_of("mEDI_", k), hours_of_share(c, c.lit[k]));
}

void add_sensors(report::Line& line, const BodyClock& c) {
    for (size_t k = 0; k < edi_limits.size(); ++k) {
        add_bounded(line, column_of("mEDI_", k), c.lit[k]);
        add_bounded(line, column_of("smEDI_", k), c.of_sensors[k]);
    }
}

}  // namespace year
