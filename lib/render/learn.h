// SPDX-License-Identifier: BSD-3-Clause
// What is learned of a picture before frame 1, from samples that no frame contains: the mixture weights of diffuse
// directions (sampling/mixture_weights.h) and the noisy pixels (noisy.h).
#pragma once
#include "render/view_plan.h"

namespace render {

struct DiffusePlan {
    PixelSampling sampling;       // of frames k >= 1
    std::vector<uint32_t> noisy;  // pixels whose several samples hold the direct class in each frame
};

DiffusePlan learn(device::Device& device, const ViewPlan& plan);

}  // namespace render
