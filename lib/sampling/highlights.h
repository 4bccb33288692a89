// SPDX-License-Identifier: BSD-3-Clause
// Finds the rectangles on polished planes that the sun lights, toward whose highlights diffuse directions are sampled
// (kernels/sampling/highlights.h), and writes their records into the scene's arena.  Unbiased for any choice of
// rectangles.
#pragma once
#include "base/work_budget.h"
#include "flatten/flat_scene.h"

namespace sampling {

// work: is looked up from.
void find_highlights(flatten::FlatScene& scene, const base::WorkBudget& work);

}  // namespace sampling
