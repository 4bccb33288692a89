// SPDX-License-Identifier: BSD-3-Clause
// Adaptive sampling: the noisiest pixels get several samples in each frame (decisions/0030), in proportion to the
// standard deviation of one sample, which minimises the squared error of the picture for a given number of samples
// (Neyman 1934, "On the Two Different Aspects of the Representative Method").  The deviations are estimated from
// samples that no frame contains, because a choice by the samples of the frames would bias them.
#pragma once
#include <cstdint>
#include <vector>
#include "device/device.h"

namespace render {

constexpr uint32_t least_spp = 4;  // numbers of samples are multiples of it

// base: of the picture.  share: samples for noisy pixels over those of the picture.  Returns the number of samples of
// each pixel in a frame, row 0 = top, 0 for pixels that keep their one sample.  Depends on seed, scene and view alone.
std::vector<uint32_t> spp_of_noisy(device::Device& device, const device::Params& base, double share);

}  // namespace render
