// SPDX-License-Identifier: BSD-3-Clause
// The shared traversal compiled for plain hosts.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <math.h>

#include "trace/build_input.h"
#include "trace/host_tracer.h"

namespace host {
#include "kernels/compat_host.h"
#include "kernels/all.h"
}  // namespace host

namespace trace {
using namespace host;

#define POINT_AT_BVH(type, name) tables.name = bvh.name.data();
#define POINT_AT_SCENE(type, name) tables.name = scene.name.data();

struct HostTracer::State {
    const FlatScene& scene;
    bvh::Tree bvh;
    SceneTables tables{};
    Params params{};
    static bvh::Tree build(const FlatScene& s) {
        const std::vector<bvh::Input> trees = build_inputs(s);
        return bvh::build8(trees.data(), trees.size());
    }
    explicit State(const FlatScene& s) : scene(s), bvh(build(s)) {
        BVH_TABLES(POINT_AT_BVH)
        FLAT_TABLES(POINT_AT_SCENE)
        params.sources_at = s.sources_at;
        params.source_count = s.source_count;
    }
    Ray ray(base::Vec3 o, base::Vec3 d, double tmin, double tmax) const {
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
    trace_closest(&state_->tables, &r, mask, &h);
    if (h.prim == NO_HIT) return {-1, NO_HIT, {}};
    Surface g;
    surface_at(&state_->tables, &r, &h, &g);
    return {h.t, h.prim, {g.nface.x, g.nface.y, g.nface.z}};
}

bool HostTracer::blocked(base::Vec3 o, base::Vec3 d, double tmin, double tmax, Mask mask) const {
    const Ray r = state_->ray(o, d, tmin, tmax);
    return trace_any(&state_->tables, &r, mask) != 0;
}

HostTracer::SourcePoint HostTracer::source_point(uint32_t i, base::Vec3 p, double x, double y) const {
    p = p - state_->scene.centre;
    LightSample l;
    float2 r;
    r.x = float(x);
    r.y = float(y);
    sample_source(&state_->tables, &state_->params, i, F3(float(p.x), float(p.y), float(p.z)), r, 1.0f, &l);
    if (l.w <= 0) return {{}, 0, 0};
    const float* q = source_record(&state_->tables, &state_->params, i);
    double w = l.w;
    if (q[SRC_SPOT + 3] > -1.5f) {  // the focal length dims the light a spotlight gives, not how it looks
        const bool sphere = as_uint_(q[SRC_KIND]) == SK_SPHERE;
        const double d = sphere ? length(base::Vec3{q[SRC_CENTRE], q[SRC_CENTRE + 1], q[SRC_CENTRE + 2]} - p) : l.dist;
        const double k = d / (d + q[SRC_SPOT + 4]);
        w /= k * k;
    }
    return {{l.dir.x, l.dir.y, l.dir.z}, l.dist, w};
}

double mean_luminance(const FlatScene& scene, const float* record) {
    constexpr uint samples = 64;
    SceneTables t{};
    t.shapes = scene.shapes.data();
    t.prims = scene.prims.data();
    t.u = scene.u.data();
    t.f = scene.f.data();
    Params par{};
    par.mods_at = scene.mods_at;
    par.centre = {float(scene.centre.x), float(scene.centre.y), float(scene.centre.z), 0};
    const uint kind = as_uint_(record[SRC_KIND]);
    const bool one_sided = kind == SK_PARALLELOGRAM || kind == SK_POLYGON || kind == SK_RING;
    const float3 centre = f3_at(record + SRC_CENTRE), normal = f3_at(record + SRC_NORMAL);
    double sum = 0, weights = 0;
    for (uint i = 0; i < samples; i++) {
        Sampler rnd = sampler_start(0u, 0u, 0u, i, 0u);
        const float2 x = sample2(&rnd), y = sample2(&rnd);
        float sine, cosine;
        k_sincos(6.28318531f * x.x, &sine, &cosine);
        const float up = 2.0f * x.y - 1.0f, flat = sqrt_(1.0f - up * up);
        float3 out = F3(flat * cosine, flat * sine, up), point = centre;  // out: the way the light goes
        double weight = 1;
        if (kind == SK_DISTANT) {
            out = neg3(centre);
            point = F3(0.0f, 0.0f, 0.0f);
        } else if (one_sided) {
            if (dot3(out, normal) < 0.0f) out = neg3(out);
            weight = dot3(out, normal);
            const float3 u = f3_at(record + SRC_U), v = f3_at(record + SRC_V);
            point = madd3(u, 2.0f * y.x - 1.0f, madd3(v, 2.0f * y.y - 1.0f, centre));
        } else if (kind == SK_CYLINDER) {
            point = madd3(f3_at(record + SRC_U), 2.0f * y.x - 1.0f, centre);
        } else {
            point = madd3(out, record[SRC_RADIUS], centre);
        }
        const float far = kind == SK_DISTANT ? 1e30f : 8.0f * record[SRC_RADIUS];
        const float3 e = light_radiance(&t, &par, as_uint_(record[SRC_MOD]), as_uint_(record[SRC_PRIM]), neg3(out),
                                        point, one_sided ? normal : out, far, far, &rnd);
        sum += weight * std::max(luminance3(e), 0.0f);
        weights += weight;
    }
    return sum / weights;
}

bool run_program(const FlatScene& scene, uint32_t entry, const float* vars, float* out) {
    SceneTables t{};
    t.u = scene.u.data();
    t.f = scene.f.data();
    return cal_run(&t, entry, vars, out) == 0;
}

RayVars ray_vars(const FlatScene& scene, base::Vec3 p, base::Vec3 d, base::Vec3 n) {
    static_assert(CAL_VARS <= 64, "RayVars is too small");
    RayVars v{};
    p = p + scene.centre;
    const base::Vec3 triple[3] = {d, n, p};
    const int at[3] = {CAL_DX, CAL_NX, CAL_PX};
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++) v.values[at[k] + c] = float(triple[k][c]);
    v.values[CAL_RDOT] = float(-dot(d, n));
    v.values[CAL_NXP] = float(n.x);
    v.values[CAL_NYP] = float(n.y);
    v.values[CAL_NZP] = float(n.z);
    v.values[CAL_RDOTP] = v.values[CAL_RDOT];
    return v;
}

}  // namespace trace
