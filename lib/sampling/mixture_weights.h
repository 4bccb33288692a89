// SPDX-License-Identifier: BSD-3-Clause
// Where diffuse directions aim: how many of them toward each window and patch of sun (kernels/sampling/portals.h), none
// where that would not make less noise, and how many toward highlights (kernels/sampling/highlights.h).
#pragma once
#include "device/device.h"
#include "sampling/pilot_paths.h"

namespace sampling {

constexpr float MOST_AIMED = 0.5f;  // of the directions, so that unknown light is sampled, too

// Weights of a mixture; the kernels' words for them are in Params.
struct Mixture {
    struct Portal {
        uint32_t record;
        float light;
    };
    std::vector<Portal> portals;  // toward which directions are aimed
    float rest = 0, least = 0, most = MOST_AIMED;
    float highlight_share = 0;
};
device::Params with_mixture(device::Params par, const Mixture& mixture);

// Of least second moment.
Mixture weights_of(const Pilots& pilots, const Candidates& candidates);

// The parameters with such a mixture, from scene, view, options and seed alone.  par: as for frames, with all portals;
// the device holds the scene.
device::Params optimise_mixture(device::Device& device, const flatten::FlatScene& scene, const device::Params& par);

// The portals of a scene before anything is known of them.
void pick_all_portals(uint32_t count, float light, float rest, kernels::Params& par);

}  // namespace sampling
