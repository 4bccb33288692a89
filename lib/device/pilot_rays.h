// SPDX-License-Identifier: BSD-3-Clause
// Pilot paths (sampling/mixture_weights.h, kernels/integrator/pilot.h) as they go to a device and come back.
#pragma once

namespace device {

// A ray of MODE_PILOT; dir_w: its length, or PILOT_FROM_EYE (kernels/tables.h).  And the end of its path: the radiance
// gathered (rgb) and, if `bounce`, point and normal of the diffuse bounce and the throughput of the path there.
struct PilotRay {
    float org[3], dir[3], dir_w;
};
struct PilotEnd {
    float gathered[3], throughput[3], p[3], n[3];
    bool bounce;
};

}  // namespace device
