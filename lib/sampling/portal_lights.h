// SPDX-License-Identifier: BSD-3-Clause
// How much of the diffuse directions goes toward each window, patch of sun and polished strip
// (kernels/sampling/portals.h), from short walks before frame 1: the density of least noise is as the root of the mean
// square of the light, so that is what is asked of each portal and of all else.
#pragma once
#include <cmath>
#include <vector>
#include "kernels/dialect/host.h"

namespace sampling {

// A walk from a place on a surface, and what it has found.
struct Walk {
    kernels::float3 p, n, dir;      // the place, its normal, the direction
    double met = 0, beyond = 0;     // light, and the share of the light beyond
    double portals = 1, shine = 1;  // densities of its direction, with portals and among highlights, over the cosine's
    double weight = 1;              // 1 for a walk by the cosine, where no highlight is met
    uint32_t aim = 0;               // the record of the polished strip to which it goes
};

// What the parameters (portal_* of kernels/tables.h) are to be.  walks: by the cosine; mean: of the light.  par has all
// portals and their lights; those that are hardly aimed at are left out, and all of them if the noise would not be
// less.  Writes Walk::portals.  records: of the portals, at par.portals_at.  to_strips: walks to polished ones.
void weigh_portals(const std::vector<float>& records, std::vector<Walk>& walks, const std::vector<Walk>& to_strips,
                   double mean, kernels::Params& par);

// The light of one portal as walks toward it find it; view: portal_view of each one's place.
struct AimedLight {
    double square = 0, view = 0;
    void add(double light, double of) {
        square += of * light * light;
        view += of;
    }
    float root() const { return view > 0 ? float(std::sqrt(square / view)) : 0.0f; }
};

}  // namespace sampling
