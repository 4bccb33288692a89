// SPDX-License-Identifier: BSD-3-Clause
// Walks, by which shares of aimed directions are found (aim_shares.h, kernels/integrator/walk.h), as they cross from
// and to a device.
#pragma once

namespace device {

// A ray of MODE_WALK; dir_w: how far it looks, or WALK_FROM_EYE (kernels/tables.h).  And how its walk ended: the
// radiance gathered (rgb) and, where `bounce`, the surface that a diffuse bounce would leave and its share of the
// light.
struct WalkRay {
    float org[3], dir[3], dir_w;
};
struct WalkEnd {
    float gathered[3], share[3], p[3], n[3];
    bool bounce;
};

}  // namespace device
