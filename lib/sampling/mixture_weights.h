// SPDX-License-Identifier: BSD-3-Clause
// Where diffuse directions aim: how many of them toward each window and patch of sun (kernels/sampling/portals.h), none
// where that would not make less noise, and how many toward highlights (kernels/sampling/highlights.h).
#pragma once
#include <vector>
#include "device/device.h"

namespace sampling {

// Sets portal_* and highlight_share of the parameters, from scene, view, options and seed alone.  par: as for frames,
// with all portals; records: those of the portals, then those of the highlights; the device holds the scene.
void optimise_mixture(device::Device& device, const std::vector<float>& records, kernels::Params& par);

// The portals of a scene before anything is known of them.
void pick_all_portals(uint32_t count, float light, float rest, kernels::Params& par);

}  // namespace sampling
