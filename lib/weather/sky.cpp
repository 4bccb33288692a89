// SPDX-License-Identifier: BSD-3-Clause
// See sky.h.
#include "weather/sky.h"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "generators/sun.h"

namespace weather {
namespace {

void require_light(const Weather& w, const Hour& h, double watts, const char* what) {
    constexpr double solar_constant_wm2 = 1367;
    if (!(watts >= 0 && watts <= solar_constant_wm2))
        base::fail(w.place_of(h), fmt::format("the {} irradiance of {} is {:g} W/m2: missing, or wrong", what,
                                              name_of(h.time), watts));
}

}  // namespace

Sun sun_of(const Weather& w, const Hour& h) {
    generators::Site site;
    site.latitude = w.latitude_deg * base::degree;
    site.longitude = w.longitude_deg * base::degree;
    site.meridian = w.meridian_deg * base::degree;
    generators::Sun sun = generators::sun_position(site, {h.time.date.month, h.time.date.day, h.time.hour});
    generators::move_into_day(site, w.step_min, sun);
    return {sun.altitude / base::degree, std::fmod(sun.azimuth / base::degree + 540, 360)};
}

bool is_dark(const Weather& w, const Hour& h) {
    if (sun_of(w, h).altitude_deg <= 0) return true;
    require_light(w, h, h.direct_wm2, "direct normal");
    require_light(w, h, h.diffuse_wm2, "diffuse horizontal");
    return h.direct_wm2 + h.diffuse_wm2 <= 0;
}

std::string sky_text(const Weather& w, const Hour& h) {
    const Date& date = h.time.date;
    std::string text = fmt::format("!gendaylit {} {} {:.10g} -a {:.10g} -o {:.10g} -m {:.10g} -W {:g} {:g} -i {:g}",
                                   date.month, date.day, h.time.hour, w.latitude_deg, w.longitude_deg, w.meridian_deg,
                                   h.direct_wm2, h.diffuse_wm2, w.step_min);
    if (h.dew_point_c < 70) text += fmt::format(" -d {:g}", h.dew_point_c);
    return text +
           "\nskyfunc glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180"
           "\nskyfunc glow ground_glow 0 0 4 1 1 1 0\nground_glow source ground 0 0 4 0 0 -1 180\n";
}

}  // namespace weather
