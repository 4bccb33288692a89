// SPDX-License-Identifier: BSD-3-Clause
// See sky_light.h.
#include "spectrum/sky_light.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "spectrum/action.h"
#include "spectrum/illuminants.h"

namespace spectrum {
namespace {

constexpr double overcast_up_to = 1.065, clear_from = 4.5;  // clearness, as gendaylit -C has them
constexpr double overcast_kelvin = 6191, hottest_kelvin = 25000;

// Optical depths of air (Rayleigh), dust (Angstrom; .15 at 500 nm) and ozone (.35 cm: its band about 600 nm), times
// the mass of air (Kasten and Young 1989).
Spectrum sunlight(double sine) {
    const double height = std::asin(std::clamp(sine, 0., 1.)) / base::degree;
    const double mass = 1 / (std::max(sine, 0.) + .50572 * std::pow(height + 6.07995, -1.6364));
    return sampled([&](double nm) {
        const double um = nm / 1000, ozone = .044 * std::exp(-std::pow((nm - 600) / 55, 2));
        const double depth = .008735 * std::pow(um, -4.08) + .061 * std::pow(um, -1.3) + ozone;
        return std::pow(um, -5) / std::expm1(14388 / (6000 * um)) * std::exp(-mass * depth);
    });
}

Spectrum of_value_1(Spectrum s) {
    const double value = dot(by_v().value, s);
    for (double& v : s) v /= value;
    return s;
}

}  // namespace

double clearness(const SkyLight& light) {
    const double zenith = std::acos(std::clamp(light.sun_sine, 0., 1.)), low = 1.041 * std::pow(zenith, 3);
    return light.sky_lx > 0 ? (1 + light.sun_lx / light.sky_lx + low) / (1 + low) : 1;
}

double sky_kelvin(const SkyLight& light) {
    const double clear = std::clamp((clearness(light) - overcast_up_to) / (clear_from - overcast_up_to), 0., 1.);
    const double mean_cdm2 = std::max(light.sky_lx / base::pi, 1.);
    const double mireds =
        std::clamp(-180.956 + 78.648 * std::log10(mean_cdm2), 1e6 / hottest_kelvin, 1e6 / overcast_kelvin);
    return 1e6 / (clear * mireds + (1 - clear) * 1e6 / overcast_kelvin);
}

SkySpectra spectra_of(const SkyLight& light) {
    SkySpectra s{of_value_1(sunlight(light.sun_sine)), of_value_1(daylight(sky_kelvin(light))), {}};
    const double sun = light.sun_lx * std::max(light.sun_sine, 0.), all = sun + light.sky_lx;
    for (size_t i = 0; i < s.ground.size(); i++)
        s.ground[i] = all > 0 ? (sun * s.sun[i] + light.sky_lx * s.sky[i]) / all : s.sky[i];
    return s;
}

}  // namespace spectrum
