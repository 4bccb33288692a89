// SPDX-License-Identifier: BSD-3-Clause
// The tree in which many active sources stand, so that one of them is chosen without asking all
// (kernels/light/light_tree.h).
#pragma once
#include "flatten/flat_scene.h"

namespace flatten {

// After write_sources(); few sources get none.
void plant_light_tree(FlatScene& scene);

}  // namespace flatten
