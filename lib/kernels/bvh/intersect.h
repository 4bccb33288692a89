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

// ---- analytic shapes, SHAPE_FLOATS each in SceneTables.shapes: SHAPE_KIND, then what the kind needs
#define SHAPE_FLOATS 16u
#define SHAPE_KIND 0u  // word
// a bubble is the same: the host flips its normal (flags of the primitive)
#define SHAPE_SPHERE 1u
#define SPHERE_CENTRE 1u  // 3
#define SPHERE_RADIUS 4u
// with open ends; of a cylinder both radii are the same
#define SHAPE_CONE 2u
#define CONE_START 1u  // 3
#define CONE_AXIS 4u   // 3, unit
#define CONE_LENGTH 7u
#define CONE_RADIUS0 8u
#define CONE_RADIUS1 9u
#define SHAPE_RING 3u
#define RING_CENTRE 1u  // 3
#define RING_NORMAL 4u  // 3, unit
#define RING_INNER 7u   // radius
#define RING_OUTER 8u
// polygon_uv holds the two remaining coordinates in order (axis 0 dropped: y z, 1: x z, 2: x y), each in a row of its
// own: the last corner, all corners, and NaN so that eight can be read from each corner on
#define SHAPE_POLYGON 4u
#define POLYGON_NORMAL 1u  // 3, unit
#define POLYGON_OFFSET 4u  // n.p of its plane
#define POLYGON_AXIS 5u    // the dropped axis (word)
#define POLYGON_FIRST 6u   // its first row in polygon_uv (word)
#define POLYGON_COUNT 7u   // the number of its corners (word)
#define POLYGON_MARGIN 8u  // points this near to an edge are inside

// Floats of a row.
#define POLYGON_ROW(count) (((count) + 7u) / 8u * 8u + 1u)

// an instance of tree k of the BVH; only tree 0 may hold instances
#define SHAPE_INSTANCE 5u
#define INSTANCE_MATRIX 1u   // 12: local from world, three rows of four (instance_point)
#define INSTANCE_TREE 13u    // k >= 1 (word)
#define INSTANCE_NUMBER 14u  // for Hit.inst (word)
#define INSTANCE_CLASS 15u   // RAY_* of all its surfaces, and INSTANCE_CLEAR; 0: their own (word)
#define INSTANCE_CLEAR 4u    // its modifier is of a transparent type (PRIM_CLEAR)

STRUCT(Ray) {
    float3 org;
    float tmin;
    float3 dir;
    float tmax;
};

// prim: index into prims, NO_HIT if none; u, v: barycentric, of v1 and v2; inst: INSTANCE_NUMBER, NO_HIT outside
// instances
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
#define ID_SHAPE 0x20000000u        // this block holds shapes, not triangles
#define ID_PRIM 0x1fffffffu
// References to children: a node index, a leaf (index of its first block), an instance (index of its shape).
#define REF_LEAF 0x80000000u
#define REF_INSTANCE 0x40000000u  // with REF_LEAF; on the stack only
#define REF_INDEX 0x3fffffffu
#define REF_NONE 0xffffffffu  // no child; on the stack: end of an instance
// Root nodes: of the scene 0, of its surfaces that shadow rays may pass, and of instances, tree k >= 1.
#define ROOT_OF_SCENE 0u
#define ROOT_OF_PANES 1u
#define ROOT_OF_TREE(k) ((k) + 1u)

FN GLOBAL const float* shape_record(TABLES(const SceneTables) s, uint number) {
    return s->shapes + (ulong64)number * SHAPE_FLOATS;
}

// First hit among primitives whose class is in mask that look accepts; look->hit.prim = NO_HIT if none.
//   void trace_next(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Look) look)
// 1 if anything in mask lies between tmin and tmax.
//   int trace_any(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask)
#endif
