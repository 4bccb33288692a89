// SPDX-License-Identifier: BSD-3-Clause
// Finds the rectangles on polished planes that the sun lights, whose highlights guide diffuse samples
// (kernels/sampling/highlights.h), and writes their records into the scene's arena.  Any choice is right in the mean.
#pragma once
#include "flatten/flat_scene.h"

namespace sampling {

void find_highlights(flatten::FlatScene& scene);

}  // namespace sampling
