// SPDX-License-Identifier: BSD-3-Clause
// Grey = kr R + kg G + kb B with evalglare's weights (RADIANCE primaries, equal-energy white), rounded to float: what
// every metric reads.
#pragma once
#include <cstddef>
#include <vector>

namespace image {

constexpr double grey_red = 0.26510582010582007, grey_green = 0.67010582010581987, grey_blue = 0.064788359788359784;

// A pixel beyond this is a mistake of the program that wrote it (the sun is 1e7); sums over such pixels would not be
// finite.
constexpr float brightest_grey = 1e30f;

struct OddPixels {
    long not_finite = 0, negative = 0;
};

template <class Rgb>
double grey(const Rgb& rgb) {  // not rounded
    return grey_red * double(rgb[0]) + grey_green * double(rgb[1]) + grey_blue * double(rgb[2]);
}

// `grey` may be the memory of `rgb`.  Pixels that are not finite, or beyond any light, become 0; negative ones stay.
OddPixels to_grey(const float* rgb, size_t pixels, float* grey);
std::vector<float> grey_of(const std::vector<float>& rgb);

}  // namespace image
