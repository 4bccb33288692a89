// SPDX-License-Identifier: BSD-3-Clause
// The one seam between shading and traversal.  Included after compat, vec.h, math.h.
// One of two files gives the functions below: bvh8.h (float8 boxes, 4-triangle leaves; CPUs, PoCL) or bvh2.h
// (scalar, GPUs), chosen by LUX_BVH2.  Both are built from the same Embree BVH builder (bvh/build.h).
// Ties (equal t) go to the lower primitive, so that both give the same hit, bit for bit, in any order of the tree.
#ifndef LUX_INTERSECT_H
#define LUX_INTERSECT_H

#define NO_HIT 0xffffffffu
#define FAR_AWAY 1e30f  // how far a ray looks that nothing ends, and how far away distant sources are
#define IS_FAR(d) ((d) >= 1e29f)
#define RAY_OPAQUE 1u       // query mask: surfaces that stop a shadow ray
#define RAY_TRANSPARENT 2u  // query mask: surfaces a shadow ray may pass (their prim flag is set)
#define RAY_ALL 3u

// Analytic shapes in `shapes` (16 floats each): word 0 = kind (as uint bits), 1..15 parameters.
#define SHAPE_FLOATS 16u
#define SHAPE_SPHERE 1u  // 1-3 centre 4 radius (bubble: the host flips the normal, see prim flags)
#define SHAPE_CONE 2u    // 1-3 p0, 4-6 axis unit, 7 length, 8 r0, 9 r1 (cylinder: r0 = r1); open ends
#define SHAPE_RING 3u    // 1-3 centre 4-6 unit normal 7 r0 8 r1 (r0 <= r1)
// Polygon: 1-3 unit normal 4 offset (n.p = offset) 5 dropped axis (uint) 6 first vertex in polygon_uv (uint) 7 count
// (uint). polygon_uv holds the two coordinates left, in order: axis 0 dropped: (y, z), 1: (x, z), 2: (x, y).
#define SHAPE_POLYGON 4u
// Instance of tree k of the BVH (only tree 0 may hold instances): 1-12 local-from-world matrix, three rows of four;
// 13 tree (uint, >= 1); 14 number for Hit.inst (uint); 15 class of all it holds: RAY_OPAQUE, RAY_TRANSPARENT, or 0 =
// their own.
#define SHAPE_INSTANCE 5u

typedef struct {
    float3 org;
    float tmin;
    float3 dir;
    float tmax;
} Ray;
// prim: index into prims, NO_HIT if none; u,v barycentric of v1,v2; inst: word 14 of the instance, NO_HIT outside
// instances
typedef struct {
    float t;
    uint prim;
    float u, v;
    uint inst;
} Hit;

// Stored ids of triangles and shapes: the primitive and, in the top bits, what traversal must know.
#define ID_TRANSPARENT 0x80000000u  // class RAY_TRANSPARENT
#define ID_LAST 0x40000000u         // last block of its leaf
#define ID_SHAPE 0x20000000u        // this block holds shapes, not triangles
#define ID_PRIM 0x1fffffffu
// References to children: a node index, a leaf (index of its first block), an instance (index of its shape).
#define REF_LEAF 0x80000000u
#define REF_INSTANCE 0x40000000u  // with REF_LEAF; on the stack only
#define REF_INDEX 0x3fffffffu
#define REF_NONE 0xffffffffu  // no child; on the stack: end of an instance

// What a scene is on a device, TABLE(type, name) for each: what the BVH builder gives, and what flattening gives.
// clang-format off
#define BVH_TABLES(TABLE)                                                                   \
    TABLE(float, nodes)       /* BVH of either kind; node k is the root of tree k */        \
    TABLE(float, leaves)      /* triangle blocks and shape references */
#define FLAT_TABLES(TABLE)                                                                  \
    TABLE(float, shapes)      /* SHAPE_FLOATS each */                                       \
    TABLE(float, polygon_uv)  /* projected vertices, 2 floats each */                       \
    TABLE(uint, prims)        /* PRIM_WORDS each, shading side (tables.h) */                \
    TABLE(float, vertices)    /* 3 floats each, for normals of triangles */                 \
    TABLE(uint, u)            /* word arena (tables.h): modifiers, materials, .cal code */  \
    TABLE(float, f)           /* float arena (tables.h) */
#define SCENE_TABLES(TABLE) BVH_TABLES(TABLE) FLAT_TABLES(TABLE)
// clang-format on

#define TABLE_POINTER(type, name) GLOBAL const type* name;
typedef struct {
    SCENE_TABLES(TABLE_POINTER)
} SceneTables;

// Nearest hit with tmin < t < tmax among primitives whose class is in mask; hit->prim = NO_HIT if none.
//   void trace_closest(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask, PRIVATE Hit* hit)
// 1 if anything in mask lies between tmin and tmax.
//   int trace_any(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask)
#endif
