// SPDX-License-Identifier: BSD-3-Clause
// Finds the windows, and the patches of sun behind them, toward which diffuse directions are sampled
// (kernels/sampling/portals.h), and writes their records into the scene's arena.  Unbiased for any choice; a good
// choice has little noise.  Panes come from surfaces.cpp: every transparent polygon.
#pragma once
#include "flatten/flat_scene.h"

namespace sampling {

void find_portals(flatten::FlatScene& scene);

}  // namespace sampling
