// SPDX-License-Identifier: BSD-3-Clause
// Occlusion of rays side by side (packet_rays.h): the answers of trace_any(), to both classes of surfaces in
// one walk.
#ifndef LUX_PACKET_LOOK_H
#define LUX_PACKET_LOOK_H

// Returns the given rays that a shape of these classes stops: in lanes 8 g ... 8 g + 7, or one by one.
FN uint32_t packet_met(const PacketRays& p, uint32_t rays, const float* triangle) {
    uint32_t met = 0;
    PacketInside at;
    for (uint32_t g = 0; 8 * g < p.count; g++) {
        if ((rays >> 8 * g & 255u) == 0 || !packet_inside(p, g, triangle, at)) continue;
        met |= lane_bits_(lanes8_(at.in & (at.t > p.tmin) & (at.t < load8_(p.t + 8 * g)))) << 8 * g;
    }
    return met & rays;
}

// Does a ray meet a shape, or what of a class an instance holds?
FN int shape_met(const SceneTables& s, const Ray& ray, uint32_t number, uint32_t mask) {
    float t;
    if ((number & REF_INSTANCE) == 0u)
        return shape_hit(&s.shapes[number], s.polygon_uv, ray.org, ray.dir, ray.tmin, &t) && t < ray.tmax;
    TreeRay in;
    uint32_t root;
    Look look;
    look_along(&ray, &look);
    return enter_instance(&s, number & REF_INDEX, &ray, mask, &in, &root) &&
           bvh8_walk(&s, &ray, mask, &in, root, 1, &look);
}

// Shape k of a block, of one of these classes; those rays of `rays` that it stops.
FN uint32_t packet_met_shape(const SceneTables& s, const PacketRays& p, uint32_t rays, const float* block, uint32_t k,
                             uint32_t mask) {
    uint32_t met = 0;
    for (uint32_t left = rays; left != 0; left &= left - 1)
        if (shape_met(s, packet_ray(p, uint32_t(__builtin_ctz(left))), as_uint_(block[k]), mask))
            met |= left & (0u - left);
    return met;
}

// All blocks of a leaf: closes rays that something opaque stops, and adds those that something else of the mask stops
// to *panes.  Returns the closed ones.
FN uint32_t packet_look_leaf(const SceneTables& s, PacketRays& p, const float* block, uint32_t rays, uint32_t mask,
                             uint32_t* panes) {
    const uint32_t before = p.open;
    for (;; block += BVH8_LEAF_FLOATS) {
        const uint32_t first = as_uint_(block[BVH8_IDS]);
        for (uint32_t k = 0; k < 4; k++) {
            const uint32_t id = as_uint_(block[BVH8_IDS + k]);
            if ((first & ID_SHAPE) != 0) {
                const uint32_t near = packet_box(p, block + BVH8_BOXES, 4, k, rays & p.open);
                const bool instance = (as_uint_(block[k]) & REF_INSTANCE) != 0;
                if (near == 0) continue;
                if (instance || id >> 31 == 0) p.open &= ~packet_met_shape(s, p, near, block, k, RAY_OPAQUE);
                if ((instance || id >> 31 != 0) && (mask & RAY_TRANSPARENT) != 0)
                    *panes |= packet_met_shape(s, p, near & p.open & ~*panes, block, k, RAY_TRANSPARENT);
            } else if (!packet_no_triangle(block + k)) {
                if (id >> 31 == 0) p.open &= ~packet_met(p, rays & p.open, block + k);
                else if ((mask & RAY_TRANSPARENT) != 0) *panes |= packet_met(p, rays & p.open & ~*panes, block + k);
            }
        }
        if ((first & ID_LAST) != 0 || p.open == 0) return before & ~p.open;
    }
}

// The open rays one by one, in the same way.
FN void look_alone(const SceneTables& s, PacketRays& p, uint32_t mask, uint32_t* panes) {
    for (uint32_t left = p.open; left != 0; left &= left - 1) {
        const uint32_t one = left & (0u - left);
        const Ray ray = packet_ray(p, uint32_t(__builtin_ctz(left)));
        if (trace_any(&s, &ray, RAY_OPAQUE)) p.open &= ~one;
        else if ((mask & RAY_TRANSPARENT) != 0 && trace_any(&s, &ray, RAY_TRANSPARENT)) *panes |= one;
    }
}

// Returns the wanted rays of the packet that nothing opaque stops; *panes: of these, the ones that something
// transparent does, if the mask asks for it.
FN uint32_t packet_look(const SceneTables& s, PacketRays& p, uint32_t wanted, uint32_t mask, uint32_t* panes) {
    uint32_t open = 0, through = 0;
    packet_prepare(p);
    for (uint32_t left = wanted; left != 0; open |= p.open) {
        left = packet_open(p, left);
        const bool done = packet_walk(s, p, ROOT_OF_SCENE, packet_patience(p), [&](const float* block, uint32_t rays) {
            return packet_look_leaf(s, p, block, rays, mask, &through);
        });
        if (!done) look_alone(s, p, mask, &through);
    }
    *panes = through & open;
    return open;
}
#endif
