// SPDX-License-Identifier: BSD-3-Clause
// See light.h.
#include "weather/light.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "generators/perez.h"
#include "generators/sun.h"
#include "weather/perez_integral.h"
#include "weather/sky.h"

namespace weather {
namespace {

using generators::PerezShape;

constexpr double ground_reflectance = .2;           // gendaylit's, without -g
constexpr double usual_dew_point_c = 10.97353115;   // gendaylit's, without -d: 2 cm of water
constexpr double sun_steradian_of_ground = 6.8e-5;  // gendaylit's, for the sun's part of the ground's radiance

bool is_possible(double watts) { return watts >= 0 && watts <= most_wm2; }

void require_light(const Weather& w, const Hour& h, double watts, const char* what) {
    if (is_possible(watts)) return;
    const std::string value = std::isnan(watts) ? "an empty field" : fmt::format("{:g} W/m2", watts);
    base::fail(w.place_of(h),
               fmt::format("the {} irradiance of {} is {}: missing, or wrong", what, name_of(h.time), value));
}

// Zenith luminance to horizontal illuminance over pi, by gendaylit's choice of CIE sky.
double ground_factor(double epsilon, double altitude) {
    return epsilon <= 1   ? .777778
           : epsilon >= 6 ? generators::clear_factor(altitude)
                          : generators::intermediate_factor(altitude);
}

// Perez' functions were fitted to measured skies, and are asked beyond those.  A gradation with b > 0 grows without
// bound towards the horizon, and one that changes its sign takes light away: then the sky has none, as at b = 0.
void keep_positive(PerezShape& shape, HourLight& light) {
    double* const c = shape.c;
    const auto gradation = [&](double cosine) { return 1 + c[0] * std::exp(c[1] / cosine); };
    light.even_gradation = c[1] > 0 || gradation(1) <= 0 || gradation(lowest_cosine) <= 0;
    if (light.even_gradation) c[0] = c[1] = 0;
    constexpr int steps = 64;
    for (int i = 0; i <= steps && !light.even_indicatrix; ++i) {
        const double gamma = base::pi * i / steps, cosine = std::cos(gamma);
        light.even_indicatrix = 1 + c[2] * std::exp(c[3] * gamma) + c[4] * cosine * cosine <= 0;
    }
    if (light.even_indicatrix) c[2] = c[3] = c[4] = 0;
}

}  // namespace

// Where the sun is low a file without global irradiance says that there is none of the others.
bool lacks_values(const Weather& w, const Hour& h) {
    constexpr double low_deg = 5;
    if (is_possible(h.direct_wm2) && is_possible(h.diffuse_wm2)) return false;
    return sun_of(w, h).altitude_deg > (h.global_wm2 == 0 ? low_deg : 0);
}

std::optional<HourLight> light_of(const Weather& w, const Hour& h) {
    const Sun sun = sun_of(w, h);
    if (sun.altitude_deg <= 0) return std::nullopt;
    if (lacks_values(w, h)) {
        require_light(w, h, h.direct_wm2, "direct normal");
        require_light(w, h, h.diffuse_wm2, "diffuse horizontal");
    }
    const bool is_lit = h.direct_wm2 + h.diffuse_wm2 > 0;
    if (!is_lit || !is_possible(h.direct_wm2) || !is_possible(h.diffuse_wm2)) return std::nullopt;

    HourLight light;
    const double altitude = sun.altitude_deg * base::degree, azimuth = (sun.azimuth_deg - 180) * base::degree;
    const base::Vec3 to_sun = generators::sun_direction(altitude, azimuth);
    for (int i = 0; i < 3; ++i) light.to_sun[i] = float(to_sun[i]);

    // Perez et al. 1990: lumens of sun and sky per watt of either by clearness, brightness, height and water.
    const bool has_dew_point = h.dew_point_c >= -40 && h.dew_point_c <= 40;
    const double zenith = base::pi / 2 - altitude;
    const generators::PerezSky sky(h.time.date.of_year(), zenith, has_dew_point ? h.dew_point_c : usual_dew_point_c);
    const generators::Clearness k = generators::clamp(sky.clearness(h.direct_wm2, h.diffuse_wm2));
    const double direct = h.direct_wm2 * sky.direct_efficacy(k) / white_efficacy;
    const double diffuse = h.diffuse_wm2 * sky.diffuse_efficacy(k) / white_efficacy;
    const double half_angle = sun_diameter_deg / 2 * base::degree;
    const double radiance = direct / (2 * base::pi * (1 - std::cos(half_angle)));
    light.sun_irradiance = float(direct);
    light.sun_radiance = float(radiance);
    light.sky_irradiance = float(diffuse);

    // The sky's level is what makes sky and blended ground together the diffuse irradiance.
    PerezShape shape(k, zenith);
    keep_positive(shape, light);
    for (int i = 0; i < 5; ++i) light.perez[i] = float(shape.c[i]);
    const PerezIntegral sum = integrate(shape, zenith);
    const double ground_of_sky = ground_reflectance * shape.relative(0, zenith) * ground_factor(k.epsilon, altitude);
    const double ground_of_sun =
        ground_reflectance * sun_steradian_of_ground / base::pi * radiance * std::sin(altitude);
    const double level = std::max(0., diffuse - ground_of_sun * sum.ground) / (sum.sky + ground_of_sky * sum.ground);
    light.level = float(level);
    light.ground = float(level * ground_of_sky + ground_of_sun);
    light.horizon = level > 0 ? light.ground : float(diffuse / sum.ground);
    return light;
}

float sky_radiance(const HourLight& l, const float (&d)[3]) {
    const double cosine = double(d[0]) * l.to_sun[0] + double(d[1]) * l.to_sun[1] + double(d[2]) * l.to_sun[2];
    const double gamma = std::acos(std::clamp(cosine, -1., 1.));
    const double sky = l.level * (1 + l.perez[0] * std::exp(l.perez[1] / std::max(double(d[2]), lowest_cosine))) *
                       (1 + l.perez[2] * std::exp(l.perez[3] * gamma) + l.perez[4] * cosine * cosine);
    const double weight = horizon_weight(d[2]);
    return float((weight * sky + (d[2] < 0 ? l.ground : l.horizon)) / (weight + 1));
}

}  // namespace weather
