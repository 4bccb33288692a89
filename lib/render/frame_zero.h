// SPDX-License-Identifier: BSD-3-Clause
// Frame 0 of Eq. 7: the direct and specular light, and what is drawn by area: splatted emitters and images of the sun
// (docs/decisions/0002, 0036).
//   A few samples P of each pixel find where the light is uneven; as many fresh samples F are drawn as are due there.
// S0 = w P + (1 - w) F with the same w everywhere, so that its mean does not depend on what P has met.
#pragma once
#include <vector>
#include "render/learn.h"
#include "render/pixel_moments.h"

namespace render {

// Pixels of 3 floats, row 0 = top.
struct FrameZero {
    std::vector<float> mean;        // S0, of the direct class
    std::vector<float> exact;       // drawn by area: splatted emitters, images of the sun (empty: none)
    std::vector<DrawnLight> drawn;  // by pixel (empty: none)
    image::Moments moments;
};

// The fresh samples of a pixel: one or (pairs) two of each of some places.
struct Fresh {
    uint32_t places = 0;
    bool pairs = false;
};
std::vector<Fresh> fresh_samples(const ViewPlan& plan, const Probes& probes, const DiffusePlan& learned);
// w: so little that fresh samples decide the noise where they are many.
double weight_of_probes(const ViewPlan& plan);
// Light of the points of plan.drawn.straight, 3 floats each.
std::vector<float> splat_sources(device::Device& device, const ViewPlan& plan);

FrameZero draw_frame_zero(device::Device& device, const ViewPlan& plan, const Probes& probes,
                          const DiffusePlan& learned);

// Number of its first sample.
int64_t first_sample_of_zero(const ViewPlan& plan);
// Light along the rays to splatted emitters, 3 floats each.
std::vector<float> splat_sources(device::Device& device, const ViewPlan& plan);
// Its values, row 0 = top.
std::vector<float> values_of(const FrameZero& zero);

}  // namespace render
