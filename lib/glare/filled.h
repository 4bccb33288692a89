// SPDX-License-Identifier: BSD-3-Clause
// Pixels by what fills them.  A pixel of mean luminance m1 and mean square m2 is taken for light of luminance m2/m1 on
// the share f = m1^2/m2 of it, which keeps both: its light and its L^2 omega, whatever the size of pixels.  m2 is m1^2
// and the variance of light inside of the pixel (image/moments.h); of a uniform pixel f is 1.
#pragma once
#include <vector>
#include "glare/luminance.h"

namespace glare {

// m2/m1 and f, in place of a picture's grey and its pixels.
struct FilledPixels {
    std::vector<float> grey, share;
    // As a picture of the same moments.
    Luminance as(const Luminance& picture);
};
// picture: with moments.
FilledPixels filled_pixels(const Luminance& picture);

}  // namespace glare
