// SPDX-License-Identifier: BSD-3-Clause
// See leed.h.
#include "year/leed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "year/sensor_counts.h"
#include "year/text.h"

namespace year {
namespace {

constexpr std::array<double, 3> shares_of_points{.40, .55, .75};
constexpr double of_each_space = .55, glare_share = .10;
constexpr size_t hours_of_lm83 = 3650;  // 8 to 18 of every day

int earned(double share) {
    return int(std::count_if(shares_of_points.begin(), shares_of_points.end(),
                             [&](double least) { return share >= least - count_rounding; }));
}

std::string counted(int low, int high, const std::string& one) {
    return low == high ? fmt::format("{} {}{}", low, one, low == 1 ? "" : "s")
                       : fmt::format("{} to {} {}s", low, high, one);
}

}  // namespace

Leed judge_leed(const std::vector<GridYear>& spaces, const Goals& goals) {
    const Goals asked;
    if (goals.autonomy_lux != asked.autonomy_lux || goals.autonomy_share != asked.autonomy_share ||
        goals.sun_lux != asked.sun_lux || goals.sun_hours != asked.sun_hours)
        base::fail("-leed", "asks 300 lx in 50 % of the hours and 1000 lx in 250 (-sda, -ase)");
    Leed out;
    out.each = out.each_maybe = true;
    for (const GridYear& y : spaces) out.sensors += y.sensors.size();
    for (const GridYear& y : spaces) {
        const double weight = double(y.sensors.size()) / double(out.sensors);
        out.spatial.value += weight * y.spatial.value;
        out.spatial.low += weight * y.spatial.low, out.spatial.high += weight * y.spatial.high;
        out.each = out.each && y.spatial.low >= of_each_space - count_rounding;
        out.each_maybe = out.each_maybe && y.spatial.high >= of_each_space - count_rounding;
        out.spaces.push_back({y.name, y.spatial, y.sun_hours && y.exposed.high > glare_share + count_rounding});
        if (y.hours != hours_of_lm83)
            out.lacks.push_back(
                fmt::format("{} has {} hours, not the {} from 8 to 18", y.name, y.hours, hours_of_lm83));
        if (!y.sun_hours) out.lacks.push_back(y.name + " has no direct sun (-direct)");
    }
    out.points = earned(out.spatial.value);
    out.low = earned(out.spatial.low), out.high = earned(out.spatial.high);
    return out;
}

std::string lines_of(const Leed& l) {
    std::string text =
        fmt::format("LEED v4.1 option 1: {}, sDA {} of {} sensors in {}\n", counted(l.low, l.high, "point"),
                    percent_text(l.spatial), l.sensors, counted(int(l.spaces.size()), int(l.spaces.size()), "space"));
    text +=
        fmt::format("each      {} of the spaces have 55 %: {}\n",
                    std::count_if(l.spaces.begin(), l.spaces.end(),
                                  [](const LeedSpace& s) { return s.spatial.low >= of_each_space - count_rounding; }),
                    l.each         ? "a point more, or exemplary"
                    : l.each_maybe ? "undecided"
                                   : "no point more");
    std::string glare;
    for (const LeedSpace& s : l.spaces)
        if (s.glare) glare += (glare.empty() ? "" : ", ") + s.name;
    if (!glare.empty()) text += "glare     ASE above 10 %, say what is done about it: " + glare + "\n";
    for (const std::string& what : l.lacks) text += "lacks     " + what + "\n";
    return text;
}

}  // namespace year
