// SPDX-License-Identifier: BSD-3-Clause
// See schedule.h.
#include "weather/schedule.h"

#include <fmt/core.h>

#include <set>

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

}  // namespace

Schedule read_schedule(const std::string& path, const Weather& w) {
    Schedule s;
    std::set<int> known;
    for (const Hour& h : w.hours) known.insert(h.time.minute_of_year());
    std::vector<bool> values;
    Lines in(path);
    for (bool first = true; in.next(); first = false) {
        if (in.text()[0] == '#') continue;
        in.split(in.text().find(',') != std::string::npos ? ',' : ' ');
        const std::string& word = in.field(0, "an hour");
        // A lone number is a value, also where it reads as a date.
        if (const auto t = in.fields() > 1 || !is_number(word) ? parse_name(word) : std::nullopt; t && t->hour >= 0) {
            if (!known.count(t->minute_of_year())) in.fail(word + " is not an hour of " + w.path);
            s.minutes.push_back(t->minute_of_year());
            if (s.minutes.size() > 366 * 1440) in.fail("more names than a year has minutes");
        } else if (!is_number(word)) {
            if (!first) in.fail("\"" + base::excerpt(word) + "\" is neither the name of an hour nor a value");
        } else if (in.fields() == 1) {
            values.push_back(in.number(0, "the value") > 0);
            if (values.size() > hours_of_leap_year) in.fail("more values than a year has hours");
        } else {
            const int month = in.whole(0, "the month", 1, 12), day = in.whole(1, "the day", 1, 31);
            if (!is_date(month, day)) in.fail("this month has fewer days");
            const int hour = int(in.number(2, "the hour", 0, 23.999));
            if (s.used.empty()) s.used.resize(hours_of_leap_year);
            if (in.number(3, "the value") > 0) s.used[size_t(24 * (Date{month, day}.in_leap_year() - 1) + hour)] = true;
        }
    }
    if (int(!values.empty()) + int(!s.minutes.empty()) + int(!s.used.empty()) != 1)
        base::fail(path, "needs lines of one kind: names of hours, values, or month,day,hour,value");
    if (values.empty()) return s;
    if (values.size() != hours_of_year && values.size() != hours_of_leap_year)
        base::fail(path, fmt::format("has {} values, not {} or {}", values.size(), hours_of_year, hours_of_leap_year));
    s.used = values.size() == hours_of_year ? with_leap_day(values) : values;
    return s;
}

}  // namespace weather
