// SPDX-License-Identifier: BSD-3-Clause
// Rays side by side through the eight-wide tree (kernels/bvh8.h): the eye's rays of neighbouring pixels and the shadow
// rays of what these meet.  A node's eight boxes are tested once for all rays of a packet, by the intervals of their
// origins and slopes; a triangle is tested against eight rays at once.  The intervals let no ray miss a box that it
// would meet alone (rounding is monotone), triangles take the same steps in each lane, and ties are decided by
// hit_offer(): the hits have the bits of trace_closest() and trace_any().
// Included where LUX_ISA stands for the namespace of an instruction set, after kernels/all.h.
#ifndef LUX_PACKETS_H
#define LUX_PACKETS_H

constexpr uint32_t PACKET_GROUPS = 4;  // of eight rays each
constexpr uint32_t PACKET = 8 * PACKET_GROUPS;

// Rays whose directions have the same signs and the same longest axis, and that begin at the same distance.
struct Packet {
    uint32_t count = 0, open = 0;  // rays; those, a bit each, that still look for a hit
    uint32_t signs = 0, kx = 0, ky = 0, kz = 0;
    Ray ray[PACKET];
    Hit hit[PACKET];
    uint32_t slot[PACKET];
    // by ray: origin, 1/direction, origin in the order of the shear, shear (WoopRay), how far it looks
    alignas(32) float org[3][PACKET], inv[3][PACKET], o[3][PACKET], s[3][PACKET], t[PACKET];
};

FN uint32_t packet_signs(const WoopRay& r) {
    return (r.inv.x < 0.0f ? 1u : 0u) | (r.inv.y < 0.0f ? 2u : 0u) | (r.inv.z < 0.0f ? 4u : 0u) | r.kz << 3;
}

// 0: it does not go with the others, or there is no room.
FN int packet_add(Packet& p, const Ray& ray, uint32_t slot) {
    WoopRay r;
    woop_prepare(ray.org, ray.dir, &r);
    const uint32_t signs = packet_signs(r);
    if (p.count == PACKET || (p.count > 0 && (signs != p.signs || ray.tmin != p.ray[0].tmin))) return 0;
    p.signs = signs;
    p.kx = r.kx;
    p.ky = r.ky;
    p.kz = r.kz;

    const uint32_t i = p.count++;
    p.ray[i] = ray;
    p.slot[i] = slot;
    p.hit[i] = Hit{ray.tmax, NO_HIT, 0.0f, 0.0f, NO_HIT};
    const float3 vectors[4] = {r.org, r.inv, F3(r.ox, r.oy, r.oz), F3(r.sx, r.sy, r.sz)};
    float(*const to[4])[PACKET] = {p.org, p.inv, p.o, p.s};
    for (int k = 0; k < 4; k++) {
        to[k][0][i] = vectors[k].x;
        to[k][1][i] = vectors[k].y;
        to[k][2][i] = vectors[k].z;
    }
    p.t[i] = ray.tmax;
    return 1;
}

// What all rays of a packet have in common: intervals of origin and slope, an axis each.
struct PacketBounds {
    float near_org[3], far_org[3], inv0[3], inv1[3];
    float tmin, tmax;  // where they begin and end; tmax shrinks as hits are found
};

FN PacketBounds packet_bounds(const Packet& p) {
    PacketBounds b;
    b.tmin = p.ray[0].tmin;
    for (int a = 0; a < 3; a++) {
        float lo = p.org[a][0];
        float hi = lo;
        b.inv0[a] = b.inv1[a] = p.inv[a][0];
        for (uint32_t i = 1; i < p.count; i++) {
            lo = MIN_(lo, p.org[a][i]);
            hi = MAX_(hi, p.org[a][i]);
            b.inv0[a] = MIN_(b.inv0[a], p.inv[a][i]);
            b.inv1[a] = MAX_(b.inv1[a], p.inv[a][i]);
        }
        const bool down = (p.signs >> a & 1u) != 0;
        b.near_org[a] = down ? lo : hi;
        b.far_org[a] = down ? hi : lo;
    }
    return b;
}

FN float packet_reach(const Packet& p) {
    float reach = 0.0f;
    for (uint32_t i = 0; i < p.count; i++)
        if ((p.open >> i & 1u) != 0) reach = MAX_(reach, p.t[i]);
    return reach;
}

struct PacketPlace {
    uint32_t ref, child;  // what waits, and which child of the node it is
    float t;              // no ray meets it before
    const float* node;
};
struct PacketStack {
    PacketPlace place[BVH8_STACK];
    int size = 0;
};

FN v8f min8(v8f a, v8f b) { return a < b ? a : b; }
FN v8f max8(v8f a, v8f b) { return a > b ? a : b; }

