// SPDX-License-Identifier: BSD-3-Clause
// See slats.h.
#include "year/slats.h"

#include <cmath>

namespace year {

constexpr double radians = 3.14159265358979323846 / 180;

std::optional<double> profile_angle_deg(double altitude_deg, double azimuth_deg, double facade_deg) {
    const double front = std::cos((azimuth_deg - facade_deg) * radians);
    if (altitude_deg <= 0 || front <= 1e-9) return std::nullopt;
    return std::atan(std::tan(altitude_deg * radians) / front) / radians;
}

std::optional<double> cut_off_deg(const Slats& s, double profile_deg) {
    const double sine = s.spacing / s.width * std::cos(profile_deg * radians);
    if (sine > 1) return std::nullopt;
    return std::asin(sine) / radians - profile_deg;
}

// A slat's shadow on a plane parallel to the facade is width |sin tilt + cos tilt tan p| high.
bool keep_out(const Slats& s, double tilt_deg, double profile_deg) {
    const double tilt = tilt_deg * radians, slope = std::tan(profile_deg * radians);
    return s.width * std::fabs(std::sin(tilt) + std::cos(tilt) * slope) >= s.spacing * (1 - 1e-9);
}

}  // namespace year
