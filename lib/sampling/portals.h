// SPDX-License-Identifier: BSD-3-Clause
// Finds the windows, and the patches of sun behind them, toward which diffuse directions are sampled
// (kernels/sampling/portals.h), and writes their records into the scene's arena.  Unbiased for any choice; a good
// choice has little noise.  Panes come from surfaces.cpp: every transparent polygon.
#pragma once
#include <vector>
#include "flatten/flat_scene.h"
#include "sampling/patches.h"

namespace sampling {

// Windows do not depend on the sky; scene: with its geometry, which may still lack distant sources.
std::vector<Target> find_windows(const flatten::FlatScene& scene);
void find_portals(flatten::FlatScene& scene, const std::vector<Target>& windows);

}  // namespace sampling
