// SPDX-License-Identifier: BSD-3-Clause
// Traversal for CPUs (and PoCL): nodes of eight boxes tested at once, leaves of four triangles tested at once.
// One ray at a time; the wide words of the compat files become AVX.  Nearest child first, also for occlusion.
// Node: 64 floats: min x (8 lanes), max x, min y, max y, min z, max z, references (8 words), 8 spare.
// Leaf block: 40 floats: v0 x (4 lanes) y z, v1 x y z, v2 x y z, 4 ids; or, if its first id has ID_SHAPE: 0-3 indices
// of shapes, 8-31 their boxes: min x (4 lanes), max x, min y ..., 36-39 their ids.
#ifndef LUX_BVH8_H
#define LUX_BVH8_H

#define BVH8_NODE_FLOATS 64u
#define BVH8_REFS 48u  // in a node
#define BVH8_LEAF_FLOATS 40u
#define BVH8_IDS 36u    // in a block
#define BVH8_BOXES 8u   // in a block of shapes
#define BVH8_STACK 320  // the builder refuses trees that need more (bvh/build.cpp)

STRUCT(Bvh8Stack) {
    uint ref[BVH8_STACK];
    float t[BVH8_STACK];
    int size;
};

FN void bvh8_push(PRIVATE(Bvh8Stack) stack, int bottom, uint ref, float t) {  // sorted above bottom, nearest on top
    int i = stack->size++;

    while (i > bottom && stack->t[i - 1] < t) {
        stack->ref[i] = stack->ref[i - 1];
        stack->t[i] = stack->t[i - 1];
        i--;
    }

    stack->ref[i] = ref;
    stack->t[i] = t;
}

FN float3 bvh8_corner(GLOBAL const float* b, uint k) { return F3(b[k], b[4u + k], b[8u + k]); }

// triangle_distance() of four triangles, step by step.
FN v4f bvh8_distances(GLOBAL const float* b, PRIVATE(const WoopRay) r) {
    v4f ax = load4_(b), ay = load4_(b + 4u), az = load4_(b + 8u);
    v4f bx = load4_(b + 12u), by = load4_(b + 16u), bz = load4_(b + 20u);
    v4f cx = load4_(b + 24u), cy = load4_(b + 28u), cz = load4_(b + 32u);
    v4f ex = bx - ax, ey = by - ay, ez = bz - az;
    v4f sx = cx - ax, sy = cy - ay, sz = cz - az, ox = cx - bx, oy = cy - by, oz = cz - bz;
    v4i nearer = ox * ox + oy * oy + oz * oz < sx * sx + sy * sy + sz * sz;
    v4f nx, ny, nz, px, py, pz;
    sx = nearer ? ox : sx, sy = nearer ? oy : sy, sz = nearer ? oz : sz;
    px = (nearer ? bx : ax) - r->org.x, py = (nearer ? by : ay) - r->org.y, pz = (nearer ? bz : az) - r->org.z;
    nx = ey * sz - ez * sy, ny = ez * sx - ex * sz, nz = ex * sy - ey * sx;
    return (nx * px + ny * py + nz * pz) / (nx * r->dir.x + ny * r->dir.y + nz * r->dir.z);
}

// Four triangles; 1 if one of them became the nearest hit.
FN int bvh8_triangles(GLOBAL const float* b, PRIVATE(const WoopRay) r, uint mask, uint inst, PRIVATE(Look) look) {
    v4f az = load4_(b + 4u * r->kz) - r->oz, bz = load4_(b + 12u + 4u * r->kz) - r->oz;
    v4f cz = load4_(b + 24u + 4u * r->kz) - r->oz;
    v4f ax = (load4_(b + 4u * r->kx) - r->ox) - r->sx * az, ay = (load4_(b + 4u * r->ky) - r->oy) - r->sy * az;
    v4f bx = (load4_(b + 12u + 4u * r->kx) - r->ox) - r->sx * bz,
        by = (load4_(b + 12u + 4u * r->ky) - r->oy) - r->sy * bz;
    v4f cx = (load4_(b + 24u + 4u * r->kx) - r->ox) - r->sx * cz,
        cy = (load4_(b + 24u + 4u * r->ky) - r->oy) - r->sy * cz;
    v4f wa = cx * by - cy * bx, wb = ax * cy - ay * cx, wc = bx * ay - by * ax;
    v4f det = wa + wb + wc, t;
    v4i inside = ((wa >= 0.0f) & (wb >= 0.0f) & (wc >= 0.0f)) | ((wa <= 0.0f) & (wb <= 0.0f) & (wc <= 0.0f));
    LaneMask m = lanes4_(inside & (det != 0.0f));
    float ts[4], us[4], vs[4];
    int found = 0;
    if (m == 0u) return 0;
    t = bvh8_distances(b, r);
    m = lanes4_(inside & (det != 0.0f) & (t > look->from) & (t <= look->limit));
    if (m == 0u) return 0;
    store4_(t, ts);
    store4_(wb / det, us);
    store4_(wc / det, vs);

    while (m != 0u) {
        uint k = lane_first_(m);
        uint id = as_uint_(b[BVH8_IDS + k]);
        m = lane_drop_(m, k);
        if (((mask >> (id >> 31)) & 1u) != 0u && hit_offer(look, ts[k], id & ID_PRIM, us[k], vs[k], inst)) found = 1;
    }

    return found;
}

