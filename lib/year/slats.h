// SPDX-License-Identifier: BSD-3-Clause
// When the slats of a Venetian blind keep out the sun (A. Tzempelikos, The impact of venetian blind geometry and tilt
// angle on view, direct light transmission and interior illuminance, Solar Energy 82, 2008).  Slats are flat; a tilt is
// above 0 where their outer edge is lowered.
#pragma once
#include <optional>

namespace year {

struct Slats {
    double facade_deg = 180;         // where the facade looks, from north over east
    double width = 1, spacing = .8;  // of one unit
};

// The sun's height in the plane that is square to the facade: tan p = tan(altitude) / cos(azimuth - facade).  Nothing
// where the sun is down or behind the facade.
std::optional<double> profile_angle_deg(double altitude_deg, double azimuth_deg, double facade_deg);

// The least tilt, from -90 to 90 degrees, that keeps out a sun of this profile: sin(tilt + p) = spacing / width cos p.
// Nothing where none does.
std::optional<double> cut_off_deg(const Slats& slats, double profile_deg);

// Slats whose shadows cover the gaps between them keep out the sun.
bool keep_out(const Slats& slats, double tilt_deg, double profile_deg);

}  // namespace year
