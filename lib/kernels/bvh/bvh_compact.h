// SPDX-License-Identifier: BSD-3-Clause
// Traversal for GPUs: one ray per work item, nodes of eight children whose boxes are bytes (Ylitie, Karras, Laine 2017,
// "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs").  Compared with binary nodes a path to a
// leaf has a third of the steps, each of which waits for memory, and the stack has one entry a level.  The slot of a
// child encodes its position in its node: bit 0 is set if toward +x, 1: +y, 2: +z.  So a ray visits slots in an order
// that depends on its direction alone, and distances are not stored.
// Node: 20 floats, read by four:
//   0-2    the least corner of its boxes
//   3      word: bytes 0-2: a float's exponents, of the steps along x y z; byte 3: bit k is set if slot k is a node
//   4      word: the first of the slots that are nodes; the others follow
//   5      word: the first block of the slots that are leaves
//   6, 7   words: byte k of the eight: COMPACT_LEAF + number of its leaf's first block after the first; 0: not a leaf
//   8-19   words: bytes, each a number of steps from the corner: min x of slots 0-3, of 4-7, max x, min y ...
// Leaf block: 12 floats: v0 xyz, id, v1 xyz, 0, v2 xyz, 0; with ID_SHAPE in the id: word 0 = index of the shape.
#ifndef LUX_BVH_COMPACT_H
#define LUX_BVH_COMPACT_H

#define COMPACT_NODE_FLOATS 20u
#define COMPACT_BLOCK_FLOATS 12u
#define COMPACT_LEAF 128u
#define COMPACT_STACK 64  // entries; the builder refuses trees that need more (bvh/build.cpp)
// Rounding of (corner - origin) * inverse and of byte * step * inverse, relative: at most 6 times 2^-24, and a margin.
#define COMPACT_ROUNDING 4e-7f

// Stack, two words an entry: a node and its slots, or, with 0 for the slots, an instance (reference) or the end of one
// (REF_NONE). Slots are in the ray's order: bits 0-7 nodes, 8-15 leaves.  *waiting: number of words; outside the
// struct, because an array lies in memory and the number should be in a register.
FN void compact_push(PRIVATE(uint) stack, PRIVATE(int) waiting, uint node, uint slots) {
    stack[*waiting] = node;
    stack[*waiting + 1] = slots;
    *waiting += 2;
}

// Slot k is visited at position 7 - (k ^ order).
FN uint compact_order(PRIVATE(const WoopRay) r) {
    return (r->inv.x < 0.0f ? 0u : 1u) | (r->inv.y < 0.0f ? 0u : 2u) | (r->inv.z < 0.0f ? 0u : 4u);
}

// Moves bit k of both bytes to bit k ^ order.
FN uint compact_in_order(uint bits, uint order) {
    if ((order & 1u) != 0u) bits = (bits & 0x5555u) << 1 | (bits >> 1 & 0x5555u);
    if ((order & 2u) != 0u) bits = (bits & 0x3333u) << 2 | (bits >> 2 & 0x3333u);
    if ((order & 4u) != 0u) bits = (bits & 0x0f0fu) << 4 | (bits >> 4 & 0x0f0fu);
    return bits;
}

// Distances at which a ray enters and leaves slabs of a node along an axis: byte times step, plus near or far.
STRUCT(CompactAxis) { float step, near, far; };

FN void compact_axis(float corner, uint exponent, float org, float inv, PRIVATE(CompactAxis) axis) {
    float at = (corner - org) * inv, step = as_float_(exponent << 23) * inv;
    float rounding = (fabs_(at) + 255.0f * fabs_(step)) * COMPACT_ROUNDING;
    axis->step = step;
    axis->near = at - rounding;
    axis->far = at + rounding;
}

FN float compact_plane(uint bytes, uint k, float step, float from) {
    return (float)(bytes >> 8u * k & 255u) * step + from;
}

