// SPDX-License-Identifier: BSD-3-Clause
// See shade_schedule.h.
#include "year/shade_schedule.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "weather/lines.h"
#include "year/honeybee_schedule.h"

namespace year {
namespace {

constexpr size_t clock_hours = 8784, clock_hours_of_365 = 8760, before_leap_day = 24 * (weather::leap_day - 1);
constexpr double most = 63;  // states

bool is_a_number(const std::string& text) {
    double v;
    return base::parse_real(text, v);
}

size_t clock_hour(const weather::Time& time) {
    return 24 * size_t(time.date.in_leap_year() - 1) + std::min<size_t>(size_t(time.hour), 23);
}

char separator_of(const std::string& line) {
    for (const char c : {'\t', ','})
        if (line.find(c) != std::string::npos) return c;
    return ' ';
}

// month,day,hour,number
void add_daysims(const weather::Lines& in, std::vector<size_t>& numbers) {
    const weather::Date date{in.whole(0, "the month", 1, 12), in.whole(1, "the day", 1, 31)};
    if (!weather::is_date(date.month, date.day)) in.fail("this month has fewer days");
    numbers.resize(clock_hours);
    numbers[clock_hour({date, in.number(2, "the hour", 0, 23.999)})] = size_t(in.whole(3, "the state", 0, int(most)));
}

// 29 February repeats the day before.
std::vector<size_t> of_leap_year(std::vector<size_t> values, const std::string& path) {
    const auto leap_day = values.begin() + long(std::min(values.size(), before_leap_day));
    if (values.size() == clock_hours_of_365) {
        const std::vector<size_t> before(leap_day - 24, leap_day);
        values.insert(leap_day, before.begin(), before.end());
    }
    if (values.size() != clock_hours)
        base::fail(path, fmt::format("has {} numbers, not {} or {}", values.size(), clock_hours_of_365, clock_hours));
    return values;
}

}  // namespace

ShadeSchedule read_shade_schedule(const std::string& path, const std::string& group) {
    ShadeSchedule s;
    std::vector<size_t> values;
    if (auto numbers = read_honeybee_schedule(path, group)) {
        s.numbers = of_leap_year(std::move(*numbers), path);
        return s;
    }
    weather::Lines in(path);
    for (bool first = true; in.next(); first = false) {
        if (in.text()[0] == '#') continue;
        in.split(separator_of(in.text()));
        const std::string& word = in.field(0, "an hour");
        const auto time = in.fields() > 1 ? weather::parse_name(word) : std::nullopt;
        if (time && time->hour >= 0) {
            const bool has_group = in.fields() > 2;
            if (!has_group || in.field(1, "the group") == (group.empty() ? "-" : group))
                s.states[time->minute_of_year()] = in.field(has_group ? 2 : 1, "the state");
        } else if (in.fields() == 1 && is_a_number(word)) {
            values.push_back(size_t(in.whole(0, "the state", 0, int(most))));
        } else if (in.fields() > 3 && is_a_number(word)) {
            add_daysims(in, s.numbers);
        } else if (!first) {
            in.fail("\"" + base::excerpt(word) + "\" is neither the name of an hour with a state nor a number");
        }
        if (values.size() > clock_hours) in.fail("more numbers than a year has hours");
    }
    if (!values.empty()) s.numbers = of_leap_year(std::move(values), path);
    return s;
}

size_t state_at(const ShadeSchedule& s, const weather::Time& time, const std::vector<std::string>& states,
                const std::string& place) {
    const std::string hour = name_of(time);
    if (const auto found = s.states.find(time.minute_of_year()); found != s.states.end()) {
        const auto state = std::find(states.begin(), states.end(), found->second);
        if (state == states.end()) base::fail(place, hour + ": no state is called \"" + found->second + "\"");
        return size_t(state - states.begin());
    }
    if (s.numbers.empty()) return 0;
    const size_t number = s.numbers[clock_hour(time)];
    if (number >= states.size())
        base::fail(place, fmt::format("{}: state {} of {}, which count from 0", hour, number, states.size()));
    return number;
}

}  // namespace year
