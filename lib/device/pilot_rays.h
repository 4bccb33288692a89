// SPDX-License-Identifier: BSD-3-Clause
// Walks, by which shares of aimed directions are found (mixture_weights.h, kernels/integrator/pilot.h), as they cross
// from and to a device.
#pragma once

namespace device {

// A ray of MODE_PILOT; dir_w: how far it looks, or PILOT_FROM_EYE (kernels/tables.h).  And how its walk ended: the
// radiance gathered (rgb) and, where `bounce`, the surface that a diffuse bounce would leave and its share of the
// light.
struct PilotRay {
    float org[3], dir[3], dir_w;
};
struct PilotEnd {
    float gathered[3], share[3], p[3], n[3];
    bool bounce;
};

}  // namespace device
