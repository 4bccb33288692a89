// SPDX-License-Identifier: BSD-3-Clause
// Apertures: rectangles about the relays that a virtual source's light must come through (APERTURE_* of tables.h).
#ifndef LUX_RELAY_APERTURE_H
#define LUX_RELAY_APERTURE_H

// Does no light from a ball about p + to sine p through the aperture?  sine: the sine of half the angle that the ball
// subtends.  Apertures stand where the relays of a virtual source seem to be from p.  tight: no more is added to the
// aperture than the ball's cone needs; else three times its width, as the frames of scenes with few sources have it.
FN int aperture_occludes(GLOBAL const float* aperture, float3 p, float3 to, float sine, int tight) {
    float3 c = sub3(f3_at(aperture + APERTURE_CENTRE), p), n = f3_at(aperture + APERTURE_NORMAL);
    float down = dot3(n, to), d2 = dot3(to, to);
    if (down * down < 4.0f * sine * sine * d2) return 0;  // too much on edge to tell
    float along = dot3(n, c) / down;
    if (along < -1e-3f || (down > 0.0f && aperture[APERTURE_BOTH_SIDES] == 0.0f)) return 1;  // behind p; its back

    float3 u = f3_at(aperture + APERTURE_U), v = f3_at(aperture + APERTURE_V), off = sub3(scale3(to, along), c);
    float at_u = fabs_(dot3(off, u)), at_v = fabs_(dot3(off, v));
    if (at_u <= 1.001f && at_v <= 1.001f) return 0;  // the ball's middle is seen

    // How far the cone reaches on the aperture's plane.  Its far side is more on edge than its axis.
    float wide = 3.0f * sine * fabs_(along) * d2 / fabs_(down);
    if (tight) wide = sine * fabs_(along) * d2 / (fabs_(down) - sine * (1.0f + sine) * sqrt_(d2));
    return at_u > 1.001f + wide * length3(u) || at_v > 1.001f + wide * length3(v);
}
#endif
