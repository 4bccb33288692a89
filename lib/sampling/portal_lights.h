// SPDX-License-Identifier: BSD-3-Clause
// Mixture weights of windows, patches of sun and glossy reflectors (kernels/sampling/portals.h), from short pilot paths
// before frame 1.  The pdf of least variance is proportional to the root of the mean square of the radiance, which the
// pilots estimate for each portal and for all other directions.
#pragma once
#include "sampling/mixture_weights.h"

namespace sampling {

struct PortalWeights {
    Mixture mixture;
    std::vector<double> pdf;  // of the directions of the pilots by the cosine, over the cosine's
};
// Without portals of small probability, and without any if they would not reduce the variance.  mean: of the light.
PortalWeights weigh_portals(const Pilots& pilots, const Candidates& candidates, double mean);

}  // namespace sampling
