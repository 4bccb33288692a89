// SPDX-License-Identifier: BSD-3-Clause
// How many of the diffuse directions go toward windows (kernels/portals.h): as many as cost no variance, none where the
// noise lies elsewhere.  Under an overcast sky it lies at the windows; where the sun comes in it is the patch on the
// floor, and directions toward windows are missing there.  And how many toward highlights (kernels/highlights.h).
#pragma once
#include <vector>
#include "trace/device.h"

namespace trace {

struct Shares {
    float windows = 0, highlights = 0;  // each below 1
};

// From scene, view, options and seed alone.  par: as for frames; records: those of the windows, then those of the
// highlights; the device holds the scene.
Shares find_shares(Device& device, const Params& par, const std::vector<float>& records);

}  // namespace trace
