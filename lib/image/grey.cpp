// SPDX-License-Identifier: BSD-3-Clause
// See grey.h.  Four pixels at a time, in the compiler's words for that, which every processor can follow.
#include "image/grey.h"

#include <cmath>
#include <cstring>

#include "base/wide.h"

namespace image {
namespace {

using Four = float __attribute__((vector_size(16)));
using Double = double __attribute__((vector_size(32)));
using Which = int32_t __attribute__((vector_size(16)));

inline __attribute__((always_inline)) Double wide(const Four& v) { return __builtin_convertvector(v, Double); }

// Returns true if a pixel needs the careful conversion.
WIDE_LOOP bool convert(const float* rgb, size_t pixels, float* grey) {
    Which odd = {};
    size_t i = 0;
    for (; i + 4 <= pixels; i += 4) {
        Four a, b, c;  // r g b r, g b r g, b r g b
        std::memcpy(&a, rgb + 3 * i, sizeof a);
        std::memcpy(&b, rgb + 3 * i + 4, sizeof b);
        std::memcpy(&c, rgb + 3 * i + 8, sizeof c);
        const Four r = __builtin_shufflevector(__builtin_shufflevector(a, b, 0, 3, 6, 6), c, 0, 1, 2, 5);
        const Four g = __builtin_shufflevector(__builtin_shufflevector(a, b, 1, 4, 7, 7), c, 0, 1, 2, 6);
        const Four blue = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 5, 5, 5), c, 0, 1, 4, 7);
        const Double red_blue = grey_red * wide(r) + grey_blue * wide(blue), sum = red_blue + grey_green * wide(g);
        const Four out = __builtin_convertvector(sum, Four);
        odd |= ~((out >= 0.f) & (out <= brightest_grey));
        std::memcpy(grey + i, &out, sizeof out);
    }
    bool found = odd[0] | odd[1] | odd[2] | odd[3];
    for (; i < pixels; ++i) {
        const float* c = rgb + 3 * i;
        grey[i] = float((grey_red * c[0] + grey_blue * c[2]) + grey_green * c[1]);
        found |= !(grey[i] >= 0 && grey[i] <= brightest_grey);
    }
    return found;
}

}  // namespace

OddPixels to_grey(const float* rgb, size_t pixels, float* out) {
    OddPixels found;
    constexpr size_t block = 256;
    float grey[block];
    for (size_t first = 0; first < pixels; first += block) {
        const size_t count = pixels - first < block ? pixels - first : block;
        if (convert(rgb + 3 * first, count, grey))
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

std::vector<float> grey_of(const std::vector<float>& rgb) {
    std::vector<float> grey(rgb.size() / 3);
    to_grey(rgb.data(), grey.size(), grey.data());
    return grey;
}

}  // namespace image
