// SPDX-License-Identifier: BSD-3-Clause
// See evaluate.h.
#include "flatten/evaluate.h"

#include <algorithm>
#include "flatten/pack.h"
#include "kernels/dialect/host.h"
namespace kernels {
#include "kernels/all.h"
}  // namespace kernels

namespace flatten {
using namespace kernels;

namespace {

SceneTables tables_of(const FlatScene& scene) {
    SceneTables t{};
    t.shapes = scene.shapes.data();
    t.prims = scene.prims.data();
    t.instances = scene.instances.data();
    t.modifiers = scene.modifiers.data();
    t.u = scene.u.data();
    t.f = scene.f.data();
    return t;
}

}  // namespace

double mean_luminance(const FlatScene& scene, const Source& source) {
    constexpr uint samples = 64;
    const SceneTables t = tables_of(scene);
    Params par{};
    par.centre = packed(scene.centre);
    const uint kind = source.kind;
    const bool one_sided = kind == SK_PARALLELOGRAM || kind == SK_POLYGON || kind == SK_RING;
    const float3 centre = f3_of(source.centre), normal = f3_of(source.normal);

    double sum = 0, weights = 0;
    for (uint i = 0; i < samples; i++) {
        Sampler rnd = sampler_start(0u, 0u, 0u, i, 0u);
        const float2 x = sample2(&rnd), y = sample2(&rnd);
        float sine, cosine;
        k_sincos(6.28318531f * x.x, &sine, &cosine);
        const float up = 2.0f * x.y - 1.0f, flat = sqrt_(1.0f - up * up);
        float3 out = F3(flat * cosine, flat * sine, up), point = centre;  // out: direction of the light
        double weight = 1;
        if (kind == SK_DISTANT) {
            out = neg3(centre);
            point = F3(0.0f, 0.0f, 0.0f);
        } else if (one_sided) {
            if (dot3(out, normal) < 0.0f) out = neg3(out);
            weight = dot3(out, normal);
            const float3 u = f3_of(source.u), v = f3_of(source.v);
            point = madd3(u, 2.0f * y.x - 1.0f, madd3(v, 2.0f * y.y - 1.0f, centre));
        } else if (kind == SK_CYLINDER) {
            point = madd3(f3_of(source.u), 2.0f * y.x - 1.0f, centre);
        } else {
            point = madd3(out, source.radius, centre);
        }

        const float far = kind == SK_DISTANT ? 1e30f : 8.0f * source.radius;
        const float3 e = light_radiance(&t, &par, source.mod, source.prim, neg3(out), point, one_sided ? normal : out,
                                        far, far, &rnd);
        sum += weight * std::max(luminance3(e), 0.0f);
        weights += weight;
    }
    return sum / weights;
}

double distant_luminance(const FlatScene& scene, const Distant& distant, base::Vec3 dir) {
    if (distant.seen >= DISTANT_BLACK) return 0;
    Params par{};
    par.centre = packed(scene.centre);
    Sampler rnd = sampler_start(0u, 0u, 0u, 0u, 0u);
    const float3 d = F3(float(dir.x), float(dir.y), float(dir.z));
    const SceneTables t = tables_of(scene);
    return std::max(
        luminance3(light_radiance(&t, &par, distant.seen, NONE, d, F3(0.0f, 0.0f, 0.0f), neg3(d), 1e30f, 1e30f, &rnd)),
        0.0f);
}

bool has_orientation(const FlatScene& scene, uint32_t mod, base::Vec3 p, base::Vec3 n) {
    const Modifier& m = scene.modifiers[mod];
    const SceneTables t = tables_of(scene);
    Params par{};
    par.centre = packed(scene.centre);
    Surface g;
    surface_plain(0, mod, NONE, 1, &g);
    g.p = F3(float(p.x), float(p.y), float(p.z));
    g.nface = g.ng = g.n = g.v = F3(float(n.x), float(n.y), float(n.z));
    g.front = 1;
    g.type = M_BSDF;
    g.path_length = 1;
    float vars[CAL_VARS], value[CAL_OUTPUTS] = {};
    material_vars(&par, &g, vars);
    vars_to_frame(&t, &g, vars);
    if (cal_run(&t, m.program, vars, value) != 0) return true;  // told otherwise
    values_from_frame(&t, &g, m.flags, value);
    const float* up = (m.flags & MF_ABSDF) != 0u ? value : value + 1;
    return length3(cross3(F3(up[0], up[1], up[2]), g.n)) > 1e-6f;
}

bool run_program(const FlatScene& scene, uint32_t entry, const float* vars, float* out) {
    const SceneTables t = tables_of(scene);
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

}  // namespace flatten
