// SPDX-License-Identifier: BSD-3-Clause
// The sky of an hour: where the sun stands and the scene text that makes sun, sky and ground of its light.
#pragma once
#include <string>

#include "generators/sun.h"
#include "weather/light.h"

namespace weather {

struct Sun {
    double altitude_deg = 0, azimuth_deg = 0;  // above the horizon; from north over east
};
// By the Astronomical Almanac's formula for the year of the line, in the middle of the part of the hour in which the
// sun is up.
Sun sun_of(const Weather& weather, const Hour& hour);
// The year whose sun it is: the line's, else the weather's.
int year_of(const Weather& weather, const Hour& hour);

// The same in the middle of the hour, up or not.
generators::Sun sun_at_middle(const Weather& weather, const Hour& hour);

// Scene text for this light of an hour: a Perez sky by perezlum.cal, and sky and ground as distant sources, as RADIANCE
// reads them, too.  It may stand where names of scene files do (scene::read_more).
std::string sky_text(const Weather& weather, const Hour& hour, const HourLight& light);

}  // namespace weather
