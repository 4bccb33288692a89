// SPDX-License-Identifier: BSD-3-Clause
// Rays side by side through the eight-wide tree (kernels/bvh/bvh8.h): those of neighbouring pixels, and what follows
// from them.  A node's eight boxes are tested once for all rays of a packet, by the intervals of their origins and
// slopes; a leaf's box and a triangle are tested against eight rays at once.  The intervals let no ray miss a box that
// it would meet alone (rounding is monotone), and triangles take the same steps in each lane.  A packet looks for
// the nearest hits (packets.h), or whether the way is open (packet_look.h). Included where LUX_ISA stands for the
// namespace of an instruction set, after kernels/all.h.
#ifndef LUX_PACKET_RAYS_H
#define LUX_PACKET_RAYS_H

constexpr uint32_t PACKET_GROUPS = 4;  // of eight rays each
constexpr uint32_t PACKET = 8 * PACKET_GROUPS;
constexpr uint32_t PACKET_NODES = 3;  // a ray: where a packet has to ask more, its rays are faster alone

// Rays side by side, a lane each.  Rays that go through the tree together are of one kind: their directions have the
// same signs and the same longest axis.  The others wait in their lanes.
struct PacketRays {
    uint32_t count = 0, open = 0;  // rays; those, a bit each, that look for something
    uint32_t kind = 0;             // of the open ones
    float tmin = 0.0f;
    // by ray: origin, direction, 1/direction, shear (WoopRay), how far it looks
    alignas(32) float org[3][PACKET], dir[3][PACKET], inv[3][PACKET], s[2][PACKET], t[PACKET];
    uint32_t kinds[PACKET];  // signs, a bit each, and the longest axis << 3
};

FN void packet_put(PacketRays& p, uint32_t i, const Ray& ray) {
    p.org[0][i] = ray.org.x, p.org[1][i] = ray.org.y, p.org[2][i] = ray.org.z;
    p.dir[0][i] = ray.dir.x, p.dir[1][i] = ray.dir.y, p.dir[2][i] = ray.dir.z;
    p.t[i] = ray.tmax;
}

FN Ray packet_ray(const PacketRays& p, uint32_t i) {
    return {F3(p.org[0][i], p.org[1][i], p.org[2][i]), p.tmin, F3(p.dir[0][i], p.dir[1][i], p.dir[2][i]), p.t[i]};
}

// Prepares the rays that have been put for the traversal, as woop_prepare() does for one.
FN void packet_prepare(PacketRays& p) {
    for (uint32_t i = 0; i < p.count; i++) {
        const float x = p.dir[0][i], y = p.dir[1][i], z = p.dir[2][i];
        const float ax = fabs_(x), ay = fabs_(y), az = fabs_(z);
        const bool long_x = ax > ay && ax > az, long_y = !(ax > ay) && ay > az;
        const float3 inv = F3(slab_inverse(x), slab_inverse(y), slab_inverse(z));
        const float along = long_x ? x : long_y ? y : z;
        p.inv[0][i] = inv.x, p.inv[1][i] = inv.y, p.inv[2][i] = inv.z;
        p.s[0][i] = (long_x ? y : long_y ? z : x) / along;
        p.s[1][i] = (long_x ? z : long_y ? x : y) / along;
        p.kinds[i] = (inv.x < 0.0f ? 1u : 0u) | (inv.y < 0.0f ? 2u : 0u) | (inv.z < 0.0f ? 4u : 0u) |
                     (long_x   ? 0u
                      : long_y ? 1u << 3
                               : 2u << 3);
    }
}

// Opens the first of the rays that wait, and those of its kind; returns what still waits.
FN uint32_t packet_open(PacketRays& p, uint32_t waiting) {
    uint32_t same = 0;
    p.kind = p.kinds[__builtin_ctz(waiting)];
    for (uint32_t i = 0; i < p.count; i++) same |= (p.kinds[i] == p.kind ? 1u : 0u) << i;
    p.open = same & waiting;
    return waiting & ~same;
}

// The nodes that the open rays may ask together.
FN uint32_t packet_patience(const PacketRays& p) { return PACKET_NODES * (4u + uint32_t(__builtin_popcount(p.open))); }

