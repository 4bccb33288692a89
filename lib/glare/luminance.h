// SPDX-License-Identifier: BSD-3-Clause
// The grey picture that every metric reads: one float a pixel, made in place over the first third of the picture's
// RGB memory (12 bytes a pixel hold everything), row 0 = top.
// Grey is that of image/grey.h; luminance = 179 grey, cd/m2.  Not finite pixels, and those beyond any light, become 0
// and are counted; negative ones are counted and kept.
#pragma once
#include <cstddef>
#include <vector>
#include "image/grey.h"
#include "image/picture.h"

namespace glare {

using image::grey_blue, image::grey_green, image::grey_red;
constexpr double cdm2_per_grey = 179 * (grey_red + grey_green + grey_blue);

struct Luminance {
    int width = 0, height = 0;
    float* grey = nullptr;              // borrowed from the picture: width * height
    long not_finite = 0, negative = 0;  // pixels
    image::Moments moments;             // of the light inside of its pixels; null: not known
    const float* share = nullptr;       // of each pixel that its light fills (filled.h); null: all of it
    size_t size() const { return size_t(width) * height; }
    double filled(size_t i) const { return share ? share[i] : 1; }
    // Centroid of a pixel's light, from the centre of the pixel, in pixels.
    double right(size_t i) const { return share ? (*moments)[image::moment_numbers * i + image::moment_right] : 0; }
    double up(size_t i) const { return share ? (*moments)[image::moment_numbers * i + image::moment_up] : 0; }
    size_t index(int x, int y) const { return size_t(height - 1 - y) * width + x; }  // y from the bottom
    double at(size_t i) const {                                                      // in evalglare's order of rounding
        const double f = grey[i];
        return 179 * ((grey_red * f + grey_blue * f) + grey_green * f);
    }
    double at(int x, int y) const { return at(index(x, y)); }
};

// Over the picture's colours, which are lost; that memory stays in use until the luminance is not needed any more.
Luminance make_luminance(image::Picture& picture);

// Largest float whose luminance is not above `cdm2`: a pixel is brighter exactly if its grey is greater.
float grey_limit(double cdm2);

}  // namespace glare
