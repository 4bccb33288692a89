// SPDX-License-Identifier: BSD-3-Clause
// gensky month day hour | -ang altitude azimuth [options]: CIE clear, intermediate, overcast or uniform sky.
// Prints the sun (light and source) and the brightfunc skyfunc; the four digits printed are the sky's definition.
// Radiances in W/sr/m2.
#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "generators/generators.h"
#include "generators/sun.h"

namespace generators {

namespace {

using base::degree;
enum Sky { clear = 1, overcast = 2, uniform = 3, intermediate = 4 };  // skybright.cal's numbers

struct Options {
    Sky sky = clear;
    bool sun = true;
    double turbidity = 2.45, ground = .2;
    double zenith = NAN, diffuse = NAN;   // -b, -B; NAN: not given
    double radiance = NAN, direct = NAN;  // -r, -R
    Site site;
};

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
        base::warn(call.place, "gensky: the minutes of " + base::excerpt(call.words[at]) + " are outside 0 to 59");
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

Options read_options(const Call& call, size_t i) {
    Options o;
    for (; call.has(i); i++) {
        const std::string& w = call.words[i];
        const bool plus = w[0] == '+';
        if (w.size() < 2 || (!plus && w[0] != '-')) call.fail("unexpected \"" + base::excerpt(w) + "\"");
        switch (w[1]) {
        case 's': o.sky = clear, o.sun = plus; break;
        case 'i': o.sky = intermediate, o.sun = plus; break;
        case 'c': o.sky = overcast; break;
        case 'u': o.sky = uniform; break;
        case 't': o.turbidity = call.real(++i, "-t"); break;
        case 'g': o.ground = call.real(++i, "-g"); break;
        case 'b': o.zenith = call.real(++i, "-b"), o.diffuse = NAN; break;
        case 'B': o.diffuse = call.real(++i, "-B"), o.zenith = NAN; break;
        case 'r': o.radiance = call.real(++i, "-r"), o.direct = NAN; break;
        case 'R': o.direct = call.real(++i, "-R"), o.radiance = NAN; break;
        default:
            if (plus || !o.site.option(call, i)) call.fail("unknown option " + base::excerpt(w));
        }
    }
    return o;
}

}  // namespace

void gensky(const Call& call, std::string& out) {
    auto text = std::back_inserter(out);
    const bool angles = call.has(1) && call.words[1] == "-ang";
    Options o = read_options(call, 4);
    double altitude, azimuth;
    if (angles) {
        altitude = call.real(2, "the altitude") * degree;
        azimuth = call.real(3, "the azimuth") * degree;
    } else {
        Moment t = read_date(call, 1);
        read_hour(call, 3, t, o.site.meridian);
        if (!t.solar && std::fabs(o.site.meridian - o.site.longitude) > 45 * degree)
            base::warn(call.place, "gensky: longitude and standard meridian are more than 45 degrees apart");
        const Sun s = sun_position(o.site, t);
        altitude = s.altitude;
        azimuth = s.azimuth;
        fmt::format_to(text, "# Local solar time: {:.2f}\n", s.solar_time);
    }
    fmt::format_to(text, "# Solar altitude and azimuth: {:.1f} {:.1f}\n", altitude / degree, azimuth / degree);

    const bool cloudy = o.sky == overcast || o.sky == uniform;
    if (!cloudy) altitude = std::min(altitude, 87 * degree);
    const base::Vec3 sun = sun_direction(altitude, azimuth);
    const double sine = std::sin(altitude);

    const double factor = o.sky == uniform    ? 1
                          : o.sky == overcast ? .777778
                          : o.sky == clear    ? clear_factor(altitude)
                                              : intermediate_factor(altitude);
    double zenith = o.zenith;
    if (!std::isnan(o.diffuse)) {
        zenith = o.diffuse / (factor * base::pi);
    } else if (std::isnan(zenith)) {
        zenith = cloudy ? 8.6 * sine + .123 : (1.376 * o.turbidity - 1.81) * std::tan(altitude) + .38;
        if (o.sky == intermediate) zenith = (zenith + 8.6 * sine + .123) / 2;
        zenith = std::max(0., zenith) * 1000 / 203;
    }
    double ground = zenith * factor, solar = 0;
    if (!cloudy && sine > 0) {
        solar = !std::isnan(o.direct) ? o.direct / (5.98e-5 * sine)
                : !std::isnan(o.radiance)
                    ? o.radiance
                    : 1.5e9 / 208 * (1.147 - .147 / std::max(sine, .16)) * (o.sky == intermediate ? .15 : 1);
        solar = std::max(solar, 0.);
        ground += 6e-5 / base::pi * solar * sine;
    }
    ground *= o.ground;
    fmt::format_to(text, "# Ground ambient level: {:.1f}\n", ground);
    if (o.sun && solar > 0)
        fmt::format_to(
            text,
            "\nvoid light solar\n0\n0\n3 {0:.3e} {0:.3e} {0:.3e}\n\nsolar source sun\n0\n0\n4 {1:f} {2:f} {3:f} 0.5\n",
            solar, sun.x, sun.y, sun.z);
    fmt::format_to(text, "\nvoid brightfunc skyfunc\n2 skybr skybright.cal\n0\n{} {} {:.3e} {:.3e}", cloudy ? 3 : 7,
                   int(o.sky), zenith, ground);
    if (!cloudy) {
        const double f2 = o.sky == clear ? clear_norm(altitude) : intermediate_norm(altitude);
        fmt::format_to(text, " {:.3e} {:f} {:f} {:f}", f2, sun.x, sun.y, sun.z);
    }
    out += '\n';
}

}  // namespace generators
