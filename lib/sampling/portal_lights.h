// SPDX-License-Identifier: BSD-3-Clause
// Mixture weights of windows, patches of sun and glossy reflectors (kernels/sampling/portals.h), from short pilot paths
// before frame 1.  The pdf of least variance is proportional to the root of the mean square of the radiance, which the
// pilots estimate for each portal and for all other directions.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>
#include "device/given_rays.h"
#include "kernels/dialect/host.h"

namespace sampling {

// A pilot path from a point on a surface, and its result.
struct PilotPath {
    kernels::float3 p, n, dir;                 // point, normal, direction
    double gathered = 0, throughput = 0;       // luminance up to its first diffuse bounce, and the throughput there
    double portal_pdf = 1, highlight_pdf = 1;  // of its direction, toward portals and highlights, over the cosine's
    double weight = 1;                         // 1 for a pilot by the cosine where no highlight can be sampled
    uint32_t target = 0;                       // record of the glossy reflector toward which it goes
    void set_end(const device::PilotEnd& end);
};

// Bounces by which moments of the light have converged, or the limit of -ab.
inline int bounces_of_moments(const kernels::Params& par) { return std::min(par.ab, 250); }

// Chooses the parameters portal_* (kernels/tables.h).  pilots: by the cosine; mean: of the light.  par holds all
// portals and their lights; removes portals of small probability, and all if they would not reduce the variance. Writes
// PilotPath::portal_pdf.  records: of the portals, at par.portals_at.  to_reflectors: pilots toward glossy reflectors.
void weigh_portals(const std::vector<float>& records, std::vector<PilotPath>& pilots,
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
