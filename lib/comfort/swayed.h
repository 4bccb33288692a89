// SPDX-License-Identifier: BSD-3-Clause
// Up to 16 pictures that differ in signs only: each shows a pixel as its mean plus or minus how far that may be off.
// What is linear in the pixels is summed by pattern of signs, for all pictures at once; so is the brightest pixel.
#pragma once
#include <array>
#include <cstdint>
#include <vector>
#include "comfort/batches.h"
#include "comfort/geometry.h"

namespace comfort {

// The signs that pixels may have.
struct Signs {
    static constexpr int most = 16;
    // minus: by pattern; bit k is set where picture k shows mean - off
    Signs(int count, std::vector<uint32_t> minus);
    int count;  // pictures
    std::vector<uint32_t> minus;
    std::vector<std::array<uint32_t, most>> flip;  // the same as the highest bit of a float, which is its sign
    std::vector<std::array<double, most>> factor;  // and as 1 and -1
};

struct Swayed {
    int width = 0, height = 0;
    const float *mean = nullptr, *off = nullptr;  // by pixel, row 0 = top
    const uint8_t* pattern = nullptr;             // by pixel, of `signs`
    const Signs* signs = nullptr;

    int count() const { return signs->count; }
    uint32_t minus(size_t pixel) const { return signs->minus[pattern[pixel]]; }
    float at(int picture, size_t pixel) const {
        return minus(pixel) >> picture & 1 ? mean[pixel] - off[pixel] : mean[pixel] + off[pixel];
    }
    // Whether a picture may show one of n pixels above the limit.
    bool may_exceed(size_t first, int n, float limit) const;
    bool all_exceed(size_t first, int n, float limit) const;  // all pictures, all of these pixels
    void picture(int number, GreyPicture& out) const;
    // What the pictures have more than their mean.
    std::array<Light, Signs::most> more_light(const Geometry& geometry) const;
    std::array<float, Signs::most> brightest(const Geometry& geometry) const;  // not below 0
};

}  // namespace comfort
