// SPDX-License-Identifier: BSD-3-Clause
// The grey picture that all metrics read: one float a pixel, row 0 = top, made in place over the first third of the
// picture's RGB memory (12 bytes a pixel hold everything).  Grey is that of image/grey.h; luminance = 179 grey, cd/m2.
// Pixels that are not finite or exceed any light become 0 and are counted; negative pixels are counted and kept.
#pragma once
#include <cstddef>
#include "image/grey.h"
#include "image/picture.h"

namespace glare {

using image::grey_blue, image::grey_green, image::grey_red;
constexpr double cdm2_per_grey = 179 * (grey_red + grey_green + grey_blue);

struct Luminance {
    int width = 0, height = 0;
    const float* grey = nullptr;        // borrowed from the picture: width * height
    long not_finite = 0, negative = 0;  // pixels
    image::Moments moments;             // of the light within its pixels; null: unknown
    const float* share = nullptr;       // filled fraction of each pixel (filled.h); null: 1
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

// Overwrites the picture's colours; the memory must live as long as the luminance.
Luminance make_luminance(image::Picture& picture);

// Largest float whose luminance is at most `cdm2`: a pixel is brighter exactly if its grey is greater.
float grey_limit(double cdm2);

}  // namespace glare
