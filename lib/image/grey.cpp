// SPDX-License-Identifier: BSD-3-Clause
// See grey.h.
#include "image/grey.h"

#include <cmath>

namespace image {

OddPixels to_grey(const float* rgb, size_t pixels, float* out) {
    OddPixels found;
    constexpr size_t block = 256;  // first the plain sum, which vectorises, then the test of what came out
    float grey[block];
    for (size_t first = 0; first < pixels; first += block) {
        const size_t count = pixels - first < block ? pixels - first : block;
        int odd = 0;
        for (size_t k = 0; k < count; ++k) {
            const float* c = rgb + 3 * (first + k);
            grey[k] = float((grey_red * c[0] + grey_blue * c[2]) + grey_green * c[1]);
            odd |= !(grey[k] >= 0 && grey[k] <= brightest_grey);
        }
        if (odd)
            for (size_t k = 0; k < count; ++k) {
                if (!(std::fabs(grey[k]) <= brightest_grey)) {
                    ++found.not_finite;
                    grey[k] = 0;
                }
                if (grey[k] < 0) ++found.negative;
            }
        for (size_t k = 0; k < count; ++k) out[first + k] = grey[k];  // never beyond what was read
    }
    return found;
}

}  // namespace image
