// SPDX-License-Identifier: BSD-3-Clause
// Traversal for CPUs (and PoCL): nodes of eight boxes tested at once, leaves of four triangles tested at once.
// One ray at a time; the wide words of the compat files become AVX.  Nearest child first, also for occlusion.
// Node: 64 floats: min x (8 lanes), max x, min y, max y, min z, max z, references (8 words), 8 spare.
// Leaf block: 40 floats: v0 x (4 lanes) y z, v1 x y z, v2 x y z, 4 ids; or, if its first id has ID_SHAPE: 0-3 indices
// of shapes, 4 their count, 36-39 their ids.
#ifndef LUX_BVH8_H
#define LUX_BVH8_H

#define BVH8_NODE_FLOATS 64u
#define BVH8_LEAF_FLOATS 40u
#define BVH8_STACK 320  // the builder refuses trees that need more (bvh/build.cpp)

typedef struct {
    uint ref[BVH8_STACK];
    float t[BVH8_STACK];
    int size;
} Bvh8Stack;

FN void bvh8_push_(PRIVATE Bvh8Stack* stack, int bottom, uint ref, float t) {  // sorted above bottom, nearest on top
    int i = stack->size++;
    while (i > bottom && stack->t[i - 1] < t) {
        stack->ref[i] = stack->ref[i - 1];
        stack->t[i] = stack->t[i - 1];
        i--;
    }
    stack->ref[i] = ref;
    stack->t[i] = t;
}

// Four triangles; 1 if one of them became the nearest hit.
FN int bvh8_triangles_(GLOBAL const float* b, PRIVATE const WoopRay* r, float tmin, uint mask, uint inst,
                       PRIVATE Hit* hit) {
    v4f az = load4_(b + 4u * r->kz) - r->oz, bz = load4_(b + 12u + 4u * r->kz) - r->oz;
    v4f cz = load4_(b + 24u + 4u * r->kz) - r->oz;
    v4f ax = (load4_(b + 4u * r->kx) - r->ox) - r->sx * az, ay = (load4_(b + 4u * r->ky) - r->oy) - r->sy * az;
    v4f bx = (load4_(b + 12u + 4u * r->kx) - r->ox) - r->sx * bz,
        by = (load4_(b + 12u + 4u * r->ky) - r->oy) - r->sy * bz;
    v4f cx = (load4_(b + 24u + 4u * r->kx) - r->ox) - r->sx * cz,
        cy = (load4_(b + 24u + 4u * r->ky) - r->oy) - r->sy * cz;
    v4f wa = cx * by - cy * bx, wb = ax * cy - ay * cx, wc = bx * ay - by * ax;
    v4f det = wa + wb + wc, t;
    v4i in = ((wa >= 0.0f) & (wb >= 0.0f) & (wc >= 0.0f)) | ((wa <= 0.0f) & (wb <= 0.0f) & (wc <= 0.0f));
    LaneMask m = lanes4_(in & (det != 0.0f));
    float ts[4], us[4], vs[4];
    int found = 0;
    if (m == 0u) return 0;
    t = (wa * az + wb * bz + wc * cz) * r->sz / det;
    m = lanes4_(in & (det != 0.0f) & (t > tmin) & (t <= hit->t));
    if (m == 0u) return 0;
    store4_(t, ts);
    store4_(wb / det, us);
    store4_(wc / det, vs);
    while (m != 0u) {
        uint k = lane_first_(m), id = as_uint_(b[36u + k]);
        m = lane_drop_(m, k);
        if (((mask >> (id >> 31)) & 1u) != 0u && hit_offer(hit, ts[k], id & ID_PRIM, us[k], vs[k], inst)) found = 1;
    }
    return found;
}

