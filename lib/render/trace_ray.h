// SPDX-License-Identifier: BSD-3-Clause
// Samples of a single ray, all classes of light (tests compare them with rtrace).
#pragma once
#include "render/view_plan.h"

namespace render {

struct RayValue {
    double mean[3], error[3];  // error: standard error
};
// The ray is in world coordinates.
RayValue trace_ray(device::Device& device, const ViewPlan& plan, const double origin[3], const double dir[3],
                   int64_t samples);

}  // namespace render
