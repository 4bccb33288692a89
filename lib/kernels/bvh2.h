// SPDX-License-Identifier: BSD-3-Clause
// Traversal for GPUs: one scalar ray per work item, binary nodes that hold both children's boxes in 64 bytes
// (Aila and Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs"), small private stack.
// Node: 16 floats: child 0 min xyz, max xyz, child 1 min xyz, max xyz, two references (words), 2 spare but for
// BVH2_PANES.
// Both are read by four floats at a time: buffers start on 16-byte boundaries.
// Leaf block: 12 floats: v0 xyz, id, v1 xyz, 0, v2 xyz, 0; with ID_SHAPE in the id: word 0 = index of the shape.
#ifndef LUX_BVH2_H
#define LUX_BVH2_H

#define BVH2_NODE_FLOATS 16u
#define BVH2_PANES 14u  // in node 0: the root of the tree of what lets shadow rays pass
#define BVH2_LEAF_FLOATS 12u
#define BVH2_STACK 128  // the builder refuses trees that need more (bvh/build.cpp)

// Entry distance of a box, or a negative number if the ray misses it between tmin >= 0 and limit.
FN float bvh2_box(float3 lo, float3 hi, PRIVATE(const WoopRay) r, float tmin, float limit) {
    float x0 = (lo.x - r->org.x) * r->inv.x, x1 = (hi.x - r->org.x) * r->inv.x;
    float y0 = (lo.y - r->org.y) * r->inv.y, y1 = (hi.y - r->org.y) * r->inv.y;
    float z0 = (lo.z - r->org.z) * r->inv.z, z1 = (hi.z - r->org.z) * r->inv.z;
    float tn = r->inv.x < 0.0f ? x1 : x0, tf = r->inv.x < 0.0f ? x0 : x1;
    float ny = r->inv.y < 0.0f ? y1 : y0, fy = r->inv.y < 0.0f ? y0 : y1;
    float nz = r->inv.z < 0.0f ? z1 : z0, fz = r->inv.z < 0.0f ? z0 : z1;
    tn = tn > ny ? tn : ny;
    tn = tn > nz ? tn : nz;
    tn = tn > tmin ? tn : tmin;
    tf = tf < fy ? tf : fy;
    tf = tf < fz ? tf : fz;
    tf = (tf < limit ? tf : limit) * SLAB_WIDEN;
    return tn <= tf ? tn : -1.0f;
}

// Two boxes: *cur becomes the nearer child that the ray meets, the other one waits on the stack, which has *waiting
// references (not in one struct with it: an array lies in memory, and the count should not).  0: it meets none.
FN int bvh2_node(GLOBAL const float* n, PRIVATE(const WoopRay) r, float tmin, float tmax, PRIVATE(uint) stack,
                 PRIVATE(int) waiting, PRIVATE(uint) cur) {
    float4 a = loadf4_(n), b = loadf4_(n + 4), c = loadf4_(n + 8), refs = loadf4_(n + 12);
    float t0 = bvh2_box(F3(a.x, a.y, a.z), F3(a.w, b.x, b.y), r, tmin, tmax);
    float t1 = bvh2_box(F3(b.z, b.w, c.x), F3(c.y, c.z, c.w), r, tmin, tmax);
    uint ref0 = as_uint_(refs.x), ref1 = as_uint_(refs.y);

    if (t0 >= 0.0f && t1 >= 0.0f) {
        stack[(*waiting)++] = t0 <= t1 ? ref1 : ref0;
        *cur = t0 <= t1 ? ref0 : ref1;
        return 1;
    }

    if (t0 >= 0.0f || t1 >= 0.0f) {
        *cur = t0 >= 0.0f ? ref0 : ref1;
        return 1;
    }

    return 0;
}

