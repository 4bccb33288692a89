// SPDX-License-Identifier: BSD-3-Clause
// WGMDfunc (spec: RADIANCE shading 3.15): specular reflection and transmission, diffuse reflection and transmission,
// that add.  Each is a component with a modifier of its own, whose patterns and textures act on it alone; the diffuse
// reflection has the material's.  args: diffuse front, back, transmitted, RGB each; values: rs ur vr ts utr vtr u,
// where the functions of rs and ts see the normals of these, those of u the material's; u[MOD_BRANCH1]..: modifiers of
// rs, ts, td.
#ifndef LUX_MAT_WGMD_H
#define LUX_MAT_WGMD_H

#define WGMD_INHERIT 0xfffffffeu  // the modifier "inherit": the material's own

// The surface as one component sees it.
FN void wgmd_component(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g, uint mod,
                       PRIVATE Sampler* rnd, PRIVATE Surface* c) {
    *c = *g;
    if (mod == WGMD_INHERIT) return;
    without_own_chain(s, c);
    c->mod = mod;
    if (mod != NONE) find_material(s, par, c, rnd);
    c->mod = g->mod;
    shading_normal(c);
}

FN int wgmd_same_normal(PRIVATE const Surface* a, PRIVATE const Surface* b) {
    return a->n.x == b->n.x && a->n.y == b->n.y && a->n.z == b->n.z;
}

// The values as the functions of a component give them.
FN void wgmd_values(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g,
                    PRIVATE const Surface* c, uint program, PRIVATE const float* value, PRIVATE float* own) {
    float vars[CAL_VARS];
    for (int i = 0; i < CAL_OUTPUTS; i++) own[i] = value[i];
    if (wgmd_same_normal(g, c)) return;
    material_vars(par, c, vars);
    vars_to_frame(s, c, vars);
    if (cal_run(s, program, vars, own))
        for (int i = 0; i < CAL_OUTPUTS; i++) own[i] = 0.0f;
}

// Straight on, bent by what the textures do to the unit normal, from behind in the same way as from the front (other
// materials: transmitted_direction()).
FN float3 wgmd_transmitted(PRIVATE const Surface* c) {
    float3 p = neg3(c->v), bend = sub3(c->n, c->ng);
    if (c->smooth || dot3(bend, bend) <= 1e-12f) return p;
    p = unit3(c->front ? sub3(p, bend) : add3(p, bend));
    return dot3(p, c->ng) < -1e-6f ? p : neg3(c->v);
}

// The tangent frame about n, if u gives one.
FN int wgmd_frame(float3 n, float3 along, PRIVATE float3* u, PRIVATE float3* v) {
    *v = cross3(n, along);
    float l = length3(*v);
    if (l <= 1e-6f) return 0;
    *v = scale3(*v, 1.0f / l);
    *u = cross3(*v, n);
    return 1;
}

