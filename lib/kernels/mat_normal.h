// SPDX-License-Identifier: BSD-3-Clause
// plastic, metal, trans and their anisotropic sisters plastic2, metal2, trans2 (spec: RADIANCE shading 3.1-3.4, 3.11).
// args: R G B specularity roughness [roughness2] [transmissivity transmitted-specular]
#ifndef LUX_MAT_NORMAL_H
#define LUX_MAT_NORMAL_H

FN void mat_normal(PRIVATE const Params* par, PRIVATE const Surface* g, uint type, GLOBAL const float* arg, float3 uvec,
                   PRIVATE Lobes* out) {
    int aniso = type >= M_ANISO_PLASTIC && type <= M_ANISO_TRANS;
    int metal = type == M_METAL || type == M_ANISO_METAL, trans = type == M_TRANS || type == M_ANISO_TRANS;
    float3 C = mul3(F3(arg[0], arg[1], arg[2]), g->color);
    float s = arg[3], a = arg[4];
    float t = 0.0f, ts = 0.0f;
    if (trans) {
        t = arg[aniso ? 6 : 5];
        ts = arg[aniso ? 7 : 6];
    }
    int smooth = !aniso && a * a <= 1e-6f;
    float cv = dot3(g->n, g->v), f = 0.0f;
    if (cv < 0.001f) cv = 0.001f;
    if (smooth && s >= 0.017999f) f = fresnel_estimate(cv);
    float rs = s + f * (1.0f - s);
    float T = t * (1.0f - rs), Ts = T * ts, Td = T - Ts, rd = 1.0f - T - rs;
    float3 spec = F3(rs, rs, rs);
    if (metal) spec = f > 1e-6f ? add3(F3(f, f, f), scale3(C, s * (1.0f - f))) : scale3(C, rs);

    out->diffuse_r = scale3(C, rd);
    out->diffuse_t = scale3(C, Td);
    out->ambient_r = out->diffuse_r;
    out->ambient_t = out->diffuse_t;
    float3 p = trans ? transmitted_direction(g) : neg3(g->v);
    if (smooth) {
        if (rs >= 0.017999f) out->flags |= LOBE_FRESNEL;
        if (rs > 1e-6f) {
            out->mirror = spec;
            out->mirror_dir = mirror_direction(g);
        }
        if (Ts > 1e-6f) {
            out->through = scale3(C, Ts);
            out->through_dir = p;
        }
        return;
    }
    out->au = a * a;
    out->av = a * a;
    if (aniso) {
        out->av = arg[5] * arg[5];
        float3 v = cross3(g->n, uvec);
        float l = length3(v);
        if (l > 1e-6f) {
            out->v = scale3(v, 1.0f / l);
            out->u = cross3(out->v, g->n);
            out->flags |= LOBE_ANISO;
        } else {
            out->au = 0.5f * (out->au + out->av);
            out->av = out->au;
        }
    }
    out->tu = out->au;
    out->tv = out->av;
    if (rs > 1e-6f) {
        out->rough_r = spec;
        if (par->st >= rs - 1e-6f) out->ambient_r = add3(out->ambient_r, spec);
        else out->flags |= LOBE_SAMPLE_R;
    }
    if (Ts > 1e-6f) {
        out->rough_t = scale3(C, Ts);
        out->trans_dir = p;
        if (par->st >= Ts - 1e-6f) out->ambient_t = add3(out->ambient_t, out->rough_t);
        else out->flags |= LOBE_SAMPLE_T;
    }
}
#endif
