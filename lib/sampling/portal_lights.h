// SPDX-License-Identifier: BSD-3-Clause
// Mixture weights of windows, patches of sun and glossy reflectors (kernels/sampling/portals.h), from short pilot paths
// before frame 1.  The pdf of least variance is proportional to the root of the mean square of the radiance, which the
// pilots estimate for each portal and for all other directions.
#pragma once
#include <cmath>
#include <vector>
#include "sampling/pilot_paths.h"

namespace sampling {

// Chooses the parameters portal_* (kernels/tables.h).  pilots: by the cosine; mean: of the light.  par holds all
// portals and their lights; removes portals of small probability, and all if they would not reduce the variance. Writes
// PilotPath::portal_pdf.  tables: of the portals.  to_reflectors: pilots toward glossy reflectors.
void weigh_portals(const kernels::SceneTables& tables, std::vector<PilotPath>& pilots,
                   const std::vector<PilotPath>& to_reflectors, double mean, kernels::Params& par);

// Root mean square radiance of a portal, from pilots toward it; view: portal_view of a pilot's point.
struct AimedLight {
    double square = 0, view = 0;
    void add(double light, double of) {
        square += of * light * light;
        view += of;
    }
    float root() const { return view > 0 ? float(std::sqrt(square / view)) : 0.0f; }
};

}  // namespace sampling
