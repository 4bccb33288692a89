// SPDX-License-Identifier: BSD-3-Clause
// Days from the left to the right, hours from the top down: where an hour of the year stands in a heat map.  Where only
// some days have hours a column is as wide as they are apart.
#pragma once
#include <vector>

#include "display/canvas.h"
#include "weather/date.h"

namespace year {

class DayCells {
public:
    static constexpr int left = 40, day_width = 3, days = 366, width = left + days * day_width + 8;

    // Rows from the first of these hours to the last.
    explicit DayCells(const std::vector<weather::Time>& hours);
    int height() const { return (last_ - first_ + 1) * hour_height; }
    int wide_days() const { return wide_days_; }

    static int x_of(const weather::Date& date) { return left + (date.in_leap_year() - 1) * day_width; }
    // y0: of the first row.
    display::Rectangle at(const weather::Time& time, int y0, bool hatched) const;
    void add_clock(display::Canvas& canvas, int y0) const;

private:
    static constexpr int hour_height = 12;
    int first_ = 24, last_ = 0, wide_days_ = days;
};

}  // namespace year
