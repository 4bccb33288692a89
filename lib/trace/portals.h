// SPDX-License-Identifier: BSD-3-Clause
// Finds the windows that guide diffuse samples (kernels/portals.h) and writes their records into the scene's arena.
// Any choice is right in the mean; a good one is quiet.  Panes come from flatten_geometry: every transparent polygon.
#pragma once
#include "trace/flat_scene.h"
#include "trace/host_tracer.h"

namespace trace {

void find_portals(FlatScene& scene);

}  // namespace trace
