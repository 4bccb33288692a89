// SPDX-License-Identifier: BSD-3-Clause
// Short paths from points on surfaces (MODE_PILOT), and the moments of the light that they find, for any mixture
// weights. A direction of q times the cosine's pdf counts 1/q (Veach 1997, section 9.2).
#pragma once
#include <algorithm>
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
