// SPDX-License-Identifier: BSD-3-Clause
// Rays that the host gives to a device: to points of splatted emitters (render/drawn_sources.h), and pilot paths
// (sampling/mixture_weights.h), with what comes back of these.
#pragma once
#include <cstdint>

namespace device {

// A straight ray from the eye to a point of active source `source`; weight: the fraction of a pixel that the point
// represents.
struct SplatRay {
    float org[3], dir[3], dist, weight;
    uint32_t source;
};

// A ray of MODE_PILOT; length: of the ray, or PILOT_FROM_EYE (kernels/tables.h).  And the end of its path: the radiance
// gathered (rgb) and, if `bounce`, point and normal of the diffuse bounce and the throughput of the path there.
struct PilotRay {
    float org[3], dir[3], length;
};
struct PilotEnd {
    float gathered[3], throughput[3], p[3], n[3];
    bool bounce;
};

}  // namespace device