// Eight boxes: *cur becomes the nearest child that the ray hits, the others go on the stack.  Returns 0 if it hits
// none.
FN int bvh8_node(GLOBAL const float* n, PRIVATE(const WoopRay) r, float tmin, float tmax, PRIVATE(Bvh8Stack) stack,
                 PRIVATE(uint) cur, PRIVATE(float) cur_t) {
    uint nx = r->inv.x < 0.0f ? 8u : 0u, ny = r->inv.y < 0.0f ? 24u : 16u, nz = r->inv.z < 0.0f ? 40u : 32u;
    v8f tx = (load8_(n + nx) - r->org.x) * r->inv.x, fx = (load8_(n + (nx ^ 8u)) - r->org.x) * r->inv.x;
    v8f ty = (load8_(n + ny) - r->org.y) * r->inv.y, fy = (load8_(n + (ny ^ 8u)) - r->org.y) * r->inv.y;
    v8f tz = (load8_(n + nz) - r->org.z) * r->inv.z, fz = (load8_(n + (nz ^ 8u)) - r->org.z) * r->inv.z;
    v8f tn = tx > ty ? tx : ty, tf = fx < fy ? fx : fy, lo = splat8_(tmin), hi = splat8_(tmax);
    tn = tn > tz ? tn : tz;
    tn = tn > lo ? tn : lo;
    tf = tf < fz ? tf : fz;
    tf = (tf < hi ? tf : hi) * SLAB_WIDEN;
    LaneMask met = lanes8_(tn <= tf);
    if (met == 0u) return 0;

    float ts[8];
    store8_(tn, ts);
    uint k = lane_first_(met);
    int bottom = stack->size;
    *cur = as_uint_(n[BVH8_REFS + k]);
    *cur_t = ts[k];

    for (met = lane_drop_(met, k); met != 0u; met = lane_drop_(met, k)) {
        k = lane_first_(met);
        uint ref = as_uint_(n[BVH8_REFS + k]), waits = *cur;
        float t = ts[k], waits_t = *cur_t;
        int nearer = t < waits_t;
        *cur = nearer ? ref : waits;
        *cur_t = nearer ? t : waits_t;
        bvh8_push(stack, bottom, nearer ? waits : ref, nearer ? waits_t : t);
    }

    return 1;
}

// Returns which of four boxes the ray hits; *from gets the distances at which it enters them.
FN LaneMask bvh8_boxes(GLOBAL const float* b, PRIVATE(const WoopRay) r, float tmin, float tmax, PRIVATE(float) from) {
    uint nx = r->inv.x < 0.0f ? 4u : 0u, ny = r->inv.y < 0.0f ? 12u : 8u, nz = r->inv.z < 0.0f ? 20u : 16u;
    v4f tx = (load4_(b + nx) - r->org.x) * r->inv.x, fx = (load4_(b + (nx ^ 4u)) - r->org.x) * r->inv.x;
    v4f ty = (load4_(b + ny) - r->org.y) * r->inv.y, fy = (load4_(b + (ny ^ 4u)) - r->org.y) * r->inv.y;
    v4f tz = (load4_(b + nz) - r->org.z) * r->inv.z, fz = (load4_(b + (nz ^ 4u)) - r->org.z) * r->inv.z;
    v4f tn = tx > ty ? tx : ty, tf = fx < fy ? fx : fy, lo = splat4_(tmin), hi = splat4_(tmax);
    tn = tn > tz ? tn : tz;
    tn = tn > lo ? tn : lo;
    tf = tf < fz ? tf : fz;
    tf = (tf < hi ? tf : hi) * SLAB_WIDEN;
    store4_(tn, from);
    return lanes4_(tn <= tf);
}

