// SPDX-License-Identifier: BSD-3-Clause
// EnergyPlus weather: eight lines of header, then a line for each hour, which is numbered by its end.  Fields are those
// of the Auxiliary Programs manual of EnergyPlus, "EPW CSV Format".
#include "base/split.h"
#include "weather/lines.h"

namespace weather {
namespace {

enum Field { month = 1, day = 2, hour = 3, minute = 4, dew_point = 7, direct_normal = 14, diffuse = 15 };

// "3/12" is 12 March; 0 for rules such as "2nd Sunday in March", and for none.
int day_in_leap_year(const std::string& text) {
    const size_t slash = text.find('/');
    if (slash == std::string::npos) return 0;
    const Date d{std::atoi(text.c_str()), std::atoi(text.c_str() + slash + 1)};
    return is_date(d.month, d.day) ? d.in_leap_year() : 0;
}

void read_location(Lines& in, Weather& w) {
    in.split(',');
    w.place = in.field(1, "the place");
    w.latitude_deg = in.number(6, "the latitude", -90, 90);
    w.longitude_deg = -in.number(7, "the longitude", -180, 180);
    w.meridian_deg = -15 * in.number(8, "the time zone", -14, 14);
}

// Lines an hour; the weekday is that of the period's first day, which is 1 January in years.
int read_periods(Lines& in, Weather& w) {
    const int parts = in.whole(2, "the number of lines an hour", 1, 60);
    if (60 % parts) in.fail("the number of lines an hour does not divide 60 minutes");
    const int first = in.fields() > 5 ? day_in_leap_year(in.field(5, "the first day")) : 1;
    if (const auto weekday = in.fields() > 4 ? weekday_named(in.field(4, "the weekday")) : std::nullopt)
        w.first_weekday = (*weekday + 371 - (first > 0 ? date_of(first).of_year() - 1 : 0)) % 7;
    return parts;
}

}  // namespace

void read_epw(Lines& in, Weather& w) {
    read_location(in, w);
    int parts = 1;
    for (bool header = true; header && in.next();) {
        in.split(',');
        if (base::begins_with(in.text(), "HOLIDAYS/DAYLIGHT") && in.fields() > 3) {
            w.summer_time[0] = day_in_leap_year(in.field(2, ""));
            w.summer_time[1] = day_in_leap_year(in.field(3, ""));
        } else if (base::begins_with(in.text(), "DATA PERIODS")) {
            parts = read_periods(in, w);
            header = false;
        }
    }
    w.step_min = 60. / parts;
    while (in.next()) {
        in.split(',');
        Hour h;
        h.time.date = {in.whole(month, "the month", 1, 12), in.whole(day, "the day", 1, 31)};
        const int end = in.whole(hour, "the hour", 1, 24);
        // In hourly files the minute is 0 or 60, and means nothing.
        const double last = parts == 1 ? 60 : in.number(minute, "the minute", 1, 60);
        h.time.hour = end - 1 + (last - w.step_min / 2) / 60;
        if (h.time.hour < 0) in.fail("the minute is shorter than a step");
        h.dew_point_c = in.number(dew_point, "the dew point");
        h.direct_wm2 = in.number(direct_normal, "the direct normal radiation");
        h.diffuse_wm2 = in.number(diffuse, "the diffuse horizontal radiation");
        add_hour(in, h, w);
    }
}

}  // namespace weather
