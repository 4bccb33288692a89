// SPDX-License-Identifier: BSD-3-Clause
// See schedule.h.
#include "weather/schedule.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "weather/lines.h"

namespace weather {
namespace {

constexpr size_t hours_of_year = 8760, hours_of_leap_year = 8784;

bool is_number(const std::string& text) {
    double v;
    return base::parse_real(text, v);
}

// Values of a year without 29 February: that day repeats the day before.
std::vector<bool> with_leap_day(const std::vector<bool>& values) {
    std::vector<bool> all(values.begin(), values.begin() + 24 * (leap_day - 1));
    all.insert(all.end(), all.end() - 24, all.end());
    all.insert(all.end(), values.begin() + 24 * (leap_day - 1), values.end());
    return all;
}

bool is_list_of_hours(const std::vector<double>& numbers) {
    return !numbers.empty() && numbers.front() >= 0 && numbers.back() > 1 &&
           std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) == numbers.end();
}

// The hours of the weather in which these hours of the year lie, of which the last may be its end.
std::vector<int> hours_at(const std::vector<double>& numbers, const std::string& path, const Weather& w) {
    const bool leap = std::any_of(w.hours.begin(), w.hours.end(),
                                  [](const Hour& h) { return h.time.date.in_leap_year() == leap_day; });
    std::map<int, int> begins;  // minute of the leap year, and that of the hour's middle
    for (const Hour& h : w.hours) {
        const int middle = h.time.minute_of_year();
        begins[int(std::lround(middle - w.step_min / 2))] = middle;
    }
    std::vector<int> minutes;
    for (const double number : numbers) {
        double minute = 60 * number + 1e-6;
        if (!leap && minute >= 1440 * (leap_day - 1)) minute += 1440;
        auto hour = begins.upper_bound(int(minute));
        if (hour == begins.begin() || minute >= (--hour)->first + w.step_min)
            base::fail(path, fmt::format("the hour of the year {:g} is not in {}", number, w.path));
        if (minutes.empty() || minutes.back() != hour->second) minutes.push_back(hour->second);
    }
    return minutes;
}

// Of each hour of a leap year.
std::vector<bool> used_hours(const std::vector<double>& values, const std::string& path, double used_from) {
    if (values.size() != hours_of_year && values.size() != hours_of_leap_year)
        base::fail(path, fmt::format("has {} values, not {} or {}, and no rising hours of the year", values.size(),
                                     hours_of_year, hours_of_leap_year));
    std::vector<bool> used;
    for (const double v : values) used.push_back(v >= used_from);
    return used.size() == hours_of_year ? with_leap_day(used) : used;
}

}  // namespace

Schedule read_schedule(const std::string& path, const Weather& w, std::optional<double> used_from) {
    Schedule s;
    std::vector<double> values;
    Lines in(path);
    for (bool first = true; in.next(); first = false) {
        if (in.text()[0] == '#') continue;
        in.split(in.text().find(',') != std::string::npos ? ',' : ' ');
        const std::string& word = in.field(0, "an hour");
        // A lone number is a value, also where it reads as a date.
        if (const auto t = in.fields() > 1 || !is_number(word) ? parse_name(word) : std::nullopt; t && t->hour >= 0) {
            const auto minute = w.minute_named(*t);
            if (!minute) in.fail(word + " is not an hour of " + w.path);
            s.minutes.push_back(*minute), s.by_name = true;
            if (s.minutes.size() > 366 * 1440) in.fail("more names than a year has minutes");
        } else if (!is_number(word)) {
            if (!first) in.fail("\"" + base::excerpt(word) + "\" is neither the name of an hour nor a value");
        } else if (in.fields() == 1) {
            values.push_back(in.number(0, "the value"));
            if (values.size() > 366 * 1440) in.fail("more values than a year has minutes");
        } else {
            const int month = in.whole(0, "the month", 1, 12), day = in.whole(1, "the day", 1, 31);
            if (!is_date(month, day)) in.fail("this month has fewer days");
            const int hour = int(in.number(2, "the hour", 0, 23.999));
            if (s.used.empty()) s.used.resize(hours_of_leap_year);
            const double value = in.number(3, "the value");
            if (used_from ? value >= *used_from : value > 0)
                s.used[size_t(24 * (Date{month, day}.in_leap_year() - 1) + hour)] = true;
        }
    }
    if (int(!values.empty()) + int(!s.minutes.empty()) + int(!s.used.empty()) != 1)
        base::fail(path, "needs lines of one kind: names of hours, numbers, or month,day,hour,value");
    if (values.empty()) return s;
    if (is_list_of_hours(values)) s.minutes = hours_at(values, path, w);
    else s.used = used_hours(values, path, used_from.value_or(.1));
    return s;
}

}  // namespace weather
