// SPDX-License-Identifier: BSD-3-Clause
// What is learned of a picture before its frames: the mixture weights of diffuse directions
// (sampling/mixture_weights.h) and the noisy pixels (noisy.h).
#pragma once
#include "render/probes.h"

namespace render {

struct DiffusePlan {
    PixelSampling sampling;     // of frames k >= 1
    std::vector<uint32_t> spp;  // samples of each pixel in a frame
};

DiffusePlan learn(device::Device& device, const ViewPlan& plan, const Probes& probes);

}  // namespace render
