// SPDX-License-Identifier: BSD-3-Clause
// Moments of the light within pixels (pixel_moments.h) of a block of hours: their pairs of samples share paths.
#pragma once
#include "render/hour_light.h"
#include "render/pixel_moments.h"

namespace render {

// zeros: frame 0 of each hour.
std::vector<image::Moments> moments_of_hours(device::Device& device, const PixelSampling& sampling, const HourLight& by,
                                             const std::vector<FrameZero>& zeros);

}  // namespace render
