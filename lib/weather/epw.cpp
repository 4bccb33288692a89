// SPDX-License-Identifier: BSD-3-Clause
// EnergyPlus weather: eight lines of header, then a line for each hour, which is numbered by its end.  Fields are those
// of the Auxiliary Programs manual of EnergyPlus, "EPW CSV Format".
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "base/split.h"
#include "weather/day_rule.h"
#include "weather/lines.h"

namespace weather {
namespace {

enum Field {
    year = 0,
    month = 1,
    day = 2,
    hour = 3,
    minute = 4,
    dew_point = 7,
    global = 13,
    direct_normal = 14,
    diffuse = 15
};

// Ten fields, of which the last four are numbers; where names hold commas there are more.
void read_location(Lines& in, Weather& w) {
    constexpr size_t fields = 10;
    in.split(',');
    w.place = in.field(1, "the place");
    size_t last = in.fields();
    while (last > fields && in.field(last - 1, "").empty()) --last;
    const size_t at = std::max(last, fields) - 4;
    w.latitude_deg = in.number(at, "the latitude", -90, 90);
    w.longitude_deg = -in.number(at + 1, "the longitude", -180, 180);
    w.meridian_deg = -15 * in.number(at + 2, "the time zone", -14, 14);
    for (size_t k = 2; k + 2 < at; ++k)  // state and country, where there are any
        if (const std::string& name = in.field(k, ""); name != "-" && !name.empty()) w.place += ", " + name;
    w.source = in.field(at - 2, "the source");
    if (w.source == "-") w.source.clear();
    if (last > fields) in.number(at + 3, "the elevation", -1000, 9999.9);
}

// Lines an hour; the weekday is that of the period's first day, which is 1 January in years.
int read_periods(Lines& in, Weather& w) {
    const int parts = in.whole(2, "the number of lines an hour", 1, 60);
    if (60 % parts) in.fail("the number of lines an hour does not divide 60 minutes");
    const auto first = in.fields() > 5 ? parse_day_rule(in.field(5, "the first day")) : std::nullopt;
    if (const auto weekday = in.fields() > 4 ? weekday_named(in.field(4, "the weekday")) : std::nullopt)
        w.first_weekday = (*weekday + 371 - (first ? first->date(0, false).of_year() - 1 : 0)) % 7;
    return parts;
}

void read_summer_time(const Lines& in, Weather& w) {
    const auto text = [&](size_t i) { return in.field(i, "daylight saving"); };
    const auto is_none = [](const std::string& day) { return day.empty() || day == "0" || day == "0/0"; };
    if (!is_none(text(2)) && !is_none(text(3))) w.summer_time[0] = text(2), w.summer_time[1] = text(3);
}

// Minutes count from 10 to 60, the ends of their lines, or from 0 to 50, their beginnings.
void count_from_ends(const std::vector<double>& minutes, Weather& w) {
    const auto has = [&](double m) { return std::find(minutes.begin(), minutes.end(), m) != minutes.end(); };
    if (!has(0)) return;
    if (has(60)) base::fail(w.path, "has lines with minute 0 and with minute 60: do they begin or end there?");
    for (Hour& h : w.hours) h.time.hour += w.step_min / 60;
}

}  // namespace

bool is_epw(Lines& first) {
    first.split(',');
    return first.field(0, "LOCATION") == "LOCATION" && first.fields() > 1;
}

void read_epw(Lines& in, Weather& w) {
    read_location(in, w);
    int parts = 1;
    for (bool header = true; header && in.next();) {
        in.split(',');
        const std::string& name = in.field(0, "");
        if (base::begins_with(name, "HOLIDAYS/DAYLIGHT") && in.fields() > 3) read_summer_time(in, w);
        if (const size_t comma = in.text().find(',');
            base::begins_with(name, "COMMENTS") && comma < in.text().size() - 1)
            w.comments.push_back(in.text().substr(comma + 1));
        if (base::begins_with(name, "DATA PERIODS")) parts = read_periods(in, w), header = false;
    }
    w.step_min = 60. / parts;
    std::vector<double> minutes;
    long long line_year = 0;
    while (in.next()) {
        in.split(',');
        Hour h;
        h.time.date = {in.whole(month, "the month", 1, 12), in.whole(day, "the day", 1, 31)};
        if (base::parse_integer(in.field(year, "the year"), line_year) && has_sun(line_year)) h.year = int(line_year);
        const int end = in.whole(hour, "the hour", 1, 24);
        // In hourly files the minute is 0 or 60, and means nothing.
        const double last = parts == 1 ? 60 : in.number(minute, "the minute", 0, 60);
        if (parts > 1) minutes.push_back(last);
        h.time.hour = end - 1 + (last - w.step_min / 2) / 60;
        if (last > 0 && last < w.step_min) in.fail("the minute is shorter than a step");
        const double dew = in.number_or_nan(dew_point, "the dew point");
        if (!std::isnan(dew)) h.dew_point_c = dew;
        h.global_wm2 = in.number_or_nan(global, "the global horizontal radiation");
        h.direct_wm2 = in.number_or_nan(direct_normal, "the direct normal radiation");
        h.diffuse_wm2 = in.number_or_nan(diffuse, "the diffuse horizontal radiation");
        add_hour(in, h, w);
    }
    count_from_ends(minutes, w);
}

}  // namespace weather
