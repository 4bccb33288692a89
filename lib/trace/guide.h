// SPDX-License-Identifier: BSD-3-Clause
// What is learned of the light before frames are guided by it: from scene, view, options and seed alone, so that every
// share of the frames on every machine is guided alike.
#pragma once
#include "trace/device.h"
#include "trace/guide_table.h"

namespace trace {

// par: as for frames; the device holds the scene.
Guide learn_guide(Device& device, const Params& par);

}  // namespace trace
