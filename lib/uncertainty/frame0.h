// SPDX-License-Identifier: BSD-3-Clause
// The error of frame 0 itself.  Its direct samples stand for frames 1 to m (docs/decisions/0002-frame-zero.md), which
// have that error in common, so that half-samples of frames do not show it.
//
// Each pixel's error e of frame 0 is half the difference of two halves of its samples (image/moments.h).  Images L' + e
// and L' - e, with a random sign for each pixel and e scaled to its share in L', add the variance.
#pragma once
#include <cstdint>
#include <vector>

namespace uncertainty {

constexpr int frame0_pairs = 4;         // of images
constexpr int64_t frame0_matters = 10;  // n/m; then less than a tenth of the variance of direct noise is missing

// By pixel, from half the difference of the halves, of which noise is the square: averaged over 3 x 3 pixels, with the
// sign of the difference, which runs with the same noise have in common.  counts: pixels that are measured.
std::vector<float> frame0_error(const std::vector<float>& half_off, int width, int height,
                                const std::vector<bool>& counts);

// Its share in the mean of n frames.
double frame0_share(int64_t n, int64_t m);

// +1 or -1 of a pixel in a pair of images.
int random_sign(uint32_t pixel, int pair);

}  // namespace uncertainty
