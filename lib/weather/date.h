// SPDX-License-Identifier: BSD-3-Clause
// Days and hours of a year in standard time, and their names: "0621_1430" is the hour whose middle is 14:30 on 21 June,
// to the nearest minute.  Years have 365 days; 29 February is one more, which in a year without one has the sun of
// 1 March.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace weather {

constexpr int leap_day = 60;  // of a year with one

struct Date {
    int month = 1, day = 1;
    int in_leap_year() const;  // 1 to 366: 1 March is 61
    int of_year() const;       // 1 to 365: 29 February and 1 March are 60
};
bool is_date(int month, int day);
Date date_of(int day_in_leap_year);
std::string day_text(Date date);  // "21 Jun"

struct Time {
    Date date;
    double hour = 0;             // standard time, 0 to 24
    int minute_of_year() const;  // of a leap year, rounded
};
std::string name_of(const Time& time);
// "0621_1430", or "0621" without an hour (-1).
std::optional<Time> parse_name(std::string_view name);

// 0 to 11 of "Jan", 0 to 6 of "Mo" or "Monday", by their first letters in any case; nothing if it is no name.
std::optional<int> month_named(std::string_view word);
std::optional<int> weekday_named(std::string_view word);
const char* weekday_name(int weekday);  // "Monday"
int weekday_of_1_january(int year);     // 0: Monday

}  // namespace weather
