// SPDX-License-Identifier: BSD-3-Clause
// Probes: the first few samples of the direct class of each pixel.  They find where its light is uneven and how noisy
// it is, and are a fixed share of frame 0.
#pragma once
#include "render/view_plan.h"

namespace render {

// Pixels in rows, row 0 = top; one number a pixel is grey (image/grey.h).
struct Probes {
    uint32_t count = 0;           // of each pixel
    std::vector<float> mean;      // 3 a pixel
    std::vector<float> half_off;  // half the difference of the means of their first and second half
    std::vector<float> variance;  // of one sample
};

Probes draw_probes(device::Device& device, const ViewPlan& plan);

// Pixels whose probes differ, and those around them: probes may have missed a small bright thing there.
std::vector<bool> uneven_pixels(const Probes& probes, int nx, int ny);

}  // namespace render
