// SPDX-License-Identifier: BSD-3-Clause
// Light that a limit of bounces (-ab N) leaves out of the illuminance at the eye.  Estimated from a few paths in pairs,
// with the limit and without, of the same random numbers: they differ by the light beyond the limit alone.
#pragma once
#include <vector>
#include "device/device.h"
#include "view/view.h"

namespace render {

// Warns of the share that a limit above 0 leaves out.  base: of the picture; exact: its splatted emitters
// (frame_zero.h).
void warn_of_limit(device::Device& device, const device::Params& base, const view::View& view,
                   const std::vector<float>& exact);

}  // namespace render
