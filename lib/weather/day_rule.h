// SPDX-License-Identifier: BSD-3-Clause
// A day of each year as EPW files write it: "3/12", "29-Mar", "Mar 29", "2nd Sunday in March", "Last Sunday In
// October".
#pragma once
#include <optional>
#include <string>

#include "weather/date.h"

namespace weather {

struct DayRule {
    int month = 1;
    int day = 0;      // 0: by the weekday
    int weekday = 0;  // 0: Monday
    int which = 1;    // 1 to 4, or last
    static constexpr int last = 5;

    // first_weekday: of 1 January.
    Date date(int first_weekday, bool leap_year) const;
};
// Nothing if it is none.
std::optional<DayRule> parse_day_rule(const std::string& text);

}  // namespace weather
