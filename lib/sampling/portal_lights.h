// SPDX-License-Identifier: BSD-3-Clause
// How much of the diffuse directions goes toward each window, patch of sun and glossy reflector
// (kernels/sampling/portals.h), from short pilots before frame 1: the pdf of least noise is as the root of the mean
// square of the light, so that is what is asked of each portal and of all else.
#pragma once
#include <cmath>
#include <vector>
#include "kernels/dialect/host.h"

namespace sampling {

// A pilot from a place on a surface, and what it has found.
struct PilotPath {
    kernels::float3 p, n, dir;      // the place, its normal, the direction
    double met = 0, beyond = 0;     // light, and the share of the light beyond
    double portals = 1, shine = 1;  // pdfs of its direction, with portals and among highlights, over the cosine's
    double weight = 1;              // 1 for a pilot by the cosine, where no highlight is met
    uint32_t target = 0;            // the record of the glossy reflector to which it goes
};

// What the parameters (portal_* of kernels/tables.h) are to be.  pilots: by the cosine; mean: of the light.  par has
// all portals and their lights; those that are hardly aimed at are left out, and all of them if the noise would not be
// less.  Writes PilotPath::portals.  records: of the portals, at par.portals_at.  to_reflectors: pilots to glossy
// reflectors.
void weigh_portals(const std::vector<float>& records, std::vector<PilotPath>& pilots,
                   const std::vector<PilotPath>& to_reflectors, double mean, kernels::Params& par);

// The light of one portal as pilots toward it find it; view: portal_view of each one's place.
struct AimedLight {
    double square = 0, view = 0;
    void add(double light, double of) {
        square += of * light * light;
        view += of;
    }
    float root() const { return view > 0 ? float(std::sqrt(square / view)) : 0.0f; }
};

}  // namespace sampling
