// SPDX-License-Identifier: BSD-3-Clause
// genciesky type month day hour | type -ang altitude azimuth  -B irradiance | -L illuminance  [options]: a general sky
// of ISO 15469 / CIE S 011, types 1 to 15, or the traditional overcast sky, 16, as the brightfunc skyfunc; with -R also
// the sun. Without the ground's blend of gensky and gendaylit: black below the horizon.  Radiances in W/sr/m2.
#include <fmt/format.h>
#include <cmath>
#include <iterator>
#include "base/angle.h"
#include "base/printable.h"
#include "generators/generators.h"
#include "generators/sun.h"

namespace generators {

namespace {

using base::degree, base::pi;

// ISO 15469:2004, table 1: gradation 1 + a exp(b/cos Z), indicatrix 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi.
struct Type {
    double a, b, c, d, e;
};
const Type types[] = {
    {4, -.7, 0, -1, 0},       {4, -.7, 2, -1.5, .15},  {1.1, -.8, 0, -1, 0},      {1.1, -.8, 2, -1.5, .15},
    {0, -1, 0, -1, 0},        {0, -1, 2, -1.5, .15},   {0, -1, 5, -2.5, .3},      {0, -1, 10, -3, .45},
    {-1, -.55, 2, -1.5, .15}, {-1, -.55, 5, -2.5, .3}, {-1, -.55, 10, -3, .45},   {-1, -.32, 10, -3, .45},
    {-1, -.32, 16, -3, .3},   {-1, -.15, 16, -3, .3},  {-1, -.15, 24, -2.8, .15},
};
constexpr int traditional = 16;

// Eight points of Gauss and Legendre in each of n equal cells of 0 to 1.
template <class F>
double integral(int n, F&& f) {
    constexpr double x[] = {.1834346424956498, .5255324099163290, .7966664774136267, .9602898564975363};
    constexpr double w[] = {.3626837833783620, .3137066458778873, .2223810344533745, .1012285362903763};
    double sum = 0;
    for (int cell = 0; cell < n; cell++)
        for (int k = 0; k < 4; k++)
            for (int sign = -1; sign <= 1; sign += 2) sum += w[k] * f((cell + .5 + .5 * sign * x[k]) / n);
    return sum / (2 * n);
}

// Horizontal irradiance of gradation times indicatrix.  Polar coordinates about the sun, where the indicatrix has its
// cusp, up to the horizon, which turns fastest at psi = pi/2 when the sun is low: points lie closer there (cubes).
double horizontal(const Type& t, double altitude) {
    const double cos_s = std::sin(altitude), sin_s = std::cos(altitude);
    return integral(12, [&](double u) {
        const double v = 2 * u - 1, cos_psi = -std::sin(pi / 2 * v * v * v);
        const double most = std::atan2(cos_s, -sin_s * cos_psi);
        const double row = integral(12, [&](double s) {
            const double chi = most * s, cos_chi = std::cos(chi);
            const double cos_z = cos_s * cos_chi + sin_s * std::sin(chi) * cos_psi;
            if (cos_z <= 0) return 0.;
            return (1 + t.a * std::exp(t.b / cos_z)) * cos_z * std::sin(chi) *
                   (1 + t.c * (std::exp(t.d * chi) - std::exp(t.d * pi / 2)) + t.e * cos_chi * cos_chi);
        });
        return 2 * row * most * 3 * pi * v * v;
    });
}

struct CieOptions {
    double irradiance = NAN, direct = 0;
    Site site;
};

CieOptions read_cie_options(const Call& call, size_t i) {
    CieOptions o;
    const auto positive = [&](double v, const std::string& option) {
        if (!(v >= 0)) call.fail(option + " is below 0");
        return v;
    };
    for (; call.has(i); i++) {
        const std::string w = call.words[i];
        if (w == "-B") o.irradiance = positive(call.real(++i, "-B"), w);
        else if (w == "-L") o.irradiance = positive(call.real(++i, "-L"), w) / efficacy;
        else if (w == "-R") o.direct = positive(call.real(++i, "-R"), w);
        else if (w[0] != '-' || w.size() != 2 || !o.site.option(call, i))
            call.fail("unknown option \"" + base::excerpt(w) + "\"");
    }
    if (std::isnan(o.irradiance)) call.fail("one of -B and -L is needed");
    return o;
}

void write_cie_sun(std::string& out, double horizontal_irradiance, double sine, base::Vec3 to_sun) {
    constexpr double half_angle = .2665 * degree;  // of 0.533 degrees
    const double half_sine = std::sin(half_angle);
    const double radiance = horizontal_irradiance / (pi * half_sine * half_sine * sine);
    fmt::format_to(
        std::back_inserter(out),
        "\nvoid light solar\n0\n0\n3 {0:.6e} {0:.6e} {0:.6e}\n\nsolar source sun\n0\n0\n4 {1:.9f} {2:.9f} {3:.9f} "
        "0.533\n",
        radiance, to_sun.x, to_sun.y, to_sun.z);
}

}  // namespace

void genciesky(const Call& call, std::string& out) {
    auto text = std::back_inserter(out);
    const int type = int(call.integer(1, "the type", 1, traditional));
    const CieOptions o = read_cie_options(call, 5);
    const Sun s = read_sun(call, 2, o.site, out);
    // The standard defines no sky for a sun whose centre is below the horizon.
    if (s.altitude < 0 || s.altitude > pi / 2) call.fail("the sun's altitude is outside 0 to 90 degrees");
    const base::Vec3 to_sun = sun_direction(s.altitude, s.azimuth);
    if (o.direct > 0 && s.altitude < degree) call.fail("-R with a sun below 1 degree");
    if (o.direct > 0) write_cie_sun(out, o.direct, std::sin(s.altitude), to_sun);
    if (type == traditional) {
        fmt::format_to(text, "\nvoid brightfunc skyfunc\n2 traditional ciesky.cal\n0\n1 {:.8e}\n",
                       o.irradiance * 9 / (7 * pi));  // (1 + 2 sin h)/3 gives 7 pi/9
        return;
    }
    const Type& t = types[type - 1];
    fmt::format_to(
        text,
        "\nvoid brightfunc skyfunc\n2 ciesky ciesky.cal\n0\n9 {:.8e} {:g} {:g} {:g} {:g} {:g} {:.9f} {:.9f} {:.9f}\n",
        o.irradiance / horizontal(t, s.altitude), t.a, t.b, t.c, t.d, t.e, to_sun.x, to_sun.y, to_sun.z);
}

}  // namespace generators
