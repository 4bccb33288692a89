// SPDX-License-Identifier: BSD-3-Clause
// Frame 0 of Eq. 7: the direct and specular light, the mean of a few samples, and drawn sources (docs/decisions/0002).
#pragma once
#include <vector>
#include "render/splat_emitters.h"
#include "render/samples.h"

namespace render {

// What drawn sources bring to a pixel, in grey (image/grey.h): their luminance's integral and that of its square over
// the pixel, and the integral weighted by the place, in pixels from the centre.
struct DrawnLight {
    double sum = 0, squares = 0, right = 0, up = 0;
};

// Pixels of 3 floats, row 0 = top.
struct FrameZero {
    std::vector<float> mean;        // of its samples
    std::vector<float> half_off;    // how far the first half of them lies off (empty: m is odd)
    std::vector<float> exact;       // drawn sources (empty: none)
    std::vector<float> spread;      // by pixel: variance of its samples' grey
    std::vector<DrawnLight> drawn;  // by pixel (empty: none)
};

// count: samples of each pixel; m: for how many frames they stand.
FrameZero draw_frame_zero(device::Device& device, Samples& sampler, const kernels::Params& base, uint32_t m,
                          uint32_t count, const SplatList& drawn);

}  // namespace render
