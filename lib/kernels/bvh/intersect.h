// SPDX-License-Identifier: BSD-3-Clause
// Interface between shading and traversal.  Included after compat, vec.h, math.h.  Implemented by bvh8.h (float8 boxes,
// 4-triangle leaves; CPUs, PoCL) or bvh_compact.h (boxes of bytes; GPUs), chosen by LUX_COMPACT.  Both use trees of the
// same Embree BVH builder (bvh/build.h).  Hits are in order of t, then primitive, then instance, so that both give the
// same hit, bit for bit, for any order of the tree.  coincide.h orders surfaces in one place.
#ifndef LUX_INTERSECT_H
#define LUX_INTERSECT_H
#include "kernels/features.h"
#include "kernels/records.h"

#define NO_HIT 0xffffffffu
#define FAR_AWAY 1e30f  // length of an unlimited ray, and distance of distant sources
#define IS_DISTANT(d) ((d) >= 1e29f)
#define RAY_OPAQUE 1u       // query mask: surfaces that stop a shadow ray
#define RAY_TRANSPARENT 2u  // query mask: surfaces a shadow ray may pass (their prim flag is set)
#define RAY_ALL 3u

// Floats of a row of polygon_uv.
#define POLYGON_ROW(count) (((count) + 7u) / 8u * 8u + 1u)

STRUCT(Ray) {
    float3 org;
    float tmin;
    float3 dir;
    float tmax;
};

// prim: index into prims, NO_HIT if none; u, v: barycentric, of v1 and v2; inst: of SceneTables.instances,
// NO_HIT outside of them
STRUCT(Hit) {
    float t;
    uint prim;
    float u, v;
    uint inst;
};

// A query of traversal: the first hit after a given one, in the order above.
STRUCT(Look) {
    Hit hit;      // the first so far; while there is none, t is the ray's length
    float limit;  // boxes beyond are ignored: a little behind hit.t, so that surfaces that coincide with it are found
    float from;   // boxes before are ignored
    float after;  // the given hit, or the ray's tmin and NO_HIT
    uint after_prim, after_inst;
    float size;    // of the origin's coordinates, for the rounding of t
    float second;  // t of the hit after the first; right where it is below limit
};

// Hits closer together than this part of their distance and the origin's coordinates may coincide: 2^-12, far above
// their rounding even where a ray grazes them.
#define TIE_SHARE 2.4414063e-4f

// Stored ids of triangles and shapes: the primitive, with flags for traversal in the top bits.
#define ID_TRANSPARENT 0x80000000u  // class RAY_TRANSPARENT
#define ID_LAST 0x40000000u         // last block of its leaf
#define ID_SHAPE 0x20000000u        // this block holds shapes and instances, not triangles
#define ID_PRIM 0x1fffffffu
// References to children: a node index, a leaf (index of its first block), an instance.  In a leaf: a shape, an
// instance.
#define REF_LEAF 0x80000000u
#define REF_INSTANCE 0x40000000u  // in a leaf; with REF_LEAF on the stack
#define REF_INDEX 0x3fffffffu
#define REF_NONE 0xffffffffu  // no child; on the stack: end of an instance
// Root nodes: of the scene 0, of its surfaces that shadow rays may pass, and of instances, tree k >= 1.
#define ROOT_OF_SCENE 0u
#define ROOT_OF_PANES 1u
#define ROOT_OF_TREE(k) ((k) + 1u)

// First hit among primitives whose class is in mask that look accepts; look->hit.prim = NO_HIT if none.
//   void trace_next(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Look) look)
// 1 if anything in mask lies between tmin and tmax.
//   int trace_any(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask)
#endif
