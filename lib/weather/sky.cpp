// SPDX-License-Identifier: BSD-3-Clause
// See sky.h.
#include "weather/sky.h"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.h"
#include "base/error.h"

namespace weather {
namespace {

bool is_possible(double watts) {
    constexpr double solar_constant_wm2 = 1367;
    return watts >= 0 && watts <= solar_constant_wm2;
}

void require_light(const Weather& w, const Hour& h, double watts, const char* what) {
    if (is_possible(watts)) return;
    const std::string value = std::isnan(watts) ? "an empty field" : fmt::format("{:g} W/m2", watts);
    base::fail(w.place_of(h),
               fmt::format("the {} irradiance of {} is {}: missing, or wrong", what, name_of(h.time), value));
}

generators::Site site_of(const Weather& w) {
    generators::Site site;
    site.latitude = w.latitude_deg * base::degree;
    site.longitude = w.longitude_deg * base::degree;
    site.meridian = w.sun_meridian_deg() * base::degree;
    return site;
}

}  // namespace

generators::Sun sun_at_middle(const Weather& w, const Hour& h) {
    return generators::sun_position(site_of(w), {h.time.date.month, h.time.date.day, h.time.hour});
}

Sun sun_of(const Weather& w, const Hour& h) {
    generators::Sun sun = sun_at_middle(w, h);
    generators::move_into_day(site_of(w), w.step_min, sun);
    return {sun.altitude / base::degree, std::fmod(sun.azimuth / base::degree + 540, 360)};
}

// Where the sun is low a file without global irradiance says that there is none of the others.
bool lacks_values(const Weather& w, const Hour& h) {
    constexpr double low_deg = 5;
    if (is_possible(h.direct_wm2) && is_possible(h.diffuse_wm2)) return false;
    return sun_of(w, h).altitude_deg > (h.global_wm2 == 0 ? low_deg : 0);
}

bool is_dark(const Weather& w, const Hour& h) {
    if (sun_of(w, h).altitude_deg <= 0) return true;
    if (lacks_values(w, h)) {
        require_light(w, h, h.direct_wm2, "direct normal");
        require_light(w, h, h.diffuse_wm2, "diffuse horizontal");
    }
    return !(h.direct_wm2 + h.diffuse_wm2 > 0 && is_possible(h.direct_wm2) && is_possible(h.diffuse_wm2));
}

std::string sky_text(const Weather& w, const Hour& h) {
    const Date& date = h.time.date;
    std::string text = fmt::format("!gendaylit {} {} {:.10g} -a {:.10g} -o {:.10g} -m {:.10g} -W {:g} {:g} -i {:g}",
                                   date.month, date.day, h.time.hour, w.latitude_deg, w.longitude_deg,
                                   w.sun_meridian_deg(), h.direct_wm2, h.diffuse_wm2, w.step_min);
    if (h.dew_point_c < 70) text += fmt::format(" -d {:g}", h.dew_point_c);
    return text +
           "\nskyfunc glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180"
           "\nskyfunc glow ground_glow 0 0 4 1 1 1 0\nground_glow source ground 0 0 4 0 0 -1 180\n";
}

}  // namespace weather
