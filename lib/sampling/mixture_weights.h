// SPDX-License-Identifier: BSD-3-Clause
// Where diffuse directions aim: how many of them toward each window and patch of sun (kernels/sampling/portals.h), none
// where that would not make less noise, and how many toward highlights (kernels/sampling/highlights.h).
#pragma once
#include "device/device.h"

namespace sampling {

// The parameters with portal_* and highlight_share, from scene, view, options and seed alone.  par: as for frames, with
// all portals; the device holds the scene.
device::Params optimise_mixture(device::Device& device, const flatten::FlatScene& scene, device::Params par);

// The portals of a scene before anything is known of them.
void pick_all_portals(uint32_t count, float light, float rest, kernels::Params& par);

}  // namespace sampling
