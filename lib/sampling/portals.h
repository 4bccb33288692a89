// SPDX-License-Identifier: BSD-3-Clause
// Finds the windows, and the patches of sun behind them, at which diffuse samples aim (kernels/sampling/portals.h), and
// writes their records into the scene's arena. Any choice is right in the mean; a good one is quiet.  Panes come from
// surfaces.cpp: every transparent polygon.
#pragma once
#include "flatten/flat_scene.h"

namespace sampling {

void find_portals(flatten::FlatScene& scene);

}  // namespace sampling