FN uint32_t packet_all(const PacketRays& p) { return p.count == 32 ? ~0u : (1u << p.count) - 1u; }

FN v8f min8(v8f a, v8f b) { return a < b ? a : b; }
FN v8f max8(v8f a, v8f b) { return a > b ? a : b; }

FN float least8(v8f v) {
    float x[8];
    store8_(v, x);
    for (int step = 4; step > 0; step /= 2)
        for (int i = 0; i < step; i++) x[i] = MIN_(x[i], x[i + step]);
    return x[0];
}

// Lanes 8 g ... 8 g + 7 of the rays in a set, all bits of each.
FN v8i packet_lanes(uint32_t rays, uint32_t g) {
    const v8i bit = {1, 2, 4, 8, 16, 32, 64, 128};
    return (bit & int(rays >> 8 * g & 255u)) != 0;
}

// Bounds of the open rays of a packet: intervals of origin and slope, an axis each.
struct PacketBounds {
    float near_org[3], far_org[3], inv0[3], inv1[3];
    float tmax;  // where the last of them ends
};

FN float packet_reach(const PacketRays& p) {
    v8f farthest = splat8_(0.0f);
    for (uint32_t g = 0; 8 * g < p.count; g++)
        farthest = max8(packet_lanes(p.open, g) ? load8_(p.t + 8 * g) : splat8_(0.0f), farthest);
    return -least8(-farthest);
}

