// SPDX-License-Identifier: BSD-3-Clause
// See bands.h.
#include "spectrum/bands.h"

#include <algorithm>
#include <numeric>

#include "image/picture.h"
#include "spectrum/illuminants.h"
#include "spectrum/tables.h"

namespace spectrum {
namespace {

// The share of the nm about a wavelength that lies between two limits.
Spectrum shares_of(double from, double to) {
    return sampled([&](double nm) { return std::max(0., std::min(to, nm + .5) - std::max(from, nm - .5)); });
}

Spectrum product(Spectrum a, const Spectrum& b) {
    for (size_t i = 0; i < a.size(); i++) a[i] *= b[i];
    return a;
}

// Weights of a mean; where they are all 0, the mean of the band.
Spectrum mean_weights(const Spectrum& weight, const Spectrum& share) {
    Spectrum w = product(weight, share);
    double sum = std::accumulate(w.begin(), w.end(), 0.);
    if (sum <= 0) w = share, sum = std::accumulate(w.begin(), w.end(), 0.);
    for (double& v : w) v /= sum;
    return w;
}

}  // namespace

std::vector<double> limits_of(const Action& action, int count) {
    std::vector<double> limits{double(first_nm) - .5};
    for (int k = 1; k < count; k++) limits.push_back(action.from_nm + (action.to_nm - action.from_nm) * k / count);
    limits.push_back(double(last_nm) + .5);
    return limits;
}

std::vector<Bands> bands_of(const Action& action, int count) {
    const std::vector<double> limits = limits_of(action, count);
    const Spectrum by_daylight = product(action.value, d65());
    const Spectrum red = of_table(primary_red, 5), blue = of_table(primary_blue, 5);
    std::vector<Bands> all(size_t(count) / 3);
    for (size_t k = 0; k < 3 * all.size(); k++) {
        Bands& b = all[k / 3];
        const size_t i = k % 3;
        const Spectrum share = shares_of(limits[k], limits[k + 1]);
        b.light[i] = product(action.value, share);
        for (double& v : b.light[i]) v /= image::luminance_weights[i];
        b.surface[i] = mean_weights(by_daylight, share);
        b.red[i] = dot(b.surface[i], red);
        b.blue[i] = dot(b.surface[i], blue);
    }
    return all;
}

Colour colour_of_light(const Bands& bands, const Spectrum& s) {
    return {dot(bands.light[0], s), dot(bands.light[1], s), dot(bands.light[2], s)};
}

Colour colour_of_surface(const Bands& bands, const Spectrum& s) {
    return {dot(bands.surface[0], s), dot(bands.surface[1], s), dot(bands.surface[2], s)};
}

Colour colour_of_surface(const Bands& bands, const Colour& rgb) {
    Colour c;
    for (size_t i = 0; i < 3; i++) c[i] = rgb[1] + (rgb[0] - rgb[1]) * bands.red[i] + (rgb[2] - rgb[1]) * bands.blue[i];
    return c;
}

Spectrum upsampled(const Colour& rgb) {
    const Spectrum red = of_table(primary_red, 5), blue = of_table(primary_blue, 5);
    Spectrum s;
    for (size_t i = 0; i < s.size(); i++) s[i] = rgb[1] + (rgb[0] - rgb[1]) * red[i] + (rgb[2] - rgb[1]) * blue[i];
    return s;
}

Colour colour_of_light(const Bands& bands, const Colour& rgb, const Spectrum& illuminant) {
    const double* w = image::luminance_weights;
    const Spectrum s = product(upsampled(rgb), illuminant);
    const double goal = w[0] * rgb[0] + w[1] * rgb[1] + w[2] * rgb[2], value = dot(by_v().value, s);
    Colour c = colour_of_light(bands, s);
    for (double& v : c) v *= value > 0 ? goal / value : 0;
    return c;
}

}  // namespace spectrum