FN_RARE void mat_wgmd(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g,
                      GLOBAL const uint* m, PRIVATE const float* value, PRIVATE Sampler* rnd, PRIVATE Lobes* out) {
    GLOBAL const float* arg = s->f + m[MOD_ARGS];
    GLOBAL const uint* mods = s->u + m[MOD_BRANCH1];
    Surface r, t, d;
    float of_r[CAL_OUTPUTS], of_t[CAL_OUTPUTS];
    wgmd_component(s, par, g, mods[0], rnd, &r);
    wgmd_component(s, par, g, mods[1], rnd, &t);
    wgmd_component(s, par, g, mods[2], rnd, &d);
    wgmd_values(s, par, g, &r, m[MOD_PROGRAM], value, of_r);
    wgmd_values(s, par, g, &t, m[MOD_PROGRAM], value, of_t);
    float3 rs = scale3(r.color, of_r[0]), ts = scale3(t.color, of_t[3]);
    out->diffuse_r = mul3(F3(arg[g->front ? 0 : 3], arg[g->front ? 1 : 4], arg[g->front ? 2 : 5]), g->color);
    out->diffuse_t = mul3(F3(arg[6], arg[7], arg[8]), d.color);
    out->trans_dir = wgmd_transmitted(&t);
    out->au = of_r[1] * of_r[1];
    out->av = of_r[2] * of_r[2];
    out->tu = of_t[4] * of_t[4];
    out->tv = of_t[5] * of_t[5];
    float3 along = F3(value[6], value[7], value[8]);
    if (wgmd_frame(r.n, along, &out->u, &out->v) && wgmd_frame(t.n, along, &out->ut, &out->vt)) {
        out->flags |= LOBE_ANISO;
    } else {
        out->au = 0.5f * (out->au + out->av);
        out->av = out->au;
        out->tu = 0.5f * (out->tu + out->tv);
        out->tv = out->tu;
    }
    if (!wgmd_same_normal(g, &r) || !wgmd_same_normal(g, &t) || !wgmd_same_normal(g, &d)) {
        out->n_r = r.n;
        out->n_t = t.n;
        out->n_dt = d.n;
        out->flags |= LOBE_OWN_NORMALS | (r.flat ? LOBE_FLAT_R : 0u);
    }
    float rest = 1.0f, lum = luminance3(rs);
    int smooth_r = out->au <= 1e-6f || out->av <= 1e-6f, smooth_t = out->tu <= 1e-6f || out->tv <= 1e-6f;
    if (smooth_r) {
        if (lum >= 0.017999f) {
            float f = fresnel_estimate_wgmd(MAX_(dot3(r.n, g->v), 0.001f));
            rest = 1.0f - f;
            rs = F3(rs.x + f * (1.0f - rs.x), rs.y + f * (1.0f - rs.y), rs.z + f * (1.0f - rs.z));
            out->flags |= LOBE_WGMD_FRESNEL;
        }
        if (max3(rs) > 1e-6f) {
            out->mirror = rs;
            out->mirror_dir = mirror_direction(&r);
        }
    }
    out->diffuse_r = scale3(out->diffuse_r, rest);
    out->diffuse_t = scale3(out->diffuse_t, rest);
    ts = scale3(ts, rest);
    out->ambient_r = out->diffuse_r;
    out->ambient_t = out->diffuse_t;
    if (!smooth_r && max3(rs) > 1e-6f) {
        out->rough_r = rs;
        if (par->st >= luminance3(rs) - 1e-6f) out->ambient_r = add3(out->ambient_r, rs);
        else out->flags |= LOBE_SAMPLE_R;
    }
    if (max3(ts) > 1e-6f) {
        if (smooth_t) {
            out->through = ts;
            out->through_dir = out->trans_dir;
        } else {
            out->rough_t = ts;
            if (par->st >= luminance3(ts) - 1e-6f) out->ambient_t = add3(out->ambient_t, ts);
            else out->flags |= LOBE_SAMPLE_T;
        }
    }
}

// Gives g and the lobes the normal and frame of one component, before that is sampled or lit.
#define WGMD_ROUGH_R 0
#define WGMD_ROUGH_T 1
#define WGMD_DIFFUSE_T 2
FN_RARE void wgmd_turn(PRIVATE Lobes* l, PRIVATE Surface* g, int component) {
    if (component == WGMD_DIFFUSE_T) g->n = l->n_dt;
    if (component == WGMD_ROUGH_R) {
        g->n = l->n_r;
        g->flat = (l->flags & LOBE_FLAT_R) != 0u;
    }
    if (component == WGMD_ROUGH_T) {
        g->n = l->n_t;
        l->u = l->ut;
        l->v = l->vt;
    }
}

// Coefficient of a source sample, as lobes_direct(): the components one by one, each about its normal.  What a smooth
// reflection takes from the diffuse ones goes by its own.
FN_RARE float3 wgmd_direct(PRIVATE const Lobes* a, PRIVATE const Surface* g, float3 l, float w, float dj) {
    float3 zero = F3(0.0f, 0.0f, 0.0f);
    Lobes none = *a, part;
    none.diffuse_r = zero;
    none.diffuse_t = zero;
    none.rough_r = zero;
    none.rough_t = zero;
    float rest = lobes_fresnel(a->flags, fabs_(dot3(a->n_r, l)));
    none.flags &= ~LOBE_WGMD_FRESNEL;
    part = none;
    part.diffuse_r = scale3(a->diffuse_r, rest);
    float3 sum = lobes_direct(&part, g, l, w, dj);
    for (int i = WGMD_ROUGH_R; i <= WGMD_DIFFUSE_T; i++) {
        Surface c = *g;
        part = none;
        if (i == WGMD_ROUGH_R) part.rough_r = a->rough_r;
        if (i == WGMD_ROUGH_T) part.rough_t = a->rough_t;
        if (i == WGMD_DIFFUSE_T) part.diffuse_t = scale3(a->diffuse_t, rest);
        wgmd_turn(&part, &c, i);
        sum = add3(sum, lobes_direct(&part, &c, l, w, dj));
    }
    return sum;
}
#endif
