// SPDX-License-Identifier: BSD-3-Clause
// A choice of hours of a year: "Mo-Fr 8-18", "Jun-Aug Sa 8-12 13-17", "@occupied.csv", "1221_1330", "Mo-Fr 8-18 3/16".
#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "weather/weather.h"

namespace weather {

struct Choice {
    std::vector<size_t> hours;  // indices of Weather::hours, rising
    size_t whole = 0;           // hours before a share was taken
    size_t first = 0;           // of them: the share's first one
    std::set<size_t> named;     // those that words name, each by itself
    bool by_name = false;       // words or lines of a file name hours: some of a year, not a year
    int year = 0;               // that was named; 0: none
    std::string note;           // how dates and clock were read: a sentence for the user
};

// Words with blanks or commas between them.  Each of these kinds that occurs limits the hours, and words of a kind add
// to each other: days of the week, months, hours of the clock, names (date.h), @file.  "dst" or "dst=29Mar-25Oct" sets
// the clock an hour ahead of standard time between these dates, "2027" says whose days of the week count, and whose
// sun lines without a year have, and "3/16" takes the third of sixteen shares of equal size.  @file: schedule.h, also
// for used_from.
// Throws Error (place: -hours, or the file).
Choice choose_hours(const Weather& weather, const std::string& words, std::optional<double> used_from = std::nullopt);

}  // namespace weather
