// SPDX-License-Identifier: BSD-3-Clause
// What is learned of a picture before frame 1, from samples that no frame contains: the mixture weights of diffuse
// directions (sampling/mixture_weights.h) and the noisy pixels (noisy.h).
#pragma once
#include "render/view_plan.h"

namespace render {

// Pixels of several samples that hold the direct class in each frame above one.
struct NoisyPixels {
    std::vector<uint32_t> pixels;  // ascending
    uint32_t direct_above = 0;
    bool hold_direct(uint32_t pixel, int64_t frame) const;
};

struct DiffusePlan {
    PixelSampling sampling;  // of frames k >= 1
    std::vector<NoisyPixels> noisy;
};

DiffusePlan learn(device::Device& device, const ViewPlan& plan);

}  // namespace render
