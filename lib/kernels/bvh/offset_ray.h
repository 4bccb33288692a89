// SPDX-License-Identifier: BSD-3-Clause
// Origin of a new ray, far enough from the surface that it leaves for the ray not to hit it.  After Pharr, Jakob and
// Humphreys, "Physically Based Rendering", "Managing Rounding Error": surface_at() moves the hit onto the surface
// again, so that the length of the ray that found it has no part in its error, and bounds how far from the surface as
// traversal sees it the point may be, along the normal.  With u = 2^-24, E the size of the primitive (prim_extent) and
// S = |nx px| + |ny py| + |nz pz|:
//   4 u S  the moved point: a dot product of three terms, and a sum
//   1 u S  the origin of the ray: p + n d
//   4 u S  the distance that traversal computes from plane equations; vertices and offsets are rounded, too
//   10 u E the normal, the corners, the traversal of triangles (in coordinates relative to the origin) and of quadrics
// The sum is below 10 u (E + S), SURFACE_ROUNDING of tables.h.  In an instance, S also holds the same sum over its
// matrix (surface.h).
#ifndef LUX_OFFSET_RAY_H
#define LUX_OFFSET_RAY_H

// p: hit point; n: unit geometric normal on the side of the new ray; distance: Surface.rounding.
FN float3 offset_ray(float3 p, float3 n, float distance) { return madd3(n, distance, p); }

// End of a shadow ray to a point at distance d, just before it.
#define SHADOW_SHARE 9.5367432e-7f  // 2^-20
FN float shadow_end(float d) { return d * (1.0f - SHADOW_SHARE); }
#endif
