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

// The signs that pixels may have.  A pattern is the number of a word of signs, one for each picture, and whether all of
// them are turned round.  Each word is the product of some of four, so that the product of words v and w is word v ^ w.
struct Signs {
    static constexpr int most = 16, words = 16, patterns = 2 * words;
    static constexpr unsigned turned = words;  // this bit of a pattern
    // Bit b of a word's number: basis[b] takes part in it.  Bit k of these: picture k shows mean - off.
    Signs(int count, const std::array<uint32_t, 4>& basis);
    // By pixel: words from the first given on, and turned or not, both at random.  In a row pixels that are `words`
    // apart have the same word, so that 16 sums side by side are sums by word.
    static std::vector<uint8_t> weave(int width, int height, unsigned first_word);

    int count;                                              // pictures
    std::array<uint32_t, patterns> minus;                   // by pattern
    std::array<std::array<uint32_t, most>, patterns> flip;  // the same as the highest bit of a float, which is its sign
    std::array<std::array<double, most>, patterns> factor;  // and as 1 and -1
};

struct Swayed {
    int width = 0, height = 0;
    const float *mean = nullptr, *off = nullptr;  // by pixel, row 0 = top
    const uint8_t* pattern = nullptr;             // by pixel, woven from `signs`
    const Signs* signs = nullptr;

    int count() const { return signs->count; }
    uint32_t minus(size_t pixel) const { return signs->minus[pattern[pixel]]; }
    float at(int picture, size_t pixel) const {
        return minus(pixel) >> picture & 1 ? mean[pixel] - off[pixel] : mean[pixel] + off[pixel];
    }
    // Whether a picture may show one of n pixels above the limit.
    bool may_exceed(size_t first, int n, float limit) const;
    void picture(int number, GreyPicture& out) const;
    std::array<float, Signs::most> brightest(const Geometry& geometry) const;  // not below 0
};

}  // namespace comfort