// Four boxes, one a byte of each word: which of them the ray hits between tmin >= 0 and limit.
FN uint compact_boxes(PRIVATE(const CompactAxis) x, PRIVATE(const CompactAxis) y, PRIVATE(const CompactAxis) z,
                      uint near_x, uint far_x, uint near_y, uint far_y, uint near_z, uint far_z, float tmin,
                      float limit) {
    uint met = 0u;
    for (uint k = 0u; k < 4u; k++) {
        float nx = compact_plane(near_x, k, x->step, x->near), fx = compact_plane(far_x, k, x->step, x->far);
        float ny = compact_plane(near_y, k, y->step, y->near), fy = compact_plane(far_y, k, y->step, y->far);
        float nz = compact_plane(near_z, k, z->step, z->near), fz = compact_plane(far_z, k, z->step, z->far);
        float tn = nx > ny ? nx : ny, tf = fx < fy ? fx : fy;
        tn = tn > nz ? tn : nz;
        tn = tn > tmin ? tn : tmin;
        tf = tf < fz ? tf : fz;
        tf = tf < limit ? tf : limit;
        met |= tn <= tf ? 1u << k : 0u;
    }
    return met;
}

FN GLOBAL const float* compact_at(TABLES(const SceneTables) s, uint node) {
    return s->nodes + (ulong64)node * COMPACT_NODE_FLOATS;
}

// Bit k: byte k of the word is a leaf.
FN uint compact_leaves(uint word) { return (word >> 7 & 0x01010101u) * 0x10204080u >> 28; }

// Slots of a node that a ray hits (as on the stack).
FN uint compact_node(GLOBAL const float* n, PRIVATE(const WoopRay) r, uint order, float tmin, float tmax) {
    float4 corner = loadf4_(n), children = loadf4_(n + 4);
    float4 bx = loadf4_(n + 8), by = loadf4_(n + 12), bz = loadf4_(n + 16);
    uint word = as_uint_(corner.w), lo = as_uint_(children.z), hi = as_uint_(children.w), met;
    int back_x = r->inv.x < 0.0f, back_y = r->inv.y < 0.0f, back_z = r->inv.z < 0.0f;
    float limit = tmax * SLAB_WIDEN;
    CompactAxis x, y, z;
    compact_axis(corner.x, word & 255u, r->org.x, r->inv.x, &x);
    compact_axis(corner.y, word >> 8 & 255u, r->org.y, r->inv.y, &y);
    compact_axis(corner.z, word >> 16 & 255u, r->org.z, r->inv.z, &z);
    met = compact_boxes(&x, &y, &z, as_uint_(back_x ? bx.z : bx.x), as_uint_(back_x ? bx.x : bx.z),
                        as_uint_(back_y ? by.z : by.x), as_uint_(back_y ? by.x : by.z), as_uint_(back_z ? bz.z : bz.x),
                        as_uint_(back_z ? bz.x : bz.z), tmin, limit);
    met |= compact_boxes(&x, &y, &z, as_uint_(back_x ? bx.w : bx.y), as_uint_(back_x ? bx.y : bx.w),
                         as_uint_(back_y ? by.w : by.y), as_uint_(back_y ? by.y : by.w), as_uint_(back_z ? bz.w : bz.y),
                         as_uint_(back_z ? bz.y : bz.w), tmin, limit)
           << 4;
    return compact_in_order((met & (word >> 24)) | (met & (compact_leaves(lo) | compact_leaves(hi) << 4)) << 8, order);
}

// Tests a shape of a leaf.  Returns 1 if it became the nearest hit; an instance goes on the stack.
FN int compact_shape(TABLES(const SceneTables) s, uint number, uint id, PRIVATE(const TreeRay) way, PRIVATE(uint) stack,
                     PRIVATE(int) waiting, PRIVATE(Look) look) {
    float t;
    if (HAS(INSTANCES) && (number & REF_INSTANCE) != 0u) {
        compact_push(stack, waiting, number | REF_LEAF, 0u);
        return 0;
    }

    return ((way->mask >> (id >> 31)) & 1u) != 0u &&
           shape_hit(&s->shapes[number], s->polygon_uv, way->r.org, way->r.dir, look->from, &t) &&
           hit_offer(look, t, id & ID_PRIM, 0.0f, 0.0f, way->inst);
}

