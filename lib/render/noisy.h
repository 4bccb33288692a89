// SPDX-License-Identifier: BSD-3-Clause
// The noisiest pixels get several samples in each frame (decisions/0030): in proportion to the
// standard deviation of one, which for a given number of samples leaves the least squared error of the picture (Neyman
// 1934, "On the Two Different Aspects of the Representative Method").  A few samples that no frame holds tell it: were
// the choice made by samples that are kept, their means would move.
#pragma once
#include <cstdint>
#include <vector>
#include "device/device.h"

namespace render {

constexpr uint32_t least_spp = 4;  // any number of samples is a multiple of it

// base: of the picture.  share: samples for noisy pixels, over those of the picture.  Result: how
// many each pixel gets in a frame, row 0 = top, 0 where it keeps its one.  Depends on seed, scene and view alone.
std::vector<uint32_t> spp_of_noisy(device::Device& device, const kernels::Params& base, double share);

}  // namespace render
