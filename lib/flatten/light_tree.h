// SPDX-License-Identifier: BSD-3-Clause
// Builds the light tree of many active sources (kernels/light/light_tree.h).
#pragma once
#include "flatten/flat_scene.h"

namespace flatten {

// Call after write_sources(); a few sources get no tree.
void plant_light_tree(FlatScene& scene);

}  // namespace flatten
