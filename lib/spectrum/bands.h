// SPDX-License-Identifier: BSD-3-Clause
// Bands of wavelengths as the three colours of a rendering (docs/spectra.md).  In a band light counts with the action's
// weight, and what it meets is averaged with the action times D65.  The values of light are divided by the weights of
// R, G and B in the luminance, so that the luminance of a pixel, over 179, is the sum of its three bands: what is
// chosen by luminance (sources, noisy pixels) is chosen by the action.
#pragma once
#include <array>
#include <vector>
#include "spectrum/action.h"

namespace spectrum {

using Colour = std::array<double, 3>;

struct Bands {
    std::array<Spectrum, 3> light, surface;  // weights: of a sum, of a mean
    Colour red, blue;                        // of the surfaces (1 0 0) and (0 0 1); that of (1 1 1) is 1
};

// All of an action, three by three.  count: a multiple of 3.
std::vector<Bands> bands_of(const Action& action, int count);
// The limits between `count` bands.
std::vector<double> limits_of(const Action& action, int count);

Colour colour_of_light(const Bands& bands, const Spectrum& s);
Colour colour_of_surface(const Bands& bands, const Spectrum& s);
// Of three numbers R, G, B: a smooth spectrum with this colour (Mallett and Yuksel 2019); a grey one's is its value.
Colour colour_of_surface(const Bands& bands, const Colour& rgb);
// The light of this spectrum, filtered by the smooth one of the RGB, with the luminance of the RGB.
Colour colour_of_light(const Bands& bands, const Colour& rgb, const Spectrum& illuminant);
// That smooth spectrum.
Spectrum upsampled(const Colour& rgb);

}  // namespace spectrum
