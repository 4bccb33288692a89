// SPDX-License-Identifier: BSD-3-Clause
// Origin of a new ray, offset so that the ray does not hit the surface that it leaves.  After Waechter and Binder 2019
// ("A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, chapter 6): moves along the geometric
// normal by a fixed number of units in the last place of the position, axis by axis.  The rounding of a hit point also
// grows with the ray's length, hence `error_scale`.  Limit: distances to a triangle of hundreds of metres are exact to
// some 1e-7 of its size only, so `error_scale` includes the size of the surface (surface.h) and a least value
// (FlatScene::least_error_scale), which near the origin is 2^-16 m in a room.  With the ray's length alone 0.1 % of the
// rays that leave a ground of 2 km hit it again.
#ifndef LUX_OFFSET_RAY_H
#define LUX_OFFSET_RAY_H

#define OFFSET_SHARE 3.0517578e-5f  // 2^-15: 256 ulp

FN float offset_axis(float p, float n, float least) {
    float d = fabs_(p) * OFFSET_SHARE;
    return p + n * (d > least ? d : least);
}

// p: hit point; n: unit geometric normal on the side of the new ray; error_scale: Surface.error_scale.
FN float3 offset_ray(float3 p, float3 n, float error_scale) {
    float least = error_scale * (0.03125f * OFFSET_SHARE);
    return F3(offset_axis(p.x, n.x, least), offset_axis(p.y, n.y, least), offset_axis(p.z, n.z, least));
}

// End of a shadow ray to a point at distance d, just before the surface there.
FN float shadow_end(float d) { return d * (1.0f - OFFSET_SHARE); }
#endif
