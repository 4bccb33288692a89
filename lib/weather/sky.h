// SPDX-License-Identifier: BSD-3-Clause
// The sky of an hour: where the sun stands and the scene text that makes sun, sky and ground of it.
#pragma once
#include <string>

#include "generators/sun.h"
#include "weather/weather.h"

namespace weather {

struct Sun {
    double altitude_deg = 0, azimuth_deg = 0;  // above the horizon; from north over east
};
// In the middle of the part of the hour in which it is up.
Sun sun_of(const Weather& weather, const Hour& hour);

// The same in the middle of the hour, up or not.
generators::Sun sun_at_middle(const Weather& weather, const Hour& hour);

// The sun is up, and the light is missing or impossible.
bool lacks_values(const Weather& weather, const Hour& hour);
// No sun above the horizon, or no light.  Throws Error (place: the line) for hours that lack values.
bool is_dark(const Weather& weather, const Hour& hour);

// Scene text for an hour that is not dark: a Perez sky (gendaylit), and sky and ground as distant sources.  It begins
// with "!", so that it may stand where names of scene files do.
std::string sky_text(const Weather& weather, const Hour& hour);

}  // namespace weather