// A shape of a leaf; an instance waits on the stack.  1 if it became the nearest hit.
FN int bvh2_shape(SHARED(const SceneTables) s, uint number, uint id, PRIVATE(const TreeRay) way, float tmin,
                  PRIVATE(uint) stack, PRIVATE(int) waiting, PRIVATE(Hit) hit) {
    GLOBAL const float* shape = shape_record(s, number);
    float t;
    if (HAS(INSTANCES) && as_uint_(shape[SHAPE_KIND]) == SHAPE_INSTANCE) {
        stack[(*waiting)++] = number | REF_LEAF | REF_INSTANCE;
        return 0;
    }

    return ((way->mask >> (id >> 31)) & 1u) != 0u &&
           shape_hit(shape, s->polygon_uv, way->r.org, way->r.dir, tmin, &t) &&
           hit_offer(hit, t, id & ID_PRIM, 0.0f, 0.0f, way->inst);
}

// A triangle, likewise.
FN int bvh2_triangle(float4 v0, float4 v1, float4 v2, uint id, PRIVATE(const TreeRay) way, float tmin,
                     PRIVATE(Hit) hit) {
    float t, u, v;
    return ((way->mask >> (id >> 31)) & 1u) != 0u &&
           woop_triangle(&way->r, F3(v0.x, v0.y, v0.z), F3(v1.x, v1.y, v1.z), F3(v2.x, v2.y, v2.z), &t, &u, &v) &&
           t > tmin && hit_offer(hit, t, id & ID_PRIM, u, v, way->inst);
}

FN int bvh2_leaf(SHARED(const SceneTables) s, uint ref, PRIVATE(const TreeRay) way, float tmin, PRIVATE(uint) stack,
                 PRIVATE(int) waiting, PRIVATE(Hit) hit) {
    GLOBAL const float* block = s->leaves + (ulong64)(ref & REF_INDEX) * BVH2_LEAF_FLOATS;
    int found = 0;

    for (;; block += BVH2_LEAF_FLOATS) {
        float4 v0 = loadf4_(block), v1 = loadf4_(block + 4), v2 = loadf4_(block + 8);
        uint id = as_uint_(v0.w);
        if ((id & ID_SHAPE) == 0u) {
            if (bvh2_triangle(v0, v1, v2, id, way, tmin, hit)) found = 1;
        } else {
            if (bvh2_shape(s, as_uint_(v0.x), id, way, tmin, stack, waiting, hit)) found = 1;
        }
        if ((id & ID_LAST) != 0u) return found;
    }
}

// The nearest hit, or with any != 0 some hit (1 at once); hit->t = tmax and hit->prim = NO_HIT on entry.
FN int bvh2_traverse(SHARED(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, int any, PRIVATE(Hit) hit) {
    uint stack[BVH2_STACK];
    TreeRay way;
    uint cur = mask == RAY_TRANSPARENT ? as_uint_(s->nodes[BVH2_PANES]) : 0u;
    int found = 0, waiting = 0;
    enter_scene(ray, mask, &way);

    for (;;) {
        if ((cur & REF_LEAF) == 0u) {
            GLOBAL const float* node = s->nodes + (ulong64)cur * BVH2_NODE_FLOATS;
            if (bvh2_node(node, &way.r, ray->tmin, hit->t, stack, &waiting, &cur)) continue;
        } else if (!HAS(INSTANCES) || (cur & REF_INSTANCE) == 0u) {
            if (bvh2_leaf(s, cur, &way, ray->tmin, stack, &waiting, hit)) found = 1;
            if (any && found) return 1;
        } else if (cur == REF_NONE) {  // back from an instance
            enter_scene(ray, mask, &way);
        } else if (enter_instance(shape_record(s, cur & REF_INDEX), ray, mask, &way, &cur)) {
            stack[waiting++] = REF_NONE;
            continue;
        }

        if (waiting == 0) return found;
        cur = stack[--waiting];
    }
}

FN void trace_closest(SHARED(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Hit) hit) {
    hit->t = ray->tmax;
    hit->prim = NO_HIT;
    hit->inst = NO_HIT;
    hit->u = 0.0f;
    hit->v = 0.0f;
    bvh2_traverse(s, ray, mask, 0, hit);
}

FN int trace_any(SHARED(const SceneTables) s, PRIVATE(const Ray) ray, uint mask) {
    Hit hit;
    hit.t = ray->tmax;
    hit.prim = NO_HIT;
    hit.inst = NO_HIT;
    return bvh2_traverse(s, ray, mask, 1, &hit);
}
#endif
