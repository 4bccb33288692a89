// SPDX-License-Identifier: BSD-3-Clause
// The kernels' traversal compiled for the host.
#include "flatten/host_tracer.h"

#include "base/processors.h"
#include "flatten/host_rays.h"
#include "flatten/pack.h"
namespace kernels {
#include "kernels/all.h"
}  // namespace kernels

namespace flatten {
using namespace kernels;

#define POINT_AT_BVH(type, name) tables.name = bvh->name.data();
#define POINT_AT_SCENE(type, name) tables.name = scene.name.data();

const HostRays host_rays_baseline = {trace_closest, trace_any};

struct HostTracer::State {
    const HostRays& rays = base::has_avx2() ? host_rays_avx2 : host_rays_baseline;
    const FlatScene& scene;
    std::shared_ptr<const bvh::Tree> bvh;
    SceneTables tables{};
    Params params{};
    explicit State(const FlatScene& s)
        : scene(s),
          bvh(s.built.wide){BVH_TABLES(POINT_AT_BVH) FLAT_TABLES(POINT_AT_SCENE)} Ray
          ray(base::Vec3 o, base::Vec3 d, double tmin, double tmax) const {
        o = o - scene.centre;
        Ray r;
        r.org = F3(float(o.x), float(o.y), float(o.z));
        r.dir = F3(float(d.x), float(d.y), float(d.z));
        r.tmin = float(tmin);
        r.tmax = float(tmax);
        return r;
    }
};

HostTracer::HostTracer(const FlatScene& scene) : state_(std::make_unique<State>(scene)) {}
HostTracer::~HostTracer() = default;

HostTracer::Found HostTracer::closest(base::Vec3 o, base::Vec3 d, double tmin, double tmax, Mask mask) const {
    const Ray r = state_->ray(o, d, tmin, tmax);
    Hit h;
    state_->rays.closest(&state_->tables, &r, mask, &h);
    if (h.prim == NO_HIT) return {-1, NO_HIT, NO_HIT, {}, {}, 0};
    Surface g;
    surface_at(&state_->tables, &r, &h, &g);
    return {h.t,
            h.prim,
            h.inst,
            {g.nface.x, g.nface.y, g.nface.z},
            base::Vec3{g.p.x, g.p.y, g.p.z} + state_->scene.centre,
            g.rounding};
}

bool HostTracer::blocked(base::Vec3 o, base::Vec3 d, double tmin, double tmax, Mask mask) const {
    const Ray r = state_->ray(o, d, tmin, tmax);
    return state_->rays.any(&state_->tables, &r, mask) != 0;
}

HostTracer::SourcePoint HostTracer::source_point(uint32_t i, base::Vec3 p, double x, double y) const {
    p = p - state_->scene.centre;
    LightSample l;
    float2 r;
    r.x = float(x);
    r.y = float(y);
    sample_source(&state_->tables, &state_->params, i, F3(float(p.x), float(p.y), float(p.z)), r, 1.0f, &l);
    if (l.w <= 0) return {{}, 0, 0};
    const Source& q = state_->scene.sources[i];
    double w = l.w;
    if (IS_SPOT(&q)) {  // the focal length dims the light of a spotlight, not its appearance
        const bool sphere = q.kind == SK_SPHERE;
        const double d = sphere ? length(vec_of(q.centre) - p) : l.dist;
        const double k = d / (d + q.spot_focus);
        w /= k * k;
    }
    return {{l.dir.x, l.dir.y, l.dir.z}, l.dist, w};
}

}  // namespace flatten