// The same for a triangle.
FN int compact_triangle(float4 v0, float4 v1, float4 v2, uint id, PRIVATE(const TreeRay) way, PRIVATE(Look) look) {
    float t, u, v;
    return ((way->mask >> (id >> 31)) & 1u) != 0u &&
           woop_triangle(&way->r, F3(v0.x, v0.y, v0.z), F3(v1.x, v1.y, v1.z), F3(v2.x, v2.y, v2.z), &t, &u, &v) &&
           t > look->from && hit_offer(look, t, id & ID_PRIM, u, v, way->inst);
}

FN int compact_leaf(TABLES(const SceneTables) s, uint ref, PRIVATE(const TreeRay) way, PRIVATE(uint) stack,
                    PRIVATE(int) waiting, PRIVATE(Look) look) {
    GLOBAL const float* block = s->leaves + (ulong64)(ref & REF_INDEX) * COMPACT_BLOCK_FLOATS;
    int found = 0;

    for (;; block += COMPACT_BLOCK_FLOATS) {
        float4 v0 = loadf4_(block), v1 = loadf4_(block + 4), v2 = loadf4_(block + 8);
        uint id = as_uint_(v0.w);
        if ((id & ID_SHAPE) == 0u) {
            if (compact_triangle(v0, v1, v2, id, way, look)) found = 1;
        } else {
            if (compact_shape(s, as_uint_(v0.x), id, way, stack, waiting, look)) found = 1;
        }
        if ((id & ID_LAST) != 0u) return found;
    }
}

// Takes the next of a node's *slots, leaves first: a reference.
FN uint compact_next(GLOBAL const float* n, uint order, PRIVATE(uint) slots) {
    float4 children = loadf4_(n + 4);
    uint place = highest_bit_(*slots), slot = (place & 7u) ^ order;
    *slots &= ~(1u << place);
    if (place >= 8u) {
        uint of_four = as_uint_(slot < 4u ? children.z : children.w) >> 8u * (slot & 3u);
        return (as_uint_(children.y) + (of_four & (COMPACT_LEAF - 1u))) | REF_LEAF;
    }
    return as_uint_(children.x) + bit_count_(as_uint_(n[3]) >> 24 & ((1u << slot) - 1u));
}

// Finds the first hit that look accepts; if any != 0, any hit (returns 1 at once).
FN int compact_traverse(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, int any, PRIVATE(Look) look) {
    uint stack[2 * COMPACT_STACK];
    TreeRay way;
    uint cur = mask == RAY_TRANSPARENT ? ROOT_OF_PANES : ROOT_OF_SCENE, node = 0u, slots = 0u, order;
    int found = 0, waiting = 0;
    enter_scene(ray, mask, &way);
    order = compact_order(&way.r);

    for (;;) {
        if ((cur & REF_LEAF) == 0u) {
            if (slots != 0u) compact_push(stack, &waiting, node, slots);
            node = cur;
            slots = compact_node(compact_at(s, node), &way.r, order, look->from, look->limit);
        } else if (!HAS(INSTANCES) || (cur & REF_INSTANCE) == 0u) {
            if (HAS(INSTANCES) && slots != 0u) {  // first, so that those of one leaf wait one at a time
                compact_push(stack, &waiting, node, slots);
                slots = 0u;
            }
            if (compact_leaf(s, cur, &way, stack, &waiting, look)) found = 1;
            if (any && found) return 1;
        } else if (cur == REF_NONE) {  // back from an instance
            enter_scene(ray, mask, &way);
            order = compact_order(&way.r);
        } else if (enter_instance(s, cur & REF_INDEX, ray, mask, &way, &cur)) {
            compact_push(stack, &waiting, REF_NONE, 0u);
            order = compact_order(&way.r);
            continue;
        }

        if (slots == 0u) {
            if (waiting == 0) return found;
            waiting -= 2;
            node = stack[waiting];
            slots = stack[waiting + 1];
        }
        cur = slots != 0u ? compact_next(compact_at(s, node), order, &slots) : node;
    }
}

FN void trace_next(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Look) look) {
    compact_traverse(s, ray, mask, 0, look);
}

FN int trace_any(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask) {
    Look look;
    look_along(ray, &look);
    return compact_traverse(s, ray, mask, 1, &look);
}
#endif
