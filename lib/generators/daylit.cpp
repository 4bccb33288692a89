// SPDX-License-Identifier: BSD-3-Clause
// gendaylit month day hour | -ang altitude azimuth  -P|-W|-G|-L a b | -E global  [options]: a Perez sky
// (perez.h).  Output as gensky's: the sun, and skyfunc for perezlum.cal.  -O 0: visible radiance, 1: solar
// radiance, 2: luminance.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include "base/angle.h"
#include "base/error.h"
#include "base/printable.h"
#include "generators/generators.h"
#include "generators/perez.h"
#include "generators/sun.h"

namespace generators {

namespace {

using base::degree;
constexpr double sun_half_angle = .2665 * degree;
constexpr double most_lux = 127500, most_watts = 1367;

struct DaylitOptions {
    char input = 0;  // P W G L E
    double a = 0, b = 0;
    int output = 0;  // -O
    bool sun = true, overcast = false, colour = false, cie = false, quiet = false;
    double ground = .2, dew_point = 10.97353115, interval = 0;
    Site site;
};

DaylitOptions read_daylit_options(const Call& call, size_t i) {
    DaylitOptions o;
    for (; call.has(i); i++) {
        const std::string& w = call.words[i];
        if (w.size() < 2 || (w[0] != '-' && w[0] != '+')) call.fail("unexpected \"" + base::excerpt(w) + "\"");
        switch (w[1]) {
        case 's': o.sun = w[0] == '+'; break;
        case 'c': o.sun = false, o.overcast = true; break;
        case 'w': o.quiet = true; break;
        case 'C': (w == "-CIE" ? o.cie : o.colour) = true; break;  // the locus of -C's colours, or colours
        case 'R':
        case 'b':
        case 't': call.real(++i, w.c_str()); break;
        case 'd':
            o.dew_point = call.real(++i, "-d");
            if (o.dew_point < -40 || o.dew_point > 40) o.dew_point = DaylitOptions().dew_point;
            break;
        case 'i': o.interval = call.real(++i, "-i"); break;
        case 'g': o.ground = call.real(++i, "-g"); break;
        case 'O': o.output = int(call.integer(++i, "-O", 0, 2)); break;
        case 'P':
        case 'W':
        case 'G':
        case 'L':
            o.input = w[1];
            o.a = call.real(++i, w.c_str());
            o.b = call.real(++i, w.c_str());
            break;
        case 'E':
            o.input = 'E';
            o.a = call.real(++i, "-E");
            break;
        default:
            if (!o.site.option(call, i)) call.fail("unknown option " + base::excerpt(w));
        }
    }
    if (!o.input) call.fail("one of -P -W -G -L -E is needed");
    if (o.input != 'P' && (o.a < 0 || o.b < 0)) base::warn(call.place, "gendaylit: a negative input counts as 0");
    o.a = std::max(o.a, 0.);
    o.b = std::max(o.b, 0.);
    return o;
}

// Erbs' correlation: the diffuse part of a global horizontal irradiance (Erbs, Klein, Duffie, Solar Energy 28, 1982).
void split_global(double global, double extraterrestrial, double sine, double& direct, double& diffuse) {
    const double top = extraterrestrial * sine;
    global = std::min(global, .999 * top);
    const double k = global / top;
    diffuse = k <= .22  ? global * (1 - .09 * k)
              : k <= .8 ? global * (.9511 + k * (-.1604 + k * (4.388 + k * (-16.638 + k * 12.336))))
                        : .165 * global;
    direct = (global - diffuse) / sine;
}

// Where the sun stands; writes the comments about it.  At the zenith it is moved to 87 degrees, as in RADIANCE.
Sun find_sun(const Call& call, const DaylitOptions& o, int& day, std::string& out) {
    auto text = std::back_inserter(out);
    Sun sun;
    if (call.has(1) && call.words[1] == "-ang") {
        sun.altitude = call.real(2, "the altitude") * degree;
        sun.azimuth = call.real(3, "the azimuth") * degree;
    } else {
        Moment t = read_date(call, 1);
        const std::string& hour = call.word(3, "the hour");
        char* end;
        t.hour = std::strtod(hour.c_str(), &end);  // "14:30" and "14EST" are 14, as in RADIANCE
        t.solar = hour[0] == '+';
        if (end == hour.c_str()) call.fail("\"" + base::excerpt(hour) + "\" is not an hour");
        if (*end)
            base::warn(call.place, fmt::format("gendaylit: hour \"{}\" counts as {:g}", base::excerpt(hour), t.hour));
        check_hour(call, 3, t.hour);
        day = t.day_of_year();
        sun = sun_position(o.site, t);
        if (o.interval > 0) move_into_day(o.site, o.interval, sun);
        fmt::format_to(text, "# Local solar time: {:.2f}\n", sun.solar_time);
    }
    fmt::format_to(text, "# Solar altitude and azimuth: {:.1f} {:.1f}\n", sun.altitude / degree, sun.azimuth / degree);
    if (sun.altitude > 87 * degree && !o.overcast) {
        base::warn(call.place, "gendaylit: the sun is moved from the zenith to an altitude of 87 degrees");
        sun.altitude = 87 * degree;
    }
    return sun;
}

struct Irradiance {
    double direct, diffuse;  // W/m2, normal and horizontal
    Clearness clearness;
};

// From whichever pair of numbers the options gave.
Irradiance irradiance(const DaylitOptions& o, const PerezSky& sky, double sine) {
    double direct = o.a, diffuse = o.b;
    Clearness c;
    switch (o.input) {
    case 'P':
        c = clamp({o.a, o.b});
        sky.irradiances(c, direct, diffuse);
        return {direct, diffuse, c};
    case 'E': split_global(o.a, sky.extraterrestrial, sine, direct, diffuse); break;
    case 'G': direct = o.a / sine; break;
    case 'L':  // a fixed point of irradiance -> efficacy -> irradiance
        direct *= most_watts / most_lux;
        diffuse *= most_watts / most_lux;
        c = clamp(sky.clearness(direct, diffuse));
        for (int i = 0; i < 9; i++) {
            const double e = sky.direct_efficacy(c);
            diffuse = o.b / sky.diffuse_efficacy(c);
            direct = e < .1 ? 0 : o.a / e;
            c = clamp(sky.clearness(direct, diffuse));
        }
        break;
    }
    return {direct, diffuse, clamp(sky.clearness(direct, diffuse))};  // no diffuse light: as clear as can be
}

void write_sun(std::string& out, const DaylitOptions& o, const Clearness& c, double radiance, base::Vec3 to_sun) {
    auto text = std::back_inserter(out);
    if (!o.sun) return;
    if (c.epsilon <= 1) out += "\nvoid light solar\n0\n0\n3 0.0 0.0 0.0\n";
    else fmt::format_to(text, "\nvoid light solar\n0\n0\n3 {0:.3e} {0:.3e} {0:.3e}\n", radiance);
    fmt::format_to(text, "\nsolar source sun\n0\n0\n4 {:f} {:f} {:f} 0.533\n", to_sun.x, to_sun.y, to_sun.z);
}

void write_sky(std::string& out, const DaylitOptions& o, const Clearness& c, const PerezShape& shape, double level,
               double ground, base::Vec3 to_sun) {
    auto text = std::back_inserter(out);
    const bool colour = o.colour && (c.epsilon <= 1.065 || c.epsilon >= 4.5);
    if (colour)
        fmt::format_to(text, "\nvoid colorfunc skyfunc\n4 skybright_r skybright_g skybright_b perezlum_c.cal\n0\n22");
    else fmt::format_to(text, "\nvoid brightfunc skyfunc\n2 skybright perezlum.cal\n0\n10");
    fmt::format_to(text, " {:.3e} {:.3e}", level, ground);
    for (double x : shape.c) fmt::format_to(text, " {:f}", x);
    fmt::format_to(text, " {:f} {:f} {:f}", to_sun.x, to_sun.y, to_sun.z);
    if (colour) {
        fmt::format_to(text, " {:f}", c.epsilon);
        // Coefficients of the locus of sky colours, two lines and a join.
        constexpr float usual[11] = {-4843e6f, 2556800.f, 242.82f,  .23258f, -4843e6f, 2556800.f,
                                     242.82f,  .23258f,   -1.2848f, 1.7519f, -.093786f};
        constexpr float cie[11] = {-4.607e9f, 2.9678e6f, 99.11f, .244063f, -2.0064e9f, 1.9018e6f,
                                   247.48f,   .23704f,   -3.f,   2.87f,    -.275f};
        for (float x : o.cie ? cie : usual) fmt::format_to(text, " {:f}", x);
    }
    out += '\n';
}

}  // namespace

void gendaylit(const Call& call, std::string& out) {
    auto text = std::back_inserter(out);
    const DaylitOptions o = read_daylit_options(call, 4);
    int day = 0;
    const Sun sun = find_sun(call, o, day, out);
    const base::Vec3 to_sun = sun_direction(sun.altitude, sun.azimuth);
    // below the horizon, which -ang alone allows, the sky is that of a sun on it, as in RADIANCE
    const double sine = std::sin(sun.altitude), z = base::pi / 2 - std::max(sun.altitude, 0.);

    auto error_sky = [&](const char* why) {
        if (!o.quiet) base::warn(call.place, std::string("gendaylit: ") + why + ": the sky is black");
        fmt::format_to(text,
                       "\nvoid brightfunc skyfunc\n2 skybright perezlum.cal\n0\n10 0.00 0.00 0.000 0.000 0.000 0.000 "
                       "0.000 {:f} {:f} {:f}\n",
                       to_sun.x, to_sun.y, to_sun.z);
    };
    const bool dated = day > 0, horizontal_input = o.input == 'G' || o.input == 'E';
    if (sun.altitude <= 0 && (dated || horizontal_input)) return error_sky("the sun is below the horizon");
    if (sun.altitude < 0 && !o.quiet)
        base::warn(call.place, "gendaylit: the sun is below the horizon: the sky is that of a sun on it");
    if (o.input != 'P' && o.a + o.b == 0) return error_sky("no light");

    const PerezSky sky(day, z, o.dew_point);
    const auto [direct, diffuse, c] = irradiance(o, sky, sine);
    const PerezShape shape(c, z);
    if (shape.c[1] > 0) return error_sky("the horizon's Perez coefficient b is positive");
    // -L states them; between two bins of epsilon its fixed point may not settle
    const bool stated = o.input == 'L';
    const double diffuse_lux = stated ? o.b : diffuse * sky.diffuse_efficacy(c);
    const double direct_lux = !stated ? direct * sky.direct_efficacy(c) : direct > 0 ? o.a : 0;
    if (diffuse_lux < 0) return error_sky("the sky's illuminance is negative");
    if (direct > most_watts || direct_lux > most_lux) return error_sky("more sunlight than above the atmosphere");

    const auto wanted = [&](double watts, double lux) {
        return o.output == 0 ? lux / efficacy : o.output == 1 ? watts : lux;
    };
    const double level = wanted(diffuse, diffuse_lux) / shape.horizontal(z);
    const double solar = wanted(direct, direct_lux) / (2 * base::pi * (1 - std::cos(sun_half_angle)));
    const double factor = c.epsilon <= 1   ? .777778
                          : c.epsilon >= 6 ? clear_factor(sun.altitude)
                                           : intermediate_factor(sun.altitude);
    double ground = shape.relative(0, z) * level * factor;
    if (o.sun && c.epsilon > 1) ground += 6.8e-5 / base::pi * solar * std::max(sine, 0.);
    ground *= o.ground;

    fmt::format_to(text, "# Ground ambient level: {:.1f}\n", ground);
    write_sun(out, o, c, solar, to_sun);
    write_sky(out, o, c, shape, level, ground, to_sun);
}

}  // namespace generators