// The children that a ray of the packet may meet go on the stack, the nearest on top.
FN void packet_node(const Packet& p, const PacketBounds& b, const float* n, PacketStack& stack) {
    v8f tn = splat8_(b.tmin), tf = splat8_(b.tmax);
    for (int a = 0; a < 3; a++) {
        const uint32_t near = 16u * a + ((p.signs >> a & 1u) != 0 ? 8u : 0u);
        const v8f to_near = load8_(n + near) - b.near_org[a], to_far = load8_(n + (near ^ 8u)) - b.far_org[a];
        tn = max8(min8(to_near * b.inv0[a], to_near * b.inv1[a]), tn);
        tf = min8(max8(to_far * b.inv0[a], to_far * b.inv1[a]), tf);
    }

    LaneMask met = lanes8_(tn <= tf * SLAB_WIDEN);
    float ts[8];
    store8_(tn, ts);
    const int bottom = stack.size;
    while (met != 0) {
        const uint32_t k = lane_first_(met);
        met = lane_drop_(met, k);
        int i = stack.size++;
        for (; i > bottom && stack.place[i - 1].t < ts[k]; i--) stack.place[i] = stack.place[i - 1];
        stack.place[i] = {as_uint_(n[BVH8_REFS + k]), k, ts[k], n};
    }
}

// Which of these rays meet box k of `wide` boxes side by side, as each would alone (bvh8_node, bvh8_boxes).
FN uint32_t packet_box(const Packet& p, const float* boxes, uint32_t wide, uint32_t k, uint32_t rays, float tmin) {
    uint32_t met = 0;
    for (uint32_t g = 0; 8 * g < p.count; g++) {
        if ((rays >> 8 * g & 255u) == 0) continue;
        v8f tn = splat8_(tmin), tf = load8_(p.t + 8 * g);
        for (int a = 0; a < 3; a++) {
            const uint32_t near = 2 * wide * a + k + ((p.signs >> a & 1u) != 0 ? wide : 0u);
            const v8f org = load8_(p.org[a] + 8 * g), inv = load8_(p.inv[a] + 8 * g);
            tn = max8((boxes[near] - org) * inv, tn);
            tf = min8((boxes[near ^ wide] - org) * inv, tf);
        }
        LaneMask lanes = lanes8_(tn <= tf * SLAB_WIDEN);
        for (; lanes != 0; lanes = lane_drop_(lanes, lane_first_(lanes))) met |= 1u << (8 * g + lane_first_(lanes));
    }
    return met & rays;
}

// Rays 8 g ... 8 g + 7 against triangle k of a block, step by step as bvh8_triangles().  The rays that came nearer.
FN uint32_t packet_triangle(Packet& p, uint32_t g, uint32_t rays, const float* b, float tmin, uint32_t id) {
    const float *kx = b + 4 * p.kx, *ky = b + 4 * p.ky, *kz = b + 4 * p.kz;
    const v8f ox = load8_(p.o[0] + 8 * g), oy = load8_(p.o[1] + 8 * g), oz = load8_(p.o[2] + 8 * g);
    const v8f sx = load8_(p.s[0] + 8 * g), sy = load8_(p.s[1] + 8 * g), best = load8_(p.t + 8 * g);
    const v8f az = kz[0] - oz, bz = kz[12] - oz, cz = kz[24] - oz;
    const v8f ax = (kx[0] - ox) - sx * az, ay = (ky[0] - oy) - sy * az;
    const v8f bx = (kx[12] - ox) - sx * bz, by = (ky[12] - oy) - sy * bz;
    const v8f cx = (kx[24] - ox) - sx * cz, cy = (ky[24] - oy) - sy * cz;
    const v8f wa = cx * by - cy * bx, wb = ax * cy - ay * cx, wc = bx * ay - by * ax;
    const v8f det = wa + wb + wc;
    v8i in = ((wa >= 0.0f) & (wb >= 0.0f) & (wc >= 0.0f)) | ((wa <= 0.0f) & (wb <= 0.0f) & (wc <= 0.0f));
    in &= det != 0.0f;
    if (lanes8_(in) == 0) return 0;

    const v8f t = (wa * az + wb * bz + wc * cz) * load8_(p.s[2] + 8 * g) / det;
    LaneMask lanes = lanes8_(in & (t > tmin) & (t <= best));
    if (lanes == 0) return 0;
    float ts[8], us[8], vs[8];
    store8_(t, ts);
    store8_(wb / det, us);
    store8_(wc / det, vs);
    uint32_t found = 0;
    for (; lanes != 0; lanes = lane_drop_(lanes, lane_first_(lanes))) {
        const uint32_t lane = lane_first_(lanes), i = 8 * g + lane;
        if ((rays >> i & 1u) != 0 && hit_offer(&p.hit[i], ts[lane], id & ID_PRIM, us[lane], vs[lane], NO_HIT))
            found |= 1u << i;
    }
    return found;
}