// The nearest hit, or with any != 0 some hit (1 at once); hit->t = tmax and hit->prim = NO_HIT on entry.
FN int bvh8_traverse_(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask, int any, PRIVATE Hit* hit) {
    Bvh8Stack stack;
    WoopRay r;
    uint cur = 0u, inst = NO_HIT, cls = mask;
    float cur_t = ray->tmin;
    int found = 0;
    stack.size = 0;
    woop_prepare(ray->org, ray->dir, &r);
    for (;;) {
        if ((cur & REF_LEAF) == 0u) {
            GLOBAL const float* n = s->nodes + (ulong64)cur * BVH8_NODE_FLOATS;
            uint nx = r.inv.x < 0.0f ? 8u : 0u, ny = r.inv.y < 0.0f ? 24u : 16u, nz = r.inv.z < 0.0f ? 40u : 32u;
            v8f tx = (load8_(n + nx) - r.org.x) * r.inv.x, fx = (load8_(n + (nx ^ 8u)) - r.org.x) * r.inv.x;
            v8f ty = (load8_(n + ny) - r.org.y) * r.inv.y, fy = (load8_(n + (ny ^ 8u)) - r.org.y) * r.inv.y;
            v8f tz = (load8_(n + nz) - r.org.z) * r.inv.z, fz = (load8_(n + (nz ^ 8u)) - r.org.z) * r.inv.z;
            v8f tn = tx > ty ? tx : ty, tf = fx < fy ? fx : fy, lo = splat8_(ray->tmin), hi = splat8_(hit->t);
            LaneMask m;
            tn = tn > tz ? tn : tz;
            tn = tn > lo ? tn : lo;
            tf = tf < fz ? tf : fz;
            tf = (tf < hi ? tf : hi) * SLAB_WIDEN;
            m = lanes8_(tn <= tf);
            if (m != 0u) {
                uint k = lane_first_(m);
                int bottom = stack.size;
                float ts[8];
                store8_(tn, ts);
                m = lane_drop_(m, k);
                cur = as_uint_(n[48u + k]);
                cur_t = ts[k];
                while (m != 0u) {  // go on with the nearest, keep the others in order
                    uint ref;
                    k = lane_first_(m);
                    m = lane_drop_(m, k);
                    ref = as_uint_(n[48u + k]);
                    if (ts[k] < cur_t) {
                        bvh8_push_(&stack, bottom, cur, cur_t);
                        cur = ref;
                        cur_t = ts[k];
                    } else {
                        bvh8_push_(&stack, bottom, ref, ts[k]);
                    }
                }
                continue;
            }
        } else if ((cur & REF_INSTANCE) == 0u) {
            GLOBAL const float* b = s->leaves + (ulong64)(cur & REF_INDEX) * BVH8_LEAF_FLOATS;
            uint first;
            do {
                first = as_uint_(b[36]);
                if ((first & ID_SHAPE) == 0u) {
                    if (bvh8_triangles_(b, &r, ray->tmin, cls, inst, hit)) found = 1;
                } else {
                    uint count = as_uint_(b[4]);
                    for (uint k = 0u; k < count; k++) {
                        uint id = as_uint_(b[36u + k]), shape = as_uint_(b[k]);
                        GLOBAL const float* q = s->shapes + (ulong64)shape * SHAPE_FLOATS;
                        float t;
                        if (as_uint_(q[0]) == SHAPE_INSTANCE) {
                            bvh8_push_(&stack, stack.size, shape | REF_LEAF | REF_INSTANCE, cur_t);
                        } else if (((cls >> (id >> 31)) & 1u) != 0u &&
                                   shape_hit(q, s->polygon_uv, r.org, r.dir, ray->tmin, &t) &&
                                   hit_offer(hit, t, id & ID_PRIM, 0.0f, 0.0f, inst)) {
                            found = 1;
                        }
                    }
                }
                b += BVH8_LEAF_FLOATS;
            } while ((first & ID_LAST) == 0u);
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
                bvh8_push_(&stack, stack.size, REF_NONE, ray->tmin);
                cur = as_uint_(q[13]);
                continue;
            }
        }
        do {
            if (stack.size == 0) return found;
            stack.size--;
            cur = stack.ref[stack.size];
            cur_t = stack.t[stack.size];
        } while (cur_t > hit->t * SLAB_WIDEN);
    }
}

FN void trace_closest(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask, PRIVATE Hit* hit) {
    hit->t = ray->tmax;
    hit->prim = NO_HIT;
    hit->inst = NO_HIT;
    hit->u = 0.0f;
    hit->v = 0.0f;
    bvh8_traverse_(s, ray, mask, 0, hit);
}

FN int trace_any(PRIVATE const SceneTables* s, PRIVATE const Ray* ray, uint mask) {
    Hit hit;
    hit.t = ray->tmax;
    hit.prim = NO_HIT;
    hit.inst = NO_HIT;
    return bvh8_traverse_(s, ray, mask, 1, &hit);
}
#endif
