// SPDX-License-Identifier: BSD-3-Clause
// Apertures: rectangles around the relays of a virtual source, through which its light must pass (APERTURE_* of
// tables.h).
#ifndef LUX_RELAY_APERTURE_H
#define LUX_RELAY_APERTURE_H

// Returns 1 if the aperture blocks all light from a ball about p + to.  sine: of half the angle that the ball subtends.
// Apertures stand at the apparent places of the relays as seen from p.  tight: the aperture is extended by the ball's
// cone only; else by three times its width, as in frames of scenes with few sources.
FN int aperture_occludes(GLOBAL const Aperture* aperture, float3 p, float3 to, float sine, int tight) {
    float3 c = sub3(f3_of(aperture->centre), p), n = f3_of(aperture->normal);
    float down = dot3(n, to), d2 = dot3(to, to);
    if (down * down < 4.0f * sine * sine * d2) return 0;  // too nearly on edge to tell
    float along = dot3(n, c) / down;
    if (along < -1e-3f || (down > 0.0f && aperture->both_sides == 0u)) return 1;  // behind p; its back

    float3 u = f3_of(aperture->u), v = f3_of(aperture->v), off = sub3(scale3(to, along), c);
    float at_u = fabs_(dot3(off, u)), at_v = fabs_(dot3(off, v));
    if (at_u <= 1.001f && at_v <= 1.001f) return 0;  // the ball's middle is visible

    // Radius of the cone on the aperture's plane; its far side is more oblique than its axis.
    float wide = 3.0f * sine * fabs_(along) * d2 / fabs_(down);
    if (tight) wide = sine * fabs_(along) * d2 / (fabs_(down) - sine * (1.0f + sine) * sqrt_(d2));
    return at_u > 1.001f + wide * length3(u) || at_v > 1.001f + wide * length3(v);
}
#endif
