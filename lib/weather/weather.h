// SPDX-License-Identifier: BSD-3-Clause
// A year of weather from an EPW or a WEA file: the sun's and the sky's light of each hour.
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weather/date.h"

namespace weather {

// A line of the file: means over an hour, or a part of one.
struct Hour {
    Time time;                               // its middle
    double direct_wm2 = 0, diffuse_wm2 = 0;  // normal and horizontal, as the file has them; NAN: an empty field
    double global_wm2 = NAN;                 // horizontal, likewise; WEA files have none
    double dew_point_c = 99.9;               // above 70: not known
    int year = 0;                            // 1901 to 2099; 0: not stated
    uint32_t line = 0;
};

constexpr int usual_year = 2022;  // whose sun lines without a year have
// Years whose sun is known to .02 degrees.
inline bool has_sun(long long year) { return year >= 1901 && year <= 2099; }

struct Weather {
    std::string path, place;
    std::string source;                                            // as the file states it; empty: it does not
    std::vector<std::string> comments;                             // likewise
    double latitude_deg = 0, longitude_deg = 0, meridian_deg = 0;  // north; west, as RADIANCE has them
    double step_min = 60;                                          // length of an Hour
    int year = usual_year;                                         // of lines that state none
    int first_weekday = 6;                                         // of 1 January, 0: Monday
    std::string summer_time[2];  // daylight saving from and to this day, as the file has it; empty: not stated
    std::vector<Hour> hours;     // by date, whatever the order of the lines
    double shift_h = 0;          // -wea-shift: moves the sun to where it stands this much later

    // Of the sun: hours later are degrees west.
    double sun_meridian_deg() const { return meridian_deg + 15 * shift_h; }

    // Time::minute_of_year() of the hour of this name; else of the only one a minute away, where seconds were rounded
    // in another way.
    std::optional<int> minute_named(const Time& name) const;
    std::string place_of(const Hour& hour) const { return path + ":" + std::to_string(hour.line); }
};

// Throws Error (place: file and line) where the file is neither format, a line is broken or an hour comes twice.
// A missing value (9999, -999, an empty field) is an error only where it is needed (light.h).
Weather read_weather(const std::string& path);

}  // namespace weather
