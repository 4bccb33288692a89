// SPDX-License-Identifier: BSD-3-Clause
// Frame 0 of Eq. 7: the direct and specular light, the mean of a few samples, and what is drawn by area: splatted
// emitters and images of the sun (docs/decisions/0002, 0036).
#pragma once
#include <vector>
#include "render/view_plan.h"

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

FrameZero draw_frame_zero(device::Device& device, const ViewPlan& plan);

// Adds what is drawn by area to one that has none.
void draw_sources(device::Device& device, const ViewPlan& plan, FrameZero& zero);
// Number of its first sample.
int64_t first_sample_of_zero(const ViewPlan& plan);
// Light along the rays to splatted emitters, 3 floats each.
std::vector<float> splat_sources(device::Device& device, const ViewPlan& plan);
// Its values, row 0 = top.
std::vector<float> values_of(const FrameZero& zero);

}  // namespace render
