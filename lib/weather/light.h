// SPDX-License-Identifier: BSD-3-Clause
// The light of an hour as numbers: its sun, and the sky that the scene text of sky.h has, to be asked for a direction
// without that text (docs/decisions/0038-a-year.md).  Visible radiances and irradiances as RADIANCE has them, equal in
// all channels: 1 W/m2 is 179 lx.
#pragma once
#include <optional>

#include "weather/weather.h"

namespace weather {

constexpr double sun_diameter_deg = .533;
// Lumens per watt of RADIANCE's white, equal energy from 380 to 780 nm (its WHTEFFICACY).
constexpr double white_efficacy = 179;
constexpr double most_wm2 = 1367;  // the solar constant, as Perez has it

// Floats, because the scene text has as many digits as bring them back.  x east, y north, z up.
struct HourLight {
    float to_sun[3] = {0, 0, 1};
    float sun_radiance = 0;    // of its disc
    float sun_irradiance = 0;  // on a surface that faces it
    float sky_irradiance = 0;  // horizontal, of the sky without the sun
    // Arguments of perezlum.cal: the level of the sky, the ground's radiance, Perez' a b c d e; and the radiance that
    // is blended in above the horizon, which is the ground's but where that would be more than the whole diffuse light.
    float level = 0, ground = 0, perez[5] = {}, horizon = 0;
    bool even_gradation = false, even_indicatrix = false;  // Perez' own is not positive, and was left out
};

// The sun is up, and the light is missing or impossible.
bool lacks_values(const Weather& weather, const Hour& hour);
// Nothing for an hour without sun above the horizon or without light.  Throws Error (place: the line) for hours that
// lack values.
std::optional<HourLight> light_of(const Weather& weather, const Hour& hour);

// Radiance of sky and ground towards a unit vector, the ground below the horizon blended in as perezlum.cal does; the
// sun is not in it.
float sky_radiance(const HourLight& light, const float (&direction)[3]);

}  // namespace weather
