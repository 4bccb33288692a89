// SPDX-License-Identifier: BSD-3-Clause
// Where the sun stands, as gensky and gendaylit compute it, and what the two programs share.
// Angles in radians; latitude north, longitude and meridian west; azimuth west of south; x east, y north, z up.
#pragma once
#include <string>
#include "base/angle.h"
#include "base/vec.h"

namespace generators {

struct Call;

constexpr double efficacy = 179;  // lm/W of RADIANCE's white

struct Site {
    double latitude = .66, longitude = 2.13, meridian = 120 * base::pi / 180;
    int year = 0;                              // 0: the approximate formulas without a year
    bool option(const Call& call, size_t& i);  // -a -o -m -y at word i (then stepped over)
};
struct Moment {
    int month = 0, day = 0;
    double hour = 0;  // standard time, or solar time
    bool solar = false;
    int day_of_year() const;  // without leap days
};
struct Sun {
    double altitude = 0, azimuth = 0, declination = 0, solar_time = 0;
};
Sun sun_position(const Site& site, const Moment& t);
void set_solar_time(const Site& site, double hours, Sun& sun);  // altitude and azimuth for another hour of that day
// Half an interval before sunrise or after sunset the sun moves to the middle of the part of the interval that is day.
void move_into_day(const Site& site, double minutes, Sun& sun);
base::Vec3 sun_direction(double altitude, double azimuth);
Moment read_date(const Call& call, size_t i);              // month and day at words i, i+1
void check_hour(const Call& call, size_t i, double hour);  // warns outside 0 to 24, as word i says it

// The sun at words i to i + 2, as gensky takes it: "-ang altitude azimuth", or month day hour[:minutes][zone] (+hour:
// solar time).  Writes it as comments.
Sun read_sun(const Call& call, size_t i, Site site, std::string& out);

// F2 of skybright.cal: the CIE clear and intermediate sky's formula at the zenith.
double clear_norm(double altitude);
double intermediate_norm(double altitude);
// Zenith luminance to diffuse horizontal illuminance over pi: gensky's fits for clear and intermediate skies.
double clear_factor(double altitude);
double intermediate_factor(double altitude);

}  // namespace generators
