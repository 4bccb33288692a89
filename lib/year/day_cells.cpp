// SPDX-License-Identifier: BSD-3-Clause
// See day_cells.h.
#include "year/day_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace year {

// The fewest days from one that has hours to the next: as many are a column's width, so that single days are seen.
DayCells::DayCells(const std::vector<weather::Time>& hours) {
    std::set<int> days_with_hours;
    for (const weather::Time& t : hours) {
        first_ = std::min(first_, int(t.hour)), last_ = std::max(last_, int(t.hour));
        days_with_hours.insert(t.date.in_leap_year());
    }
    int before = 0;
    for (const int day : days_with_hours) {
        if (before > 0) wide_days_ = std::min(wide_days_, day - before);
        before = day;
    }
    if (wide_days_ == days) wide_days_ = 1;
}

display::Rectangle DayCells::at(const weather::Time& time, int y0, bool hatched) const {
    const int wide = wide_days_ * day_width, x = x_of(time.date) - (wide - day_width) / 2, x0 = std::max(left, x),
              x1 = std::min(left + days * day_width, x + wide);
    return {x0, y0 + (int(time.hour) - first_) * hour_height, x1 - x0, hour_height, hatched};
}

void DayCells::add_clock(display::Canvas& c, int y0) const {
    for (int hour = first_; hour <= last_; hour += 2)
        c.words.push_back({8, y0 + (hour - first_) * hour_height - 5, fmt::format("{}", hour)});
}

}  // namespace year
