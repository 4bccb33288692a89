// SPDX-License-Identifier: BSD-3-Clause
// The error of frame 0 itself.  Its direct samples stand for frames 1 to m: some of these frames show one half of the
// samples and the others the other half (image/picture.h; docs/decisions/0002-frame-zero.md), so that frames of a half
// have one error in common, and so have all frames of a part (image/parts.h).  Half-samples of n frames see 2/n of its
// variance, of more than sixteen an eighth, and the mean of n > m frames holds (m/n)^2 of it.
//
// Each pixel's error e of frame 0 is half the difference of the frames of both halves.  Images L' + e and L' - e, with
// a random sign for each pixel and e scaled to what is missing, add the rest of the variance.
#pragma once
#include <cstdint>
#include <vector>

#include "image/parts.h"

namespace uncertainty {

constexpr int frame0_pairs = 4;        // of images
constexpr int64_t frame0_matters = 8;  // n/m; then about a tenth of the variance of direct noise is missing

struct Frame0Error {
    std::vector<float> of_pixel;  // empty: not known
    int64_t m = 0;
};

// From three parts or more that begin at frame m or before.  The least-squares slope of their means on the excess of
// one half over the other in their frames is half the difference of the halves.  e is that slope, scaled so that its
// square is the mean over 3 x 3 pixels of the slope's square less its variance by the scatter about the line: runs with
// the same noise have e in common.  counts: pixels that are measured.
Frame0Error frame0_error(const std::vector<image::Part>& parts, int64_t m, int width, int height,
                         const std::vector<bool>& counts);

// The share of its variance that half-samples of n frames miss.
double missing_share(int64_t n, int64_t m);

// +1 or -1 of a pixel in a pair of images.
inline int random_sign(uint32_t pixel, int pair) {
    uint32_t x = pixel * 2654435761u + 40503u;  // a hash: all of its bits depend on all of the pixel's
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    return (x >> (24 + pair)) & 1 ? 1 : -1;
}

}  // namespace uncertainty
