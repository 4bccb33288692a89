// SPDX-License-Identifier: BSD-3-Clause
// gensky month day hour | -ang altitude azimuth [options]: CIE clear, intermediate, overcast or uniform sky.
// Prints the sun (light and source) and the brightfunc skyfunc; the four digits printed are the sky's definition.
// Radiances in W/sr/m2.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include "base/angle.h"
#include "base/error.h"
#include "base/printable.h"
#include "generators/generators.h"
#include "generators/sun.h"

namespace generators {

namespace {

using base::degree;
enum Sky { clear = 1, overcast = 2, uniform = 3, intermediate = 4 };  // skybright.cal's numbers

struct SkyOptions {
    Sky sky = clear;
    bool sun = true;
    double turbidity = 2.45, ground = .2;
    double zenith = NAN, diffuse = NAN;   // -b, -B; NAN: not given
    double radiance = NAN, direct = NAN;  // -r, -R
    Site site;
};

SkyOptions read_sky_options(const Call& call, size_t i) {
    SkyOptions o;
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
    SkyOptions o = read_sky_options(call, 4);
    const Sun s = read_sun(call, 1, o.site, out);
    double altitude = s.altitude;
    const double azimuth = s.azimuth;
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
