// SPDX-License-Identifier: BSD-3-Clause
// Both traversals in host C++, in namespaces of their own, and a brute-force search over the same primitives.
#pragma once
#include "unit/bvh_scenes.h"

namespace kernels {
#include "kernels/geom/shapes.h"
#include "kernels/bvh/woop.h"
#include "kernels/bvh/offset_ray.h"
namespace wide {
#include "kernels/bvh/bvh8.h"
#include "device/packet_rays.h"
#include "device/packets.h"
#include "device/packet_look.h"
inline void trace_first(const SceneTables* s, const Ray* ray, uint mask, Hit* hit) {
    Look look;
    look_along(ray, &look);
    trace_next(s, ray, mask, &look);
    *hit = look.hit;
}
}  // namespace wide
namespace compact {
#include "kernels/bvh/bvh_compact.h"
inline void trace_first(const SceneTables* s, const Ray* ray, uint mask, Hit* hit) {
    Look look;
    look_along(ray, &look);
    trace_next(s, ray, mask, &look);
    *hit = look.hit;
}
}  // namespace compact

inline SceneTables tables(const bvh_scenes::Scene& s, const bvh::Tree& bvh) {
    SceneTables t{};
    t.nodes = bvh.nodes.data();
    t.leaves = bvh.leaves.data();
    t.shapes = s.shapes.data();
    t.polygon_uv = s.polygon_uv.data();
    t.instances = s.instances.data();
    return t;
}

inline Ray ray_of(const bvh_scenes::Ray& r) {
    return {F3(r.org[0], r.org[1], r.org[2]), r.tmin, F3(r.dir[0], r.dir[1], r.dir[2]), r.tmax};
}

// Every primitive of a part, one after the other.
inline void brute_part(const bvh_scenes::Scene& s, size_t part, const Ray& ray, const WoopRay& w, uint mask, uint inst,
                       Look* look) {
    const auto& p = s.parts[part];
    for (size_t i = p.triangle; i < p.triangle + p.triangles; i++) {
        float3 v[3];
        for (int k = 0; k < 3; k++) {
            const float* q = &s.vertices[3 * s.triangles[3 * i + k]];
            v[k] = F3(q[0], q[1], q[2]);
        }
        float t, u, vv;
        if ((mask >> (s.tri_prim[i] >> 31) & 1) && woop_triangle(&w, v[0], v[1], v[2], &t, &u, &vv) && t > look->from)
            hit_offer(look, t, s.tri_prim[i] & ID_PRIM, u, vv, inst);
    }
    for (size_t i = p.shape; i < p.shape + p.shapes; i++) {
        float t;
        if ((mask >> (s.shape_prim[i] >> 31) & 1) &&
            shape_hit(&s.shapes[i], s.polygon_uv.data(), w.org, w.dir, look->from, &t))
            hit_offer(look, t, s.shape_prim[i] & ID_PRIM, 0, 0, inst);
    }
    for (size_t i = 0; part == 0 && i < s.instances.size(); i++) {
        const Instance& one = s.instances[i];
        WoopRay local;
        woop_prepare(instance_point(one.to_tree, ray.org), affine_vector(one.to_tree, ray.dir), &local);
        if (one.forced == 0 || (mask & one.forced))
            brute_part(s, one.tree, ray, local, one.forced ? RAY_ALL : mask, uint32_t(i), look);
    }
}

// What look asks for.
inline void brute_next(const bvh_scenes::Scene& s, const Ray& ray, uint mask, Look* look) {
    WoopRay w;
    woop_prepare(ray.org, ray.dir, &w);
    brute_part(s, 0, ray, w, mask, NO_HIT, look);
}

inline Hit brute(const bvh_scenes::Scene& s, const Ray& ray, uint mask) {
    Look look;
    look_along(&ray, &look);
    brute_next(s, ray, mask, &look);
    return look.hit;
}

}  // namespace kernels
