// SPDX-License-Identifier: BSD-3-Clause
// See date.h.
#include "weather/date.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace weather {
namespace {

constexpr int before[13] = {0, 31, 60, 91, 121, 152, 182, 213, 244, 274, 305, 335, 366};
const char* const months[12] = {"January", "February", "March",     "April",   "May",      "June",
                                "July",    "August",   "September", "October", "November", "December"};
const char* const weekdays[7] = {"Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"};

// The name that begins with the word, which has `least` letters or more.
template <size_t n>
std::optional<int> named(const char* const (&names)[n], std::string_view word, size_t least) {
    for (size_t i = 0; i < n && word.size() >= least; ++i) {
        const std::string_view name = names[i];
        const auto same = [](char a, char b) {
            return std::tolower((unsigned char)a) == std::tolower((unsigned char)b);
        };
        if (word.size() <= name.size() && std::equal(word.begin(), word.end(), name.begin(), same)) return int(i);
    }
    return std::nullopt;
}

}  // namespace

int Date::in_leap_year() const { return before[month - 1] + day; }
int Date::of_year() const { return in_leap_year() - (month > 2); }

bool is_date(int month, int day) {
    return month >= 1 && month <= 12 && day >= 1 && day <= before[month] - before[month - 1];
}

Date date_of(int day) {
    const int month = int(std::lower_bound(before, before + 13, day) - before);
    return {month, day - before[month - 1]};
}

std::string day_text(Date date) { return fmt::format("{} {:.3}", date.day, months[date.month - 1]); }

// To the nearest minute.  Halves go down, so that the minutes of a day have names of their own; three decimals of an
// hour, which is what Ladybug writes, are up to .03 of a minute beside them.
int Time::minute_of_year() const {
    constexpr double half = .54;
    return (date.in_leap_year() - 1) * 1440 + std::clamp(int(std::ceil(hour * 60 - half)), 0, 1439);
}

std::string name_of(const Time& t) {
    const int minute = t.minute_of_year() % 1440;
    return fmt::format("{:02}{:02}_{:02}{:02}", t.date.month, t.date.day, minute / 60, minute % 60);
}

std::optional<Time> parse_name(std::string_view name) {
    int digits[9] = {};
    if (name.size() != 4 && name.size() != 9) return std::nullopt;
    for (size_t i = 0; i < name.size(); ++i) {
        if (i == 4 ? name[i] != '_' : name[i] < '0' || name[i] > '9') return std::nullopt;
        digits[i] = name[i] - '0';
    }
    const auto pair = [&](int i) { return 10 * digits[i] + digits[i + 1]; };
    const Date date{pair(0), pair(2)};
    if (!is_date(date.month, date.day)) return std::nullopt;
    if (name.size() == 4) return Time{date, -1};
    if (pair(5) > 23 || pair(7) > 59) return std::nullopt;
    return Time{date, pair(5) + pair(7) / 60.};
}

std::optional<int> month_named(std::string_view word) { return named(months, word, 3); }
std::optional<int> weekday_named(std::string_view word) { return named(weekdays, word, 2); }
const char* weekday_name(int weekday) { return weekdays[weekday]; }

// 1 January of the year 1 was a Monday.
int weekday_of_1_january(int year) {
    const int y = year - 1;
    return (y * 365 + y / 4 - y / 100 + y / 400) % 7;
}

}  // namespace weather
