// SPDX-License-Identifier: BSD-3-Clause
// plastic, metal, trans and their anisotropic sisters plastic2, metal2, trans2 (spec: RADIANCE shading 3.1-3.4, 3.11).
// args: R G B specularity roughness [roughness2] [transmissivity transmitted-specular]
#ifndef LUX_MAT_NORMAL_H
#define LUX_MAT_NORMAL_H

// Roughnesses along both axes if uvec gives them, else their mean.
FN void normal_axes(PRIVATE(const Surface) g, float rough_u, float rough_v, float3 uvec, PRIVATE(Lobes) lobes) {
    lobes->alpha2_ru = rough_u * rough_u;
    lobes->alpha2_rv = rough_v * rough_v;
    if (tangent_frame(g->n, uvec, &lobes->u, &lobes->v)) {
        lobes->flags |= LOBE_ANISO;
    } else {
        lobes->alpha2_ru = 0.5f * (lobes->alpha2_ru + lobes->alpha2_rv);
        lobes->alpha2_rv = lobes->alpha2_ru;
    }
}

FN void mat_normal(PARAMS(const Params) par, PRIVATE(const Surface) g, uint type, GLOBAL const float* arg, float3 uvec,
                   PRIVATE(Lobes) lobes) {
    int aniso = type >= M_ANISO_PLASTIC && type <= M_ANISO_TRANS;
    int metal = type == M_METAL || type == M_ANISO_METAL, is_trans = type == M_TRANS || type == M_ANISO_TRANS;
    float3 C = mul3(f3_at(arg), g->color);
    float spec0 = arg[3], rough = arg[4], trans = 0.0f, trans_spec = 0.0f;
    if (is_trans) {
        trans = arg[aniso ? 6 : 5];
        trans_spec = arg[aniso ? 7 : 6];
    }

    // split of the light
    int smooth = !aniso && rough * rough <= 1e-6f;
    float cv = dot3(g->n, g->v), f = 0.0f;
    if (cv < 0.001f) cv = 0.001f;
    if (smooth && spec0 >= FRESNEL_FROM) f = fresnel_estimate(cv);
    float rs = spec0 + f * (1.0f - spec0);
    float T = trans * (1.0f - rs);
    float Ts = T * trans_spec;
    float Td = T - Ts, rd = 1.0f - T - rs;
    float3 spec = F3(rs, rs, rs);
    if (metal) spec = f > 1e-6f ? add3(F3(f, f, f), scale3(C, spec0 * (1.0f - f))) : scale3(C, rs);

    lobes->diffuse_r = scale3(C, rd);
    lobes->diffuse_t = scale3(C, Td);
    lobes->ambient_r = lobes->diffuse_r;
    lobes->ambient_t = lobes->diffuse_t;

    // specular part: rays of its own if smooth, else lobes
    float3 dir = is_trans ? transmitted_direction(g) : neg3(g->v);

    if (smooth) {
        if (rs >= FRESNEL_FROM) lobes->flags |= LOBE_FRESNEL;
        if (rs > LOBE_LEAST) lobes_mirror(g, spec, lobes);
        if (Ts > LOBE_LEAST) lobes_through(dir, scale3(C, Ts), lobes);
        return;
    }

    if (aniso) {
        normal_axes(g, rough, arg[5], uvec, lobes);
    } else {
        lobes->alpha2_ru = rough * rough;
        lobes->alpha2_rv = rough * rough;
    }

    lobes->alpha2_tu = lobes->alpha2_ru;
    lobes->alpha2_tv = lobes->alpha2_rv;
    lobes->trans_dir = dir;
    if (rs > LOBE_LEAST) lobes_rough_r(par, spec, rs, rd, lobes);
    if (Ts > LOBE_LEAST) lobes_rough_t(par, scale3(C, Ts), Ts, Td, lobes);
}
#endif
