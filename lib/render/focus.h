// SPDX-License-Identifier: BSD-3-Clause
// The focus: pixels of regions whose numbers are wanted (ptrace -focus).  There each sample of a frame is the mean of
// several, its copies, so that numbers of few pixels do not wait until the whole picture has had frames enough.  The
// mean of copies has the expectation of one, so sums, intervals and merging know nothing of it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "image/masks.h"

namespace render {

// Pixels of regions of about the same size, in ascending order, and the copies of each.
struct FocusPart {
    std::vector<uint32_t> pixels;
    uint32_t spp = 1;
};
using Focus = std::vector<FocusPart>;

// Whatever a region covers.  share: samples of all copies, over those of the picture; each region gets as many of them
// as the others, so that small ones are no less certain, and a pixel of two regions those of the smaller one.  Without
// parts where no pixel would get two.  Throws Error (place) where the masks have another size or one is empty.
Focus focus_on(const image::MaskSet& masks, int width, int height, double share, const std::string& place);

}  // namespace render
