// SPDX-License-Identifier: BSD-3-Clause
// Filled part of pixels.  A pixel of mean luminance m1 and mean square m2 is treated as light of luminance m2/m1 on the
// fraction f = m1^2/m2 of its area.  This preserves the pixel's light and its L^2 omega for any pixel size.  m2 is m1^2
// plus the variance of light within the pixel (image/moments.h); f is 1 for a uniform pixel.
#pragma once
#include <vector>
#include "glare/luminance.h"

namespace glare {

// m2/m1 and f, in place of a picture's grey and its pixels.
struct FilledPixels {
    std::vector<float> grey, share;
    // A picture with these moments.
    Luminance as(const Luminance& picture);
};
// picture: one with moments.
FilledPixels filled_pixels(const Luminance& picture);

}  // namespace glare
