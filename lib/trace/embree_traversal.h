// SPDX-License-Identifier: BSD-3-Clause
// trace_closest and trace_any by Embree's own traversal, in place of kernels/bvh8.h (device "cpu:embree"): the
// independent check of ours.  SceneTables.nodes carries the bvh::EmbreeScene.
FN void trace_closest(SHARED(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Hit) hit) {
    const float o[3] = {ray->org.x, ray->org.y, ray->org.z}, d[3] = {ray->dir.x, ray->dir.y, ray->dir.z};
    const auto h = reinterpret_cast<const bvh::EmbreeScene*>(s->nodes)->closest(o, ray->tmin, d, ray->tmax, mask);
    hit->t = h.t;
    hit->prim = h.prim;
    hit->u = h.u;
    hit->v = h.v;
    hit->inst = h.inst;
}
FN int trace_any(SHARED(const SceneTables) s, PRIVATE(const Ray) ray, uint mask) {
    const float o[3] = {ray->org.x, ray->org.y, ray->org.z}, d[3] = {ray->dir.x, ray->dir.y, ray->dir.z};
    return reinterpret_cast<const bvh::EmbreeScene*>(s->nodes)->any(o, ray->tmin, d, ray->tmax, mask);
}
