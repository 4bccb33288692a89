// SPDX-License-Identifier: BSD-3-Clause
// The values of a point that the techniques of the mixture (mixture.h) need.  Path reuse stores all of them at each
// prefix vertex (integrator/state.h), so that a new field needs no other line.  float and uint alone: the same layout
// on all devices.
#ifndef LUX_MIXTURE_FIELDS_H
#define LUX_MIXTURE_FIELDS_H

STRUCT(Mixture) {
    float light;      // through all portals
    uint highlights;  // rectangles that can be sampled, one bit each
};
#endif
