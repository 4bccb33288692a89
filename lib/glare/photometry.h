// SPDX-License-Identifier: BSD-3-Clause
// Sums over the valid pixels: Ev = sum L w cos (paper Eq. 1), mean luminance = sum L w / sum w.
#pragma once
#include "glare/geometry.h"
#include "glare/luminance.h"

namespace glare {

struct Photometry {
    double ev = 0, mean_lum = 0, max_lum = 0, omega = 0;  // lux, cd/m2, cd/m2, sr
    long valid_pixels = 0;
};

Photometry photometry(const Luminance& lum, const Geometry& geometry);

}  // namespace glare
