// SPDX-License-Identifier: BSD-3-Clause
// Paths for many hours on an OpenCL device (kernels/integrator/hours.h): the stages of wavefront.h, and before each
// shading the responses to all suns.  Calls throw cl::Error.
#pragma once
#include "device/hour_paths.h"
#include "device/opencl_paths.h"

namespace device {

// The paths of a pass, at most `most_paths` at once.
void opencl_hours(OpenclPaths& paths, const kernels::Params& par, uint32_t most_paths, HourPaths& out);

}  // namespace device