// Ray i of a packet against a shape.  1 if it came nearer.
FN int packet_shape(const SceneTables& s, Packet& p, uint32_t i, uint32_t number, uint32_t id, uint32_t mask, int any) {
    const float* shape = shape_record(&s, number);
    float t;
    if (as_uint_(shape[SHAPE_KIND]) != SHAPE_INSTANCE)
        return (mask >> (id >> 31) & 1u) != 0 &&
               shape_hit(shape, s.polygon_uv, p.ray[i].org, p.ray[i].dir, p.ray[i].tmin, &t) &&
               hit_offer(&p.hit[i], t, id & ID_PRIM, 0.0f, 0.0f, NO_HIT);
    TreeRay in;
    uint32_t root;
    return enter_instance(shape, &p.ray[i], mask, &in, &root) &&
           bvh8_walk(&s, &p.ray[i], mask, &in, root, any, &p.hit[i]);
}

// The rays against a block of shapes.  Those that came nearer.
FN uint32_t packet_shapes(const SceneTables& s, Packet& p, const float* block, uint32_t rays, float tmin, uint32_t mask,
                          int any) {
    uint32_t found = 0;
    for (uint32_t k = 0; k < 4; k++) {
        uint32_t left = packet_box(p, block + BVH8_BOXES, 4, k, rays, tmin);
        for (; left != 0; left &= left - 1) {
            const uint32_t i = uint32_t(__builtin_ctz(left));
            if (!packet_shape(s, p, i, as_uint_(block[k]), as_uint_(block[BVH8_IDS + k]), mask, any)) continue;
            p.t[i] = p.hit[i].t;
            found |= 1u << i;
        }
    }
    return found;
}

// The rays against all blocks of a leaf.  Those that came nearer.
FN uint32_t packet_leaf(const SceneTables& s, Packet& p, uint32_t ref, uint32_t rays, float tmin, uint32_t mask,
                        int any) {
    const float* block = s.leaves + uint64_t(ref & REF_INDEX) * BVH8_LEAF_FLOATS;
    uint32_t found = 0;
    for (;; block += BVH8_LEAF_FLOATS) {
        const uint32_t first = as_uint_(block[BVH8_IDS]);
        for (uint32_t k = 0; k < 4 && (first & ID_SHAPE) == 0; k++) {
            const float* b = block + k;
            const uint32_t id = as_uint_(b[BVH8_IDS]);
            if ((mask >> (id >> 31) & 1u) == 0) continue;
            if (b[0] == b[12] && b[4] == b[16] && b[8] == b[20]) continue;  // an empty lane, or a triangle of no size
            for (uint32_t g = 0; 8 * g < p.count; g++) {
                if ((rays >> 8 * g & 255u) == 0) continue;
                const uint32_t nearer = packet_triangle(p, g, rays, b, tmin, id);
                for (uint32_t left = nearer; left != 0; left &= left - 1)
                    p.t[__builtin_ctz(left)] = p.hit[__builtin_ctz(left)].t;
                found |= nearer;
            }
        }
        if ((first & ID_SHAPE) != 0) found |= packet_shapes(s, p, block, rays, tmin, mask, any);
        if ((first & ID_LAST) != 0) return found;
    }
}

// The nearest hit of each ray, or with any some hit.
FN void packet_trace(const SceneTables& s, Packet& p, uint32_t mask, int any) {
    PacketStack stack;
    p.open = p.count == 32 ? ~0u : (1u << p.count) - 1u;
    PacketBounds b = packet_bounds(p);
    b.tmax = packet_reach(p);
    packet_node(p, b, s.nodes, stack);
    while (stack.size > 0) {
        const PacketPlace at = stack.place[--stack.size];
        if (at.t > b.tmax * SLAB_WIDEN) continue;
        if ((at.ref & REF_LEAF) == 0) {
            packet_node(p, b, s.nodes + uint64_t(at.ref) * BVH8_NODE_FLOATS, stack);
            continue;
        }
        const uint32_t rays = packet_box(p, at.node, 8, at.child, p.open, b.tmin);
        const uint32_t found = rays != 0 ? packet_leaf(s, p, at.ref, rays, b.tmin, mask, any) : 0;
        if (found == 0) continue;
        if (any) p.open &= ~found;
        if (p.open == 0) return;
        b.tmax = packet_reach(p);
    }
}
#endif
