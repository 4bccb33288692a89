// SPDX-License-Identifier: BSD-3-Clause
// How pixels are sampled for many hours; does not depend on which hours these are.
#pragma once
#include "render/view_plan.h"

namespace render {

struct HourSampling {
    PixelSampling pixels;
    PointLayout points;            // of a picture of points
    uint32_t samples_of_zero = 0;  // as ViewPlan::samples_of_zero
};
HourSampling sample_hours(device::Device& device, const ViewPlan& plan, std::vector<kernels::Source> suns);

}  // namespace render
