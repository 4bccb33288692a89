// SPDX-License-Identifier: BSD-3-Clause
// How many of the diffuse directions go toward windows (kernels/portals.h): as many as cost no variance, none where the
// noise lies elsewhere.  Under an overcast sky it lies at the windows; where the sun comes in it is the patch on the
// floor, and directions toward windows are missing there.
#pragma once
#include <vector>
#include "trace/device.h"

namespace trace {

// A share below 1, from scene, view, options and seed alone.  par: as for frames; portals: the records of the windows,
// one after another; the device holds the scene.
float find_window_share(Device& device, const Params& par, const std::vector<float>& portals);

}  // namespace trace
