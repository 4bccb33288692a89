// SPDX-License-Identifier: BSD-3-Clause
// See sunlight.h.
#include "year/sunlight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "weather/sky.h"
#include "year/sensor_counts.h"

namespace year {
namespace {

// Is the sun's centre seen?  Where frames sample its whole disc (ptrace -dj 1) and some of them miss it, maybe.
enum class Seen { no, maybe, yes };
Seen seen_by(const Lux& direct) {
    constexpr double noise_of_angles = .02;  // of the cosine and the pane across a disc of half a degree
    if (std::isnan(direct.value)) return Seen::maybe;
    if (!(direct.value > 0)) return Seen::no;
    return direct.error > noise_of_angles * direct.value ? Seen::maybe : Seen::yes;
}

Seen seen_by(const GridHour& step, const std::vector<size_t>& points) {
    Seen most = Seen::no;
    for (const size_t i : points) most = std::max(most, seen_by(step.sensors[i]));
    return most;
}

void require_date(const weather::Weather& day, const weather::Hour& step) {
    const int minute = step.time.date.month * 100 + step.time.date.day;
    if (minute < 201 || minute > 321)
        base::fail(day.place_of(step), day_text(step.time.date) + ": EN 17037 takes a day from 1 February to 21 March");
}

// Steps of a date that count, the sun being high enough; they follow each other, and none lacks at either end.
std::vector<weather::Time> steps_of(const weather::Weather& day, const weather::Date& date, double lowest_deg) {
    std::vector<const weather::Hour*> of_date;
    for (const weather::Hour& h : day.hours)
        if (h.time.date.in_leap_year() == date.in_leap_year()) of_date.push_back(&h);
    const auto is_high = [&](weather::Hour step, double later_min) {
        step.time.hour += later_min / 60;
        return sun_of(day, step).altitude_deg >= lowest_deg;
    };
    std::vector<weather::Time> steps;
    for (size_t k = 0; k < of_date.size(); ++k) {
        const weather::Hour& h = *of_date[k];
        const bool is_first = k == 0, is_last = k + 1 == of_date.size();
        const int next = is_last ? 0 : of_date[k + 1]->time.minute_of_year() - h.time.minute_of_year();
        const double step = day.step_min;
        if ((is_first && is_high(h, -step)) || (is_last && is_high(h, step)) ||
            (!is_last && std::fabs(next - step) > .5 && is_high(h, step)))
            base::fail(day.place_of(h),
                       fmt::format("the sun is higher than {:g} degrees {} this step, where the file "
                                   "has none {:g} minutes away",
                                   lowest_deg, is_first && is_high(h, -step) ? "before" : "after", step));
        if (is_high(h, 0)) steps.push_back(h.time);
    }
    return steps;
}

int level_of_hours(double hours) {
    return int(std::count_if(sunlight_hours.begin(), sunlight_hours.end(),
                             [&](double least) { return hours >= least - count_rounding; }));
}

}  // namespace

Sunlight judge_sunlight(const Grid& grid, const std::vector<size_t>& points, const weather::Weather& day,
                        double lowest_deg) {
    constexpr double longest_step = 5;
    if (day.step_min > longest_step)
        base::fail(day.path, fmt::format("has steps of {:g} minutes: five or less are wanted", day.step_min));
    std::map<int, const GridHour*> table;
    for (const GridHour& h : grid.hours) table[h.time.minute_of_year()] = &h;
    std::map<int, weather::Date> dates;
    for (const weather::Hour& h : day.hours) require_date(day, h), dates[h.time.date.in_leap_year()] = h.time.date;
    Sunlight best;
    for (const auto& [number, date] : dates) {
        Bounded minutes;
        for (const weather::Time& step : steps_of(day, date, lowest_deg)) {
            const auto row = table.find(step.minute_of_year());
            if (row == table.end())
                base::fail(grid.name, "has no row of " + name_of(step) + ", which " + day.path + " has");
            const Seen seen = seen_by(*row->second, points);
            minutes.low += day.step_min * (seen == Seen::yes), minutes.high += day.step_min * (seen != Seen::no);
        }
        const Bounded hours{(minutes.low + minutes.high) / 120, minutes.low / 60, minutes.high / 60};
        if (best.days++ > 0 && hours.value <= best.hours.value) continue;
        best.date = date, best.hours = hours;
    }
    best.step_min = day.step_min, best.lowest_deg = lowest_deg;
    best.low = level_of_hours(best.hours.low), best.high = level_of_hours(best.hours.high);
    return best;
}

}  // namespace year
