// SPDX-License-Identifier: BSD-3-Clause
// Focus: pixels of regions that get several samples in each frame (ptrace -focus), so that numbers of few pixels
// converge sooner.  The frame holds the mean of these samples, whose expectation is that of one sample, so sums,
// intervals and merging are unaffected.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "image/masks.h"

namespace render {

// Pixels of regions of about the same size, in ascending order, and the samples of each.
struct FocusPart {
    std::vector<uint32_t> pixels;
    uint32_t spp = 1;
};
using Focus = std::vector<FocusPart>;

// Pixels that a region covers at all.  share: additional samples over those of the picture, in equal parts for each
// region, so that small regions are as certain as large ones; a pixel of two regions gets the samples of the smaller
// one.  Leaves out parts whose pixels would get one sample.  Throws Error (place) if the masks have another size or one
// is empty.
Focus focus_on(const image::MaskSet& masks, int width, int height, double share, const std::string& place);

}  // namespace render
