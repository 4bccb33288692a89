// SPDX-License-Identifier: BSD-3-Clause
// The first hits of rays side by side (packet_rays.h), with the bits of trace_next().
#ifndef LUX_PACKETS_H
#define LUX_PACKETS_H

struct Packet : PacketRays {
    Look look[PACKET];
    float length[PACKET];  // of the rays
};

// Tests rays 8 g ... 8 g + 7 against triangle k of a block.  Returns the mask of `rays` that now hit nearer.
FN uint32_t packet_triangle(Packet& p, uint32_t g, uint32_t rays, const float* b, uint32_t id, PacketInside& met) {
    if (!packet_inside(p, g, b, met)) return 0;
    LaneMask lanes = lanes8_(met.in & (met.t > p.tmin) & (met.t <= load8_(p.t + 8 * g)));
    if (lanes == 0) return 0;

    float ts[8], us[8], vs[8];
    store8_(met.t, ts);
    store8_(met.wb / met.det, us);
    store8_(met.wc / met.det, vs);
    uint32_t found = 0;
    for (; lanes != 0; lanes = lane_drop_(lanes, lane_first_(lanes))) {
        const uint32_t lane = lane_first_(lanes), i = 8 * g + lane;
        if ((rays >> i & 1u) != 0 && hit_offer(&p.look[i], ts[lane], id & ID_PRIM, us[lane], vs[lane], NO_HIT))
            found |= 1u << i;
    }
    return found;
}

// Ray i of a packet against a shape or instance.  1 if it came nearer.
FN int packet_shape(const SceneTables& s, Packet& p, uint32_t i, uint32_t number, uint32_t id, uint32_t mask) {
    const Ray ray = packet_ray(p, i);
    float t;
    if ((number & REF_INSTANCE) == 0u)
        return (mask >> (id >> 31) & 1u) != 0 &&
               shape_hit(&s.shapes[number], s.polygon_uv, ray.org, ray.dir, ray.tmin, &t) &&
               hit_offer(&p.look[i], t, id & ID_PRIM, 0.0f, 0.0f, NO_HIT);
    TreeRay in;
    uint32_t root;
    return enter_instance(&s, number & REF_INDEX, &ray, mask, &in, &root) &&
           bvh8_walk(&s, &ray, mask, &in, root, 0, &p.look[i]);
}

// Tests the rays against all blocks of a leaf.  Returns those that now hit nearer.
FN uint32_t packet_leaf(const SceneTables& s, Packet& p, const float* block, uint32_t rays, uint32_t mask) {
    uint32_t found = 0;
    const auto look_less_far = [&](uint32_t nearer) {
        found |= nearer;
        for (; nearer != 0; nearer &= nearer - 1) p.t[__builtin_ctz(nearer)] = p.look[__builtin_ctz(nearer)].limit;
    };
    for (;; block += BVH8_LEAF_FLOATS) {
        const uint32_t first = as_uint_(block[BVH8_IDS]);
        for (uint32_t k = 0; k < 4; k++) {
            const uint32_t id = as_uint_(block[BVH8_IDS + k]);
            if ((first & ID_SHAPE) != 0) {
                uint32_t left = packet_box(p, block + BVH8_BOXES, 4, k, rays);
                for (; left != 0; left &= left - 1) {
                    const uint32_t i = uint32_t(__builtin_ctz(left));
                    if (packet_shape(s, p, i, as_uint_(block[k]), id, mask)) look_less_far(1u << i);
                }
            } else if ((mask >> (id >> 31) & 1u) != 0 && !packet_no_triangle(block + k)) {
                PacketInside met;
                for (uint32_t g = 0; 8 * g < p.count; g++)
                    if ((rays >> 8 * g & 255u) != 0) look_less_far(packet_triangle(p, g, rays, block + k, id, met));
            }
        }
        if ((first & ID_LAST) != 0) return found;
    }
}

FN Ray packet_whole_ray(const Packet& p, uint32_t i) {
    Ray ray = packet_ray(p, i);
    ray.tmax = p.length[i];
    return ray;
}

// Traces all rays that have been put.
FN void packet_trace(const SceneTables& s, Packet& p, uint32_t mask) {
    packet_prepare(p);
    for (uint32_t i = 0; i < p.count; i++) {
        const Ray ray = packet_ray(p, i);
        p.length[i] = ray.tmax;
        look_along(&ray, &p.look[i]);
    }
    const uint32_t root = mask == RAY_TRANSPARENT ? ROOT_OF_PANES : ROOT_OF_SCENE;
    for (uint32_t left = packet_all(p); left != 0;) {
        left = packet_open(p, left);
        const bool done = packet_walk(s, p, root, packet_patience(p), [&](const float* block, uint32_t rays) {
            return packet_leaf(s, p, block, rays, mask);
        });
        for (uint32_t alone = done ? 0 : p.open; alone != 0; alone &= alone - 1) {
            const uint32_t i = uint32_t(__builtin_ctz(alone));
            const Ray ray = packet_whole_ray(p, i);
            look_along(&ray, &p.look[i]);
            trace_next(&s, &ray, mask, &p.look[i]);
        }
    }
}
#endif
