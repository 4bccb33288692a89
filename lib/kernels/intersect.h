// SPDX-License-Identifier: BSD-3-Clause
// The one seam between shading and traversal.  Included after compat, vec.h, math.h.
// One of two files gives the functions below: bvh8.h (float8 boxes, 4-triangle leaves; CPUs, PoCL) or bvh2.h
// (scalar, GPUs), chosen by LUX_BVH2.  Both are built from the same Embree BVH builder (trace/bvh_build.h).
#ifndef LUX_INTERSECT_H
#define LUX_INTERSECT_H

#define NO_HIT 0xffffffffu
#define RAY_OPAQUE 1u       // query mask: surfaces that stop a shadow ray
#define RAY_TRANSPARENT 2u  // query mask: surfaces a shadow ray may pass (their prim flag is set)
#define RAY_ALL 3u

// Analytic shapes in `shapes` (16 floats each): word 0 = kind (as uint bits), 1..15 parameters.
#define SHAPE_SPHERE 1u     // 1-3 centre 4 radius (bubble: the host flips the normal, see prim flags)
#define SHAPE_CONE 2u       // 1-3 p0, 4-6 axis unit, 7 length, 8 r0, 9 r1 (cylinder: r0 = r1); open ends
#define SHAPE_RING 3u       // 1-3 centre 4-6 unit normal 7 r0 8 r1
#define SHAPE_POLYGON 4u    // 1-3 unit normal 4 offset (n.p = offset) 5 dropped axis (uint) 6 first vertex in polygon_uv (uint) 7 count (uint)

typedef struct { float3 org; float tmin; float3 dir; float tmax; } Ray;
typedef struct { float t; uint prim; float u, v; } Hit;  // prim: index into prims, NO_HIT if none; u,v barycentric of v1,v2

typedef struct {
    GLOBAL const float* nodes;      // BVH of either kind
    GLOBAL const float* leaves;     // triangle blocks and shape references
    GLOBAL const float* shapes;     // 16 floats each
    GLOBAL const float* polygon_uv; // projected vertices, 2 floats each
    GLOBAL const uint* prims;       // PRIM_WORDS words a primitive, shading side (tables.h)
    GLOBAL const float* vertices;   // 3 floats each, for normals of triangles
    GLOBAL const uint* u;           // word arena (tables.h): modifiers, materials, .cal code
    GLOBAL const float* f;          // float arena (tables.h)
} SceneTables;

// Nearest hit with tmin < t < tmax among primitives whose class is in mask; hit->prim = NO_HIT if none.
//   void trace_closest(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask, PRIVATE Hit* hit)
// 1 if anything in mask lies between tmin and tmax.
//   int trace_any(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask)
#endif
