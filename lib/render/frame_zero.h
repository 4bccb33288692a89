// SPDX-License-Identifier: BSD-3-Clause
// Frame 0 of Eq. 7: the direct and specular light, the mean of a few samples, and splatted emitters
// (docs/decisions/0002).
#pragma once
#include <vector>
#include "render/splat_emitters.h"
#include "render/samples.h"
#include "render/sun_images.h"

namespace render {

// Light drawn by area in a pixel, in grey (image/grey.h): the integrals of their luminance and of its square
// over the pixel, and the integral weighted by the position, in pixels from the centre.
struct DrawnLight {
    double sum = 0, squares = 0, right = 0, up = 0;
};

// Pixels of 3 floats, row 0 = top.
struct FrameZero {
    uint32_t samples = 0;           // of each pixel
    std::vector<float> mean;        // of its samples
    std::vector<float> half_off;    // half the difference of the means of its first and second half (empty: m is odd)
    std::vector<float> exact;       // drawn by area: splatted emitters, images of the sun (empty: none)
    std::vector<float> spread;      // by pixel: variance of its samples' grey
    std::vector<DrawnLight> drawn;  // by pixel (empty: none)
};

// count: samples of each pixel; m: number of frames that they represent.
FrameZero draw_frame_zero(device::Device& device, Samples& sampler, const kernels::Params& base, uint32_t m,
                          uint32_t count, const SplatList& drawn, const std::vector<ImagePoint>& images);

}  // namespace render