FN PacketBounds packet_bounds(const PacketRays& p) {
    PacketBounds b;
    const uint32_t some = uint32_t(__builtin_ctz(p.open));
    for (int a = 0; a < 3; a++) {
        const v8f org = splat8_(p.org[a][some]), inv = splat8_(p.inv[a][some]);
        v8f org0 = org, org1 = org, inv0 = inv, inv1 = inv;
        for (uint32_t g = 0; 8 * g < p.count; g++) {
            const v8i in = packet_lanes(p.open, g);
            const v8f o = in ? load8_(p.org[a] + 8 * g) : org, i = in ? load8_(p.inv[a] + 8 * g) : inv;
            org0 = min8(o, org0);
            org1 = max8(o, org1);
            inv0 = min8(i, inv0);
            inv1 = max8(i, inv1);
        }
        const float lo = least8(org0), hi = -least8(-org1);
        const bool down = (p.kind >> a & 1u) != 0;
        b.near_org[a] = down ? lo : hi;
        b.far_org[a] = down ? hi : lo;
        b.inv0[a] = least8(inv0);
        b.inv1[a] = -least8(-inv1);
    }
    b.tmax = packet_reach(p);
    return b;
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

// The children that a ray of the packet may meet go on the stack, the nearest on top.
FN void packet_node(const PacketRays& p, const PacketBounds& b, const float* n, PacketStack& stack) {
    v8f tn = splat8_(p.tmin), tf = splat8_(b.tmax);
    for (int a = 0; a < 3; a++) {
        const uint32_t near = 16u * a + ((p.kind >> a & 1u) != 0 ? 8u : 0u);
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

// Returns which of these rays meet box k of `wide` boxes side by side, as each would alone (bvh8_node, bvh8_boxes).
FN uint32_t packet_box(const PacketRays& p, const float* boxes, uint32_t wide, uint32_t k, uint32_t rays) {
    uint32_t met = 0;
    for (uint32_t g = 0; 8 * g < p.count; g++) {
        if ((rays >> 8 * g & 255u) == 0) continue;
        v8f tn = splat8_(p.tmin), tf = load8_(p.t + 8 * g);
        for (int a = 0; a < 3; a++) {
            const uint32_t near = 2 * wide * a + k + ((p.kind >> a & 1u) != 0 ? wide : 0u);
            const v8f org = load8_(p.org[a] + 8 * g), inv = load8_(p.inv[a] + 8 * g);
            tn = max8((boxes[near] - org) * inv, tn);
            tf = min8((boxes[near ^ wide] - org) * inv, tf);
        }
        met |= lane_bits_(lanes8_(tn <= tf * SLAB_WIDEN)) << 8 * g;
    }
    return met & rays;
}

// Rays 8 g ... 8 g + 7 against triangle k of a block, step by step as bvh8_triangles(): which lie in it, and what the
// hits come from.
struct PacketInside {
    v8i in;
    v8f wb, wc, det, t;
    float3 normal{}, corner{};  // of this triangle's plane
    bool has_plane = false;     // are they calculated?
};
FN bool packet_inside(const PacketRays& p, uint32_t g, const float* b, PacketInside& met) {
    const uint32_t z = p.kind >> 3, x = z == 2u ? 0u : z + 1u, y = x == 2u ? 0u : x + 1u;
    const float *kx = b + 4 * x, *ky = b + 4 * y, *kz = b + 4 * z;
    const v8f ox = load8_(p.org[x] + 8 * g), oy = load8_(p.org[y] + 8 * g), oz = load8_(p.org[z] + 8 * g);
    const v8f sx = load8_(p.s[0] + 8 * g), sy = load8_(p.s[1] + 8 * g);
    const v8f az = kz[0] - oz, bz = kz[12] - oz, cz = kz[24] - oz;
    const v8f ax = (kx[0] - ox) - sx * az, ay = (ky[0] - oy) - sy * az;
    const v8f bx = (kx[12] - ox) - sx * bz, by = (ky[12] - oy) - sy * bz;
    const v8f cx = (kx[24] - ox) - sx * cz, cy = (ky[24] - oy) - sy * cz;
    const v8f wa = cx * by - cy * bx, wb = ax * cy - ay * cx, wc = bx * ay - by * ax;
    met.det = wa + wb + wc;
    met.in = ((wa >= 0.0f) & (wb >= 0.0f) & (wc >= 0.0f)) | ((wa <= 0.0f) & (wb <= 0.0f) & (wc <= 0.0f));
    met.in &= met.det != 0.0f;
    if (lanes8_(met.in) == 0) return false;

    if (!met.has_plane)
        met.normal = triangle_normal(bvh8_corner(b, 0), bvh8_corner(b + 12, 0), bvh8_corner(b + 24, 0), &met.corner);
    met.has_plane = true;
    const float3 n = met.normal, corner = met.corner;
    const auto at = [&](const float* v) { return load8_(v + 8 * g); };
    met.t = (n.x * (corner.x - at(p.org[0])) + n.y * (corner.y - at(p.org[1])) + n.z * (corner.z - at(p.org[2]))) /
            (n.x * at(p.dir[0]) + n.y * at(p.dir[1]) + n.z * at(p.dir[2]));
    met.wb = wb;
    met.wc = wc;
    return true;
}

// Has lane k of a block of triangles none, or one of no size?
FN bool packet_no_triangle(const float* b) { return b[0] == b[12] && b[4] == b[16] && b[8] == b[20]; }

// Calls leaf(block, rays) for each leaf that some of the open rays meet, the nearest first, until none is open.
// It returns those for which something has changed: that look less far, or no more.  False: more than `patience` nodes
// would have to be asked, for the rays lie too far apart; the open ones are not done.
template <class LEAF>
FN bool packet_walk(const SceneTables& s, PacketRays& p, uint32_t root, uint32_t patience, LEAF&& leaf) {
    PacketStack stack;
    PacketBounds b = packet_bounds(p);
    packet_node(p, b, s.nodes + uint64_t(root) * BVH8_NODE_FLOATS, stack);
    while (stack.size > 0) {
        const PacketPlace at = stack.place[--stack.size];
        if (at.t > b.tmax * SLAB_WIDEN) continue;
        if ((at.ref & REF_LEAF) == 0) {
            if (patience-- == 0) return false;
            packet_node(p, b, s.nodes + uint64_t(at.ref) * BVH8_NODE_FLOATS, stack);
            continue;
        }
        const uint32_t rays = packet_box(p, at.node, 8, at.child, p.open);
        if (rays == 0 || leaf(s.leaves + uint64_t(at.ref & REF_INDEX) * BVH8_LEAF_FLOATS, rays) == 0) continue;
        if (p.open == 0) return true;
        b.tmax = packet_reach(p);
    }
    return true;
}
#endif
