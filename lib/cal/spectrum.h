// SPDX-License-Identifier: BSD-3-Clause
// Wavelengths to RGB: weights of RADIANCE's primaries from the CIE 1931 colour matching functions.
#pragma once
#include <array>
#include <functional>

namespace cal {

// RGB of a reflectance spectrum f(nm) sampled every `step` nm from 380 to 780: 1 everywhere gives (1, 1, 1).
// Negative components are still there.
std::array<double, 3> spectrum_rgb(const std::function<double(double)>& f, double step);
// The share of a sample at nm in R, G, B, such that a flat spectrum's samples sum to (1, 1, 1).
std::array<double, 3> spectrum_weight(double nm, double step);
// The same for a band of constant value between two wavelengths, in either order.
std::array<double, 3> band_weight(double a, double b);

}  // namespace cal