// Tests a leaf block of shapes; instances go on the stack.  Returns 1 if a shape became the nearest hit.
FN int bvh8_shapes(TABLES(const SceneTables) s, GLOBAL const float* block, PRIVATE(const TreeRay) way,
                   PRIVATE(Bvh8Stack) stack, PRIVATE(Look) look) {
    float from[4];
    LaneMask met = bvh8_boxes(block + BVH8_BOXES, &way->r, look->from, look->limit, from);
    int found = 0;

    while (met != 0u) {
        uint k = lane_first_(met);
        uint id = as_uint_(block[BVH8_IDS + k]), number = as_uint_(block[k]);
        float t;
        met = lane_drop_(met, k);
        if ((number & REF_INSTANCE) != 0u) {
            bvh8_push(stack, stack->size, number | REF_LEAF, from[k]);
        } else if (((way->mask >> (id >> 31)) & 1u) != 0u &&
                   shape_hit(&s->shapes[number], s->polygon_uv, way->r.org, way->r.dir, look->from, &t) &&
                   hit_offer(look, t, id & ID_PRIM, 0.0f, 0.0f, way->inst)) {
            found = 1;
        }
    }

    return found;
}

FN int bvh8_leaf(TABLES(const SceneTables) s, uint ref, PRIVATE(const TreeRay) way, PRIVATE(Bvh8Stack) stack,
                 PRIVATE(Look) look) {
    GLOBAL const float* block = s->leaves + (ulong64)(ref & REF_INDEX) * BVH8_LEAF_FLOATS;
    int found = 0;

    for (;; block += BVH8_LEAF_FLOATS) {
        uint first = as_uint_(block[BVH8_IDS]);
        if ((first & ID_SHAPE) == 0u) {
            if (bvh8_triangles(block, &way->r, way->mask, way->inst, look)) found = 1;
        } else {
            if (bvh8_shapes(s, block, way, stack, look)) found = 1;
        }
        if ((first & ID_LAST) != 0u) return found;
    }
}

// Traverses from the root of the tree of *in.  Finds the first hit that look accepts; if any != 0, any hit (returns 1
// at once).
FN int bvh8_walk(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(TreeRay) way, uint root,
                 int any, PRIVATE(Look) look) {
    Bvh8Stack stack;
    uint cur = root;
    float cur_t = look->from;
    int found = 0;
    stack.size = 0;

    for (;;) {
        if ((cur & REF_LEAF) == 0u) {
            GLOBAL const float* node = s->nodes + (ulong64)cur * BVH8_NODE_FLOATS;
            if (bvh8_node(node, &way->r, look->from, look->limit, &stack, &cur, &cur_t)) continue;
        } else if ((cur & REF_INSTANCE) == 0u) {
            if (bvh8_leaf(s, cur, way, &stack, look)) found = 1;
            if (any && found) return 1;
        } else if (cur == REF_NONE) {  // back from an instance
            enter_scene(ray, mask, way);
        } else if (enter_instance(s, cur & REF_INDEX, ray, mask, way, &cur)) {
            bvh8_push(&stack, stack.size, REF_NONE, look->from);
            continue;
        }

        do {
            if (stack.size == 0) return found;
            stack.size--;
            cur = stack.ref[stack.size];
            cur_t = stack.t[stack.size];
        } while (cur_t > look->limit * SLAB_WIDEN);
    }
}

// The same in the scene.
FN int bvh8_traverse(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, int any, PRIVATE(Look) look) {
    TreeRay way;
    uint root = mask == RAY_TRANSPARENT ? ROOT_OF_PANES : ROOT_OF_SCENE;
    enter_scene(ray, mask, &way);
    return bvh8_walk(s, ray, mask, &way, root, any, look);
}

FN void trace_next(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Look) look) {
    bvh8_traverse(s, ray, mask, 0, look);
}

FN int trace_any(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask) {
    Look look;
    look_along(ray, &look);
    return bvh8_traverse(s, ray, mask, 1, &look);
}
#endif
