// SPDX-License-Identifier: BSD-3-Clause
// See daylight_hours.h.
#include "year/daylight_hours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/error.h"
#include "weather/light.h"

namespace year {
namespace {

bool has_diffuse(const weather::Hour& h) { return h.diffuse_wm2 >= 0 && h.diffuse_wm2 <= weather::most_wm2; }

double diffuse_of(const weather::Weather& year, const weather::Hour& h) {
    if (has_diffuse(h)) return h.diffuse_wm2;
    if (lacks_values(year, h)) base::fail(year.place_of(h), "has no diffuse irradiance, by which daylight hours count");
    return 0;
}

void require_year(const weather::Weather& year) {
    const double days = double(year.hours.size()) * year.step_min / (24 * 60);
    if (days != 365 && days != 366)
        base::fail(year.path, fmt::format("has {:g} days of hours; EN 17037 counts those of a year", days));
}

}  // namespace

DaylightHours daylight_hours(const weather::Weather& year) {
    require_year(year);
    std::vector<std::pair<double, const weather::Hour*>> brightest;
    for (const weather::Hour& h : year.hours) brightest.emplace_back(diffuse_of(year, h), &h);
    std::stable_sort(brightest.begin(), brightest.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    DaylightHours out;
    out.path = year.path;
    out.hours = year.hours.size() / 2;
    for (size_t k = 0; k < out.hours; ++k) {
        const weather::Hour& h = *brightest[k].second;
        const bool is_lit = lacks_values(year, h) || light_of(year, h);
        (is_lit ? out.lit : out.dark).push_back(h.time);
    }
    const auto earlier = [](const weather::Time& a, const weather::Time& b) {
        return a.minute_of_year() < b.minute_of_year();
    };
    for (const weather::Hour& h : year.hours)
        if (h.direct_wm2 == 0 && h.diffuse_wm2 == 0) out.unlit.push_back(h.time.minute_of_year());
    std::sort(out.unlit.begin(), out.unlit.end());
    std::sort(out.lit.begin(), out.lit.end(), earlier);
    std::sort(out.dark.begin(), out.dark.end(), earlier);
    return out;
}

std::vector<size_t> hours_in(const DaylightHours& daylight, const Grid& grid) {
    std::unordered_map<int, size_t> at;
    for (size_t i = 0; i < grid.hours.size(); ++i) {
        const GridHour& h = grid.hours[i];
        const int minute = h.time.minute_of_year();
        at[minute] = i;
        if (std::binary_search(daylight.unlit.begin(), daylight.unlit.end(), minute) && !is_dark(h) && !is_missing(h))
            base::fail(grid.name, name_of(h.time) + " has light, for which " + daylight.path +
                                      " has none: the table is of another weather file");
    }
    std::vector<size_t> found;
    std::vector<const weather::Time*> missing;
    for (const weather::Time& time : daylight.lit) {
        const auto hour = at.find(time.minute_of_year());
        if (hour == at.end()) missing.push_back(&time);
        else found.push_back(hour->second);
    }
    if (!missing.empty())
        base::fail(grid.name, fmt::format("lacks {} of the {} hours that have the most diffuse light in {}, {} first: "
                                          "EN 17037 counts those of the whole year",
                                          missing.size(), daylight.hours, daylight.path, name_of(*missing.front())));
    return found;
}

}  // namespace year
