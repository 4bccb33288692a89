// SPDX-License-Identifier: BSD-3-Clause
// Traversal for GPUs: one scalar ray per work item, binary nodes that hold both children's boxes in 64 bytes
// (Aila and Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs"), small private stack.
// Node: 16 floats: child 0 min xyz, max xyz, child 1 min xyz, max xyz, two references (words), 2 spare.
// Both are read by four floats at a time: buffers start on 16-byte boundaries.
// Leaf block: 12 floats: v0 xyz, id, v1 xyz, 0, v2 xyz, 0; with ID_SHAPE in the id: word 0 = index of the shape.
#ifndef LUX_BVH2_H
#define LUX_BVH2_H

#define BVH2_NODE_FLOATS 16u
#define BVH2_LEAF_FLOATS 12u
#define BVH2_STACK 128  // the builder refuses trees that need more (bvh/build.cpp)

// Entry distance of a box, or a negative number if the ray misses it between tmin >= 0 and limit.
FN float bvh2_box_(float3 lo, float3 hi, PRIVATE const WoopRay* r, float tmin, float limit) {
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

// The nearest hit, or with any != 0 some hit (1 at once); hit->t = tmax and hit->prim = NO_HIT on entry.
FN int bvh2_traverse_(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask, int any, PRIVATE Hit* hit) {
    uint stack[BVH2_STACK];
    WoopRay r;
    uint cur = 0u, inst = NO_HIT, cls = mask;
    int size = 0, found = 0;
    woop_prepare(ray->org, ray->dir, &r);
    for (;;) {
        if ((cur & REF_LEAF) == 0u) {
            GLOBAL const float* n = s->nodes + (ulong64)cur * BVH2_NODE_FLOATS;
            float4 p = loadf4_(n), q = loadf4_(n + 4), w = loadf4_(n + 8), refs = loadf4_(n + 12);
            float t0 = bvh2_box_(F3(p.x, p.y, p.z), F3(p.w, q.x, q.y), &r, ray->tmin, hit->t);
            float t1 = bvh2_box_(F3(q.z, q.w, w.x), F3(w.y, w.z, w.w), &r, ray->tmin, hit->t);
            uint c0 = as_uint_(refs.x), c1 = as_uint_(refs.y);
            if (t0 >= 0.0f && t1 >= 0.0f) {
                stack[size++] = t0 <= t1 ? c1 : c0;
                cur = t0 <= t1 ? c0 : c1;
                continue;
            }
            if (t0 >= 0.0f || t1 >= 0.0f) {
                cur = t0 >= 0.0f ? c0 : c1;
                continue;
            }
        } else if ((cur & REF_INSTANCE) == 0u) {
            GLOBAL const float* b = s->leaves + (ulong64)(cur & REF_INDEX) * BVH2_LEAF_FLOATS;
            uint id;
            do {
                float4 v0 = loadf4_(b), v1 = loadf4_(b + 4), v2 = loadf4_(b + 8);
                float t, u = 0.0f, v = 0.0f;
                id = as_uint_(v0.w);
                if ((id & ID_SHAPE) == 0u) {
                    if (((cls >> (id >> 31)) & 1u) != 0u &&
                        woop_triangle(&r, F3(v0.x, v0.y, v0.z), F3(v1.x, v1.y, v1.z), F3(v2.x, v2.y, v2.z), &t, &u,
                                      &v) &&
                        t > ray->tmin && hit_offer(hit, t, id & ID_PRIM, u, v, inst))
                        found = 1;
                } else {
                    uint shape = as_uint_(v0.x);
                    GLOBAL const float* q = s->shapes + (ulong64)shape * SHAPE_FLOATS;
                    if (as_uint_(q[0]) == SHAPE_INSTANCE) {
                        stack[size++] = shape | REF_LEAF | REF_INSTANCE;
                    } else if (((cls >> (id >> 31)) & 1u) != 0u &&
                               shape_hit(q, s->polygon_uv, r.org, r.dir, ray->tmin, &t) &&
                               hit_offer(hit, t, id & ID_PRIM, 0.0f, 0.0f, inst)) {
                        found = 1;
                    }
                }
                b += BVH2_LEAF_FLOATS;
            } while ((id & ID_LAST) == 0u);
            if (any && found) return 1;
        } else if (cur == REF_NONE) {  // back from an instance
            woop_prepare(ray->org, ray->dir, &r);
            inst = NO_HIT;
            cls = mask;
        } else {
            GLOBAL const float* q = s->shapes + (ulong64)(cur & REF_INDEX) * SHAPE_FLOATS;
            uint forced = as_uint_(q[15]);
            if (forced == 0u || (mask & forced) != 0u) {
                woop_prepare_instance(q, ray->org, ray->dir, &r);
                inst = as_uint_(q[14]);
                cls = forced == 0u ? mask : RAY_ALL;
                stack[size++] = REF_NONE;
                cur = as_uint_(q[13]);
                continue;
            }
        }
        if (size == 0) return found;
        cur = stack[--size];
    }
}

FN void trace_closest(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask, PRIVATE Hit* hit) {
    hit->t = ray->tmax;
    hit->prim = NO_HIT;
    hit->inst = NO_HIT;
    hit->u = 0.0f;
    hit->v = 0.0f;
    bvh2_traverse_(s, ray, mask, 0, hit);
}

FN int trace_any(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask) {
    Hit hit;
    hit.t = ray->tmax;
    hit.prim = NO_HIT;
    hit.inst = NO_HIT;
    return bvh2_traverse_(s, ray, mask, 1, &hit);
}
#endif
