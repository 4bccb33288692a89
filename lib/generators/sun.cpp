// SPDX-License-Identifier: BSD-3-Clause
// Sun position without a year: the usual series for declination and equation of time; with a year: the Astronomical
// Almanac's low precision formulas (Michalsky, The Astronomical Almanac's algorithm for approximate solar position,
// Solar Energy 40, 1988).
#include "generators/sun.h"
#include <fmt/format.h>
#include <cctype>
#include <cmath>
#include <iterator>
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "generators/generators.h"

namespace generators {
using base::degree;

bool Site::option(const Call& call, size_t& i) {
    switch (call.words[i].size() > 1 ? call.words[i][1] : 0) {
    case 'a': latitude = call.real(++i, "-a") * degree; return true;
    case 'o': longitude = call.real(++i, "-o") * degree; return true;
    case 'm': meridian = call.real(++i, "-m") * degree; return true;
    case 'y':
        year = int(call.integer(++i, "-y", 1, 9999));
        if (year < 1950 || year > 2050)
            base::warn(call.place, call.words[0] + ": the sun's position is meant for the years 1950-2050");
        return true;
    default: return false;
    }
}

Moment read_date(const Call& call, size_t i) {
    static const int days[] = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    Moment t;
    t.month = int(call.integer(i, "the month", 1, 12));
    t.day = int(call.integer(i + 1, "the day", 1, 31));
    if (t.day > days[t.month - 1]) base::warn(call.place, call.words[0] + ": this month has fewer days");
    return t;
}

void check_hour(const Call& call, size_t i, double hour) {
    if (hour < 0 || hour > 24)
        base::warn(call.place, call.words[0] + ": hour " + base::excerpt(call.words[i]) + " is outside 0 to 24");
}

int Moment::day_of_year() const {
    static const int before[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334};
    return before[month - 1] + day;
}

void set_solar_time(const Site& site, double hours, Sun& s) {
    const double h = hours * base::pi / 12, lat = site.latitude, dec = s.declination;
    s.solar_time = hours;
    s.altitude = std::asin(std::sin(lat) * std::sin(dec) - std::cos(lat) * std::cos(dec) * std::cos(h));
    s.azimuth = -std::atan2(std::cos(dec) * std::sin(h),
                            -std::cos(lat) * std::sin(dec) - std::sin(lat) * std::cos(dec) * std::cos(h));
}

Sun sun_position(const Site& site, const Moment& t) {
    Sun s;
    const int j = t.day_of_year();
    double hours = t.hour;
    if (site.year == 0) {
        s.declination = .4093 * std::sin(2 * base::pi / 365 * (j - 81));
        if (!t.solar)
            hours += .170 * std::sin(4 * base::pi / 373 * (j - 80)) - .129 * std::sin(2 * base::pi / 355 * (j - 8)) +
                     12 / base::pi * (site.meridian - site.longitude);
    } else {
        const int y = site.year;
        const double days = j + (t.month > 2 && y % 4 == 0) + 365 * (y - 1949) + std::floor((y - 1949) / 4.) +
                            (t.hour + 12 * site.meridian / base::pi) / 24 + 2432916.5 - 2451545.;
        const double mean_longitude = 280.460 + .9856474 * days, anomaly = (357.528 + .9856003 * days) * degree;
        const double l = (mean_longitude + 1.915 * std::sin(anomaly) + .020 * std::sin(2 * anomaly)) * degree;
        const double obliquity = (23.439 - 4e-7 * days) * degree;
        const double ascension = std::atan2(std::cos(obliquity) * std::sin(l), std::cos(l));
        s.declination = std::asin(std::sin(obliquity) * std::sin(l));
        const double ut = 24 * (days - std::floor(days)) + 12;
        if (!t.solar) {
            hours = 6.697375 + .0657098242 * days + ut - 12 / base::pi * (site.longitude + ascension) + 12;
            hours -= 24 * std::floor(hours / 24);
        }
    }
    set_solar_time(site, hours, s);
    return s;
}

void move_into_day(const Site& site, double minutes, Sun& s) {
    const double x = -std::tan(site.latitude) * std::tan(s.declination);
    if (x <= -1 || x >= 1) return;
    const double half_day = std::acos(x) * 12 / base::pi, rise = 12 - half_day, set = 12 + half_day,
                 half = minutes / 120;
    double t = s.solar_time;
    if (std::fabs(t - rise) <= half) t = (t + half + rise) / 2;
    else if (std::fabs(t - set) <= half) t = (t - half + set) / 2;
    else return;
    set_solar_time(site, t, s);
}

namespace {

struct TimeZone {
    const char* name;
    double west;
};
// clang-format off
const TimeZone zones[] = {
    {"YST", 135}, {"YDT", 120}, {"PST", 120}, {"PDT", 105}, {"MST", 105}, {"MDT", 90}, {"CST", 90},
    {"CDT", 75}, {"EST", 75}, {"EDT", 60}, {"AST", 60}, {"ADT", 45}, {"NST", 52.5}, {"NDT", 37.5}, {"GMT", 0},
    {"BST", 0}, {"CET", -15}, {"CEST", -30}, {"EET", -30}, {"EEST", -45}, {"GST", -60}, {"GDT", -75},
    {"IST", -82.5}, {"IDT", -97.5}, {"JST", -135}, {"NZST", -180}, {"NZDT", -195},
};
// clang-format on

// [+]h[:mm][zone] or [+]h.hh[zone]; a zone sets the meridian whatever -m says.
void read_hour(const Call& call, size_t at, Moment& t, double& zone_meridian) {
    std::string w = call.word(at, "the hour");
    t.solar = w[0] == '+';
    if (t.solar) w.erase(0, 1);
    size_t letters = 0;
    while (letters < w.size() && !std::isalpha(static_cast<unsigned char>(w[letters]))) letters++;
    std::string zone = w.substr(letters), clock = w.substr(0, letters);
    const size_t colon = clock.find(':');
    double minutes = 0;
    if (!base::parse_real(clock.substr(0, colon), t.hour) ||
        (colon != std::string::npos && !base::parse_real(clock.substr(colon + 1), minutes)))
        call.fail("\"" + base::excerpt(call.words[at]) + "\" is not an hour");
    if (minutes < 0 || minutes >= 60)
        base::warn(call.place,
                   call.words[0] + ": the minutes of " + base::excerpt(call.words[at]) + " are outside 0 to 59");
    t.hour += minutes / 60;
    check_hour(call, at, t.hour);
    if (zone.empty()) return;
    if (t.solar) call.fail("a time zone and solar time cannot be used together");
    for (char& c : zone) c = char(std::toupper(static_cast<unsigned char>(c)));
    for (const TimeZone& z : zones)
        if (zone == z.name) {
            zone_meridian = z.west * degree;
            return;
        }
    call.fail("unknown time zone \"" + base::excerpt(zone) + "\"");
}

}  // namespace

Sun read_sun(const Call& call, size_t i, Site site, std::string& out) {
    auto text = std::back_inserter(out);
    Sun s;
    if (call.has(i) && call.words[i] == "-ang") {
        s.altitude = call.real(i + 1, "the altitude") * degree;
        s.azimuth = call.real(i + 2, "the azimuth") * degree;
    } else {
        Moment t = read_date(call, i);
        read_hour(call, i + 2, t, site.meridian);
        if (!t.solar && std::fabs(site.meridian - site.longitude) > 45 * degree)
            base::warn(call.place, call.words[0] + ": longitude and standard meridian are more than 45 degrees apart");
        s = sun_position(site, t);
        fmt::format_to(text, "# Local solar time: {:.2f}\n", s.solar_time);
    }
    fmt::format_to(text, "# Solar altitude and azimuth: {:.1f} {:.1f}\n", s.altitude / degree, s.azimuth / degree);
    return s;
}

base::Vec3 sun_direction(double altitude, double azimuth) {
    return {-std::sin(azimuth) * std::cos(altitude), -std::cos(azimuth) * std::cos(altitude), std::sin(altitude)};
}

static double polynomial(const double (&c)[5], double altitude) {
    const double x = (altitude - base::pi / 4) / (base::pi / 4);
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
}

double clear_norm(double altitude) {
    const double s = std::sin(altitude);
    return .274 * (.91 + 10 * std::exp(-3 * (base::pi / 2 - altitude)) + .45 * s * s);
}

double intermediate_norm(double altitude) {
    return (2.739 + .9891 * std::sin(.3119 + 2.6 * altitude)) *
           std::exp(-(base::pi / 2 - altitude) * (.4441 + 1.48 * altitude));
}

double clear_factor(double altitude) {
    return polynomial({2.766521, .547665, -.369832, .009237, .059229}, altitude) / clear_norm(altitude) / base::pi;
}

double intermediate_factor(double altitude) {
    return polynomial({3.5556, -2.7152, -1.3081, 1.0660, .60227}, altitude) / intermediate_norm(altitude) / base::pi;
}

}  // namespace generators
