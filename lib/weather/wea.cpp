// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE's weather tape (gendaymtx): six lines of header, then month, day, the middle of the hour, direct normal and
// diffuse horizontal irradiance.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/printable.h"
#include "weather/lines.h"

namespace weather {
namespace {

double header_number(Lines& in, const char* name, double low, double high) {
    if (!in.next()) in.fail(std::string(name) + " is missing");
    in.split(' ');
    if (in.field(0, name) != name) in.fail("\"" + base::excerpt(in.text()) + "\" stands where " + name + " should");
    return in.number(1, name, low, high);
}

// Minutes between lines: the most frequent distance of two that follow each other on a day, an hour at most.
double step_of(std::vector<Hour> hours) {
    std::sort(hours.begin(), hours.end(),
              [](const Hour& a, const Hour& b) { return a.time.minute_of_year() < b.time.minute_of_year(); });
    std::vector<int> counts(61);
    for (size_t i = 1; i < hours.size(); ++i) {
        const long apart = std::lround((hours[i].time.hour - hours[i - 1].time.hour) * 60);
        const bool same_day = hours[i].time.date.in_leap_year() == hours[i - 1].time.date.in_leap_year();
        if (same_day && apart > 0 && apart <= 60) counts[size_t(apart)]++;
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    return *most > 0 ? double(most - counts.begin()) : 60;
}

}  // namespace

void read_wea(Lines& in, Weather& w) {
    w.place = in.text().substr(6);
    w.latitude_deg = header_number(in, "latitude", -90, 90);
    w.longitude_deg = header_number(in, "longitude", -180, 180);
    w.meridian_deg = header_number(in, "time_zone", -210, 210);
    header_number(in, "site_elevation", -500, 9000);
    if (header_number(in, "weather_data_file_units", 1, 9) != 1)
        in.fail("only unit 1 is read: direct normal and diffuse horizontal irradiance in W/m2");
    while (in.next()) {
        in.split(' ');
        Hour h;
        h.time.date = {in.whole(0, "the month", 1, 12), in.whole(1, "the day", 1, 31)};
        h.time.hour = in.number(2, "the hour", 0, 24);
        h.direct_wm2 = in.number(3, "the direct normal irradiance");
        h.diffuse_wm2 = in.number(4, "the diffuse horizontal irradiance");
        add_hour(in, h, w);
    }
    w.step_min = step_of(w.hours);
    for (const Hour& h : w.hours)
        if (h.time.hour + w.step_min / 120 > 24.01)
            base::fail(w.place_of(h), "the hour of a WEA line is the middle of its hour, 23.5 at most");
}

}  // namespace weather
