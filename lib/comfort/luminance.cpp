// SPDX-License-Identifier: BSD-3-Clause
// Grey values in place of the colours they come from (luminance.h).
#include "comfort/luminance.h"
#include <cmath>
#include <limits>

namespace comfort {

Luminance make_luminance(image::Picture& picture) {
    Luminance lum;
    lum.width = picture.width;
    lum.height = picture.height;
    lum.grey = picture.rgb.data();
    const size_t n = lum.size();
    const float* rgb = picture.rgb.data();
    constexpr size_t block = 256;  // first the plain sum, which vectorises, then the test of what came out
    float grey[block];
    for (size_t first = 0; first < n; first += block) {
        const size_t count = n - first < block ? n - first : block;
        int odd = 0;
        for (size_t k = 0; k < count; ++k) {
            const float* c = rgb + 3 * (first + k);
            grey[k] = float((grey_red * c[0] + grey_blue * c[2]) + grey_green * c[1]);
            odd |= !(grey[k] >= 0 && grey[k] <= brightest_grey);
        }
        if (odd)
            for (size_t k = 0; k < count; ++k) {
                if (!(std::fabs(grey[k]) <= brightest_grey)) {
                    ++lum.not_finite;
                    grey[k] = 0;
                }
                if (grey[k] < 0) ++lum.negative;
            }
        for (size_t k = 0; k < count; ++k) lum.grey[first + k] = grey[k];  // never beyond what was read
    }
    return lum;
}

float grey_limit(double cdm2) {
    float f = float(cdm2 / cdm2_per_grey);
    const float top = std::numeric_limits<float>::infinity();
    while (cdm2_per_grey * f > cdm2 && f > -top) f = std::nextafter(f, -top);
    while (f < top && cdm2_per_grey * std::nextafter(f, top) <= cdm2) f = std::nextafter(f, top);
    return f;
}

}  // namespace comfort
