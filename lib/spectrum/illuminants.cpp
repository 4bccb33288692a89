// SPDX-License-Identifier: BSD-3-Clause
// See illuminants.h.
#include "spectrum/illuminants.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "spectrum/tables.h"

namespace spectrum {
namespace {

const struct Light {
    const char* name;
    const double* values;
    int step;
} lights[] = {
    {"F2", light_f2, 1},
    {"F7", light_f7, 1},
    {"F11", light_f11, 1},
    {"F12", light_f12, 1},
    {"LED-B1", light_led_b1, 5},
    {"LED-B2", light_led_b2, 5},
    {"LED-B3", light_led_b3, 5},
    {"LED-B4", light_led_b4, 5},
    {"LED-B5", light_led_b5, 5},
    {"LED-BH1", light_led_bh1, 5},
    {"LED-RGB1", light_led_rgb1, 5},
    {"LED-V1", light_led_v1, 5},
    {"LED-V2", light_led_v2, 5},
};

constexpr double coolest_daylight_k = 4000, hottest_daylight_k = 25000;

// The temperatures of D50, D55 .. count with the second radiation constant of 1931.
double temperature_of(const std::string& d) { return 100 * std::stod(d.substr(1)) * 1.4388 / 1.438; }

double thousandths(double x) { return std::round(1000 * x) / 1000; }

}  // namespace

Spectrum daylight(double t) {
    const double x = t <= 7000 ? ((-4.6070e9 / t + 2.9678e6) / t + 99.11) / t + .244063
                               : ((-2.0064e9 / t + 1.9018e6) / t + 247.48) / t + .237040;
    const double y = (-3 * x + 2.870) * x - .275, m = .0241 + .2562 * x - .7341 * y;
    const double m1 = thousandths((-1.3515 - 1.7703 * x + 5.9114 * y) / m);
    const double m2 = thousandths((.0300 - 31.4424 * x + 30.0717 * y) / m);
    double values[81];
    for (size_t i = 0; i < 81; i++) values[i] = daylight_s0[i] + m1 * daylight_s1[i] + m2 * daylight_s2[i];
    return of_table(values, 5);
}

const Spectrum& d65() {
    static const Spectrum s = daylight(temperature_of("D65"));
    return s;
}

Spectrum illuminant(const std::string& word, const std::string& place, const base::Opener& by) {
    if (word == "D50" || word == "D55" || word == "D65" || word == "D75") return daylight(temperature_of(word));
    if (word == "E") return sampled([](double) { return 100.; });
    if (word == "A")
        return sampled([](double nm) {
            const auto planck = [](double l) { return std::pow(l, -5) / std::expm1(1.435e7 / (2848 * l)); };
            return 100 * planck(nm) / planck(560);
        });
    for (const Light& l : lights)
        if (word == l.name) return of_table(l.values, l.step);
    double kelvin;
    if (base::parse_real(word, kelvin)) {
        if (kelvin < coolest_daylight_k || kelvin > hottest_daylight_k)
            base::fail(place, fmt::format("daylight has 4000 to 25000 K, not {}", word));
        return daylight(kelvin);
    }
    if (!std::filesystem::exists(word))
        base::fail(place, fmt::format("\"{}\" is neither a file nor one of A E D50 D55 D65 D75 F2 F7 F11 F12 LED-B1 .. "
                                      "LED-B5 LED-BH1 LED-RGB1 LED-V1 LED-V2, or daylight's temperature in K",
                                      base::excerpt(word)));
    const Spectrum light = read_spectrum(word, by);
    if (dot(light, of_table(action_v, 1)) <= 0) base::fail(place, word + ": has no light that V sees");
    return light;
}

}  // namespace spectrum
