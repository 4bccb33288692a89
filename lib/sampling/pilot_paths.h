// SPDX-License-Identifier: BSD-3-Clause
// Short paths from points on surfaces (MODE_PILOT), and the moments of the light that they find, for any mixture
// weights. A direction of q times the cosine's pdf counts 1/q (Veach 1997, section 9.2).
#pragma once
#include <algorithm>
#include <vector>
#include "device/device.h"
#include "kernels/dialect/host.h"

namespace sampling {

// What a mixture may aim at.
struct Candidates {
    kernels::SceneTables tables;  // of portals and highlights
    device::Params par;           // with all of them
};

// A pilot path from a point on a surface, and its result.
struct PilotPath {
    kernels::float3 p, n, dir;            // point, normal, direction
    double gathered = 0, throughput = 0;  // luminance up to its first diffuse bounce, and the throughput there
    double highlight_pdf = 1;             // of its direction, toward highlights, over the cosine's
    double weight = 1;                    // 1 for a pilot by the cosine where no highlight can be sampled
    double view = 0;                      // portal_view of its point, toward a portal
    uint32_t portal = 0;                  // record of that portal

    double light(double mean) const { return gathered + throughput * mean; }  // mean: beyond its bounce
};

// From the points that the eye sees and those that pilots from there reach.
struct Pilots {
    std::vector<PilotPath> by_cosine, to_portals, to_highlights;
};
Pilots trace_pilots(device::Device& device, const Candidates& candidates);

struct Moments {
    double mean = 0, square = 0;
};

// For the moments of the light of all bounces: each bounce adds what its pilot gathered and its throughput times the
// light of the next bounce, over the pdf.
struct PilotSums {
    double gathered = 0, throughput = 0, gathered2 = 0, both = 0, throughput2 = 0;

    // over: ratio of the direction's pdf to the cosine's
    void add(const PilotPath& pilot, double weight, double over) {
        gathered += weight * pilot.gathered;
        throughput += weight * pilot.throughput;
        gathered2 += weight * pilot.gathered * pilot.gathered / over;
        both += weight * pilot.gathered * pilot.throughput / over;
        throughput2 += weight * pilot.throughput * pilot.throughput / over;
    }

    // The moments at a point by this number of pilots, bounce by bounce up to -ab; they have converged after 250.
    Moments all_bounces(const kernels::Params& par, double pilots) const {
        Moments at;
        for (int bounce = std::min(par.ab, 250); bounce > 0; bounce--)
            at = {(gathered + throughput * at.mean) / pilots,
                  (gathered2 + 2 * both * at.mean + throughput2 * at.square) / pilots};
        return at;
    }
};

}  // namespace sampling
