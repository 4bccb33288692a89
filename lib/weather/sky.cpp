// SPDX-License-Identifier: BSD-3-Clause
// See sky.h.
#include "weather/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "weather/light.h"

namespace weather {
namespace {

generators::Site site_of(const Weather& w, const Hour& h) {
    generators::Site site;
    site.latitude = w.latitude_deg * base::degree;
    site.longitude = w.longitude_deg * base::degree;
    site.meridian = w.sun_meridian_deg() * base::degree;
    site.year = year_of(w, h);
    return site;
}

// Where the sun rises or sets within the hour: to the middle of the part of the hour that is day.
void put_into_day(const generators::Site& site, double minutes, generators::Sun& sun) {
    const double x = -std::tan(site.latitude) * std::tan(sun.declination);
    if (std::fabs(x) >= 1) return;
    const double half_day = std::acos(x) * 12 / base::pi, half = minutes / 120;
    const double from = std::max(sun.solar_time - half, 12 - half_day);
    const double to = std::min(sun.solar_time + half, 12 + half_day);
    if (from < to && to - from < 2 * half) generators::set_solar_time(site, (from + to) / 2, sun);
}

}  // namespace

int year_of(const Weather& w, const Hour& h) { return h.year != 0 ? h.year : w.year; }

generators::Sun sun_at_middle(const Weather& w, const Hour& h) {
    return generators::sun_position(site_of(w, h), {h.time.date.month, h.time.date.day, h.time.hour});
}

Sun sun_of(const Weather& w, const Hour& h) {
    generators::Sun sun = sun_at_middle(w, h);
    put_into_day(site_of(w, h), w.step_min, sun);
    return {sun.altitude / base::degree, std::fmod(sun.azimuth / base::degree + 540, 360)};
}

std::string sky_text(const Weather& w, const Hour& h, const HourLight& light) {
    const Date& date = h.time.date;
    std::string text =
        fmt::format("# as gendaylit {} {} {:.10g} -y {} -a {:.10g} -o {:.10g} -m {:.10g} -W {:g} {:g} -i {:g}",
                    date.month, date.day, h.time.hour, year_of(w, h), w.latitude_deg, w.longitude_deg,
                    w.sun_meridian_deg(), h.direct_wm2, h.diffuse_wm2, w.step_min);
    if (h.dew_point_c < 70) text += fmt::format(" -d {:g}", h.dew_point_c);
    const std::string to_sun = fmt::format("{:.9g}", fmt::join(light.to_sun, " "));
    const auto half = [&](const char* name, float ground, int up) {
        return fmt::format(
            "\nvoid brightfunc {0}func 2 skybright perezlum.cal 0 10 {1:.9g} {2:.9g} {3:.9g} {4}"
            "\n{0}func glow {0}_glow 0 0 4 1 1 1 0\n{0}_glow source {0} 0 0 4 0 0 {5} 180",
            name, light.level, ground, fmt::join(light.perez, " "), to_sun, up);
    };
    return text +
           fmt::format("\nvoid light solar 0 0 3 {0:.9g} {0:.9g} {0:.9g}\nsolar source sun 0 0 4 {1} {2:g}",
                       light.sun_radiance, to_sun, sun_diameter_deg) +
           half("sky", light.horizon, 1) + half("ground", light.ground, -1) + "\n";
}

}  // namespace weather
