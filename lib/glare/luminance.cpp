// SPDX-License-Identifier: BSD-3-Clause
// Converts a picture's colours to grey in place (luminance.h).
#include "glare/luminance.h"
#include <cmath>
#include <limits>

namespace glare {

Luminance make_luminance(image::Picture& picture) {
    Luminance lum;
    lum.width = picture.width;
    lum.height = picture.height;
    lum.grey = picture.rgb.data();
    lum.moments = picture.moments;
    const image::OddPixels odd = image::to_grey(picture.rgb.data(), lum.size(), picture.rgb.data());
    lum.not_finite = odd.not_finite;
    lum.negative = odd.negative;
    return lum;
}

float grey_limit(double cdm2) {
    float f = float(cdm2 / cdm2_per_grey);
    const float top = std::numeric_limits<float>::infinity();
    while (cdm2_per_grey * f > cdm2 && f > -top) f = std::nextafter(f, -top);
    while (f < top && cdm2_per_grey * std::nextafter(f, top) <= cdm2) f = std::nextafter(f, top);
    return f;
}

}  // namespace glare
