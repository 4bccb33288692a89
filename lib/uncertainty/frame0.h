// SPDX-License-Identifier: BSD-3-Clause
// The error of frame 0 itself.  Its direct samples stand for frames 1 to m = 8: some of these frames show one half of
// the samples and the others the other half (image/picture.h; docs/decisions/0002-frame-zero.md), so that frames of a
// half have one error in common.  Half-samples of n frames see 2/n of its variance, up to n = m, and miss 3/4 (m/n)^2
// of it afterwards.
//
// Each pixel's error e of frame 0 is half the difference of the frames of both halves.  Images L' + e and L' - e, with
// a random sign for each pixel and e scaled to what is missing, add the rest of the variance.
#pragma once
#include <cstdint>
#include <vector>

#include "image/parts.h"

namespace uncertainty {

constexpr int frame0_pairs = 4;         // of images
constexpr int64_t frame0_matters = 64;  // frames; then less than a tenth of the variance of direct noise is missing

// By pixel, from the first frames, 3 to 8 parts of one frame each.  Its square is the variance that differences of
// frames show beyond that of the diffuse samples in them, averaged over 3 x 3 pixels; its sign is that of the
// difference, which runs with the same noise have in common.  counts: pixels that are measured.
std::vector<float> frame0_error(const std::vector<image::Part>& frames, int width, int height,
                                const std::vector<bool>& counts);

// The share of it that half-samples of n frames miss.
double missing_share(int64_t n);

// +1 or -1 of a pixel in a pair of images.
int random_sign(uint32_t pixel, int pair);

}  // namespace uncertainty
