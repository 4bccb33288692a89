// SPDX-License-Identifier: BSD-3-Clause
// WGMDfunc (spec: RADIANCE shading 3.15): the sum of specular reflection and transmission, diffuse reflection and
// transmission. Each component has a modifier of its own, whose patterns and textures act on it alone; the diffuse
// reflection has the material's.  args: diffuse front, back, transmitted, RGB each; values: rs ur vr ts utr vtr u.  The
// functions of rs and ts see the normals of their components, the functions of u that of the material;
// Modifier.rs_mod, ts_mod, td_mod: modifiers of the components.
#ifndef LUX_MAT_WGMD_H
#define LUX_MAT_WGMD_H

// The surface with the normal and pattern of one component.
FN void wgmd_component(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, uint mod,
                       PRIVATE(Sampler) rnd, PRIVATE(Surface) c) {
    *c = *g;
    if (mod == WGMD_INHERIT) return;
    without_own_chain(s, c);
    c->mod = mod;
    if (mod != NONE) find_material(s, par, c, rnd);
    c->mod = g->mod;
    shading_normal(c);
}

FN int wgmd_same_normal(PRIVATE(const Surface) a, PRIVATE(const Surface) b) {
    return a->n.x == b->n.x && a->n.y == b->n.y && a->n.z == b->n.z;
}

// Values of the functions of a component.
FN void wgmd_values(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g,
                    PRIVATE(const Surface) c, uint program, PRIVATE(const float) value, PRIVATE(float) own) {
    float vars[CAL_VARS];
    for (int i = 0; i < CAL_OUTPUTS; i++) own[i] = value[i];
    if (wgmd_same_normal(g, c)) return;
    material_vars(par, c, vars);
    vars_to_frame(s, c, vars);
    if (cal_run(s, program, vars, own))
        for (int i = 0; i < CAL_OUTPUTS; i++) own[i] = 0.0f;
}

// Straight transmission, bent by the textures' displacement of the unit normal, from behind as from the front (other
// materials: transmitted_direction()).
FN float3 wgmd_transmitted(PRIVATE(const Surface) c) {
    float3 p = neg3(c->v), bend = sub3(c->n, c->ng);
    if (c->smooth || dot3(bend, bend) <= 1e-12f) return p;
    p = unit3(c->front ? sub3(p, bend) : add3(p, bend));
    return dot3(p, c->ng) < -1e-6f ? p : neg3(c->v);
}

// Roughness and tangent frames of both rough lobes.
FN void wgmd_axes(PRIVATE(const Surface) refl, PRIVATE(const Surface) trans, float3 along, PRIVATE(Lobes) lobes) {
    if (tangent_frame(refl->n, along, &lobes->u, &lobes->v) &&
        tangent_frame(trans->n, along, &lobes->t_u, &lobes->t_v)) {
        lobes->flags |= LOBE_ANISO;
        return;
    }

    lobes->alpha2_ru = 0.5f * (lobes->alpha2_ru + lobes->alpha2_rv);
    lobes->alpha2_rv = lobes->alpha2_ru;
    lobes->alpha2_tu = 0.5f * (lobes->alpha2_tu + lobes->alpha2_tv);
    lobes->alpha2_tv = lobes->alpha2_tu;
}

FN void wgmd_normals(PRIVATE(const Surface) g, PRIVATE(const Surface) refl, PRIVATE(const Surface) trans,
                     PRIVATE(const Surface) diff, PRIVATE(Lobes) lobes) {
    if (wgmd_same_normal(g, refl) && wgmd_same_normal(g, trans) && wgmd_same_normal(g, diff)) return;
    lobes->n_r = refl->n;
    lobes->n_t = trans->n;
    lobes->n_dt = diff->n;
    lobes->flags |= LOBE_OWN_NORMALS | (refl->flat ? LOBE_FLAT_R : 0u);
}

// Reflection of a smooth surface of specularity *rs.  Returns the fraction left for the other components.
FN float wgmd_mirror(PRIVATE(const Surface) refl, float3 viewer, PRIVATE(float3) rs, PRIVATE(Lobes) lobes) {
    float rest = 1.0f;
    if (luminance3(*rs) >= FRESNEL_FROM) {
        float f = fresnel_estimate_wgmd(MAX_(dot3(refl->n, viewer), 0.001f));
        rest = 1.0f - f;
        *rs = F3(rs->x + f * (1.0f - rs->x), rs->y + f * (1.0f - rs->y), rs->z + f * (1.0f - rs->z));
        lobes->flags |= LOBE_WGMD_FRESNEL;
    }

    if (max3(*rs) > LOBE_LEAST) lobes_mirror(refl, *rs, lobes);
    return rest;
}

FN_RARE void mat_wgmd(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g,
                      GLOBAL const Modifier* m, PRIVATE(const float) value, PRIVATE(Sampler) rnd,
                      PRIVATE(Lobes) lobes) {
    GLOBAL const float* arg = s->f + m->args;
    Surface refl, trans, diff;
    float refl_value[CAL_OUTPUTS], trans_value[CAL_OUTPUTS];
    wgmd_component(s, par, g, m->rs_mod, rnd, &refl);
    wgmd_component(s, par, g, m->ts_mod, rnd, &trans);
    wgmd_component(s, par, g, m->td_mod, rnd, &diff);
    wgmd_values(s, par, g, &refl, m->program, value, refl_value);
    wgmd_values(s, par, g, &trans, m->program, value, trans_value);

    lobes->trans_dir = wgmd_transmitted(&trans);
    lobes->alpha2_ru = refl_value[1] * refl_value[1];
    lobes->alpha2_rv = refl_value[2] * refl_value[2];
    lobes->alpha2_tu = trans_value[4] * trans_value[4];
    lobes->alpha2_tv = trans_value[5] * trans_value[5];

    // one roughness of 0 makes it smooth, even without an axis, where the lobe has their mean
    int smooth_r = lobes->alpha2_ru <= 1e-6f || lobes->alpha2_rv <= 1e-6f;
    int smooth_t = lobes->alpha2_tu <= 1e-6f || lobes->alpha2_tv <= 1e-6f;
    wgmd_axes(&refl, &trans, F3(value[6], value[7], value[8]), lobes);
    wgmd_normals(g, &refl, &trans, &diff, lobes);

    float3 rs = scale3(refl.color, refl_value[0]), ts = scale3(trans.color, trans_value[3]);
    float rest = smooth_r ? wgmd_mirror(&refl, g->v, &rs, lobes) : 1.0f;
    ts = scale3(ts, rest);

    lobes->diffuse_r = mul3(f3_at(arg + (g->front ? 0 : 3)), g->color);
    lobes->diffuse_t = mul3(f3_at(arg + 6), diff.color);
    lobes->diffuse_r = scale3(lobes->diffuse_r, rest);
    lobes->diffuse_t = scale3(lobes->diffuse_t, rest);
    lobes->ambient_r = lobes->diffuse_r;
    lobes->ambient_t = lobes->diffuse_t;

    if (!smooth_r && max3(rs) > LOBE_LEAST) lobes_rough_r(par, rs, luminance3(rs), max3(lobes->diffuse_r), lobes);
    if (max3(ts) <= LOBE_LEAST) return;
    if (smooth_t) lobes_through(lobes->trans_dir, ts, lobes);
    else lobes_rough_t(par, ts, luminance3(ts), max3(lobes->diffuse_t), lobes);
}

// Sets the normal and frame of one component in g and the lobes, before that component is sampled or lit.
#define WGMD_ROUGH_R 0
#define WGMD_ROUGH_T 1
#define WGMD_DIFFUSE_T 2
FN_RARE void wgmd_turn(PRIVATE(Lobes) lobes, PRIVATE(Surface) g, int component) {
    if (component == WGMD_DIFFUSE_T) g->n = lobes->n_dt;
    if (component == WGMD_ROUGH_R) {
        g->n = lobes->n_r;
        g->flat = (lobes->flags & LOBE_FLAT_R) != 0u;
    }

    if (component == WGMD_ROUGH_T) {
        g->n = lobes->n_t;
        lobes->u = lobes->t_u;
        lobes->v = lobes->t_v;
    }
}

// Coefficient of a source sample, as lobes_direct(): each component about its own normal.  The share of a smooth
// reflection is subtracted from the diffuse components by its own normal.
FN_RARE float3 wgmd_direct(PRIVATE(const Lobes) lobes, PRIVATE(const Surface) g, float3 l, float w, float dj) {
    float3 zero = F3(0.0f, 0.0f, 0.0f);
    Lobes none = *lobes, part;
    none.diffuse_r = zero;
    none.diffuse_t = zero;
    none.rough_r = zero;
    none.rough_t = zero;
    float rest = lobes_fresnel(lobes->flags, fabs_(dot3(lobes->n_r, l)));
    none.flags &= ~LOBE_WGMD_FRESNEL;
    part = none;
    part.diffuse_r = scale3(lobes->diffuse_r, rest);
    float3 sum = lobes_direct(&part, g, l, w, dj);

    for (int i = WGMD_ROUGH_R; i <= WGMD_DIFFUSE_T; i++) {
        Surface c = *g;
        part = none;
        if (i == WGMD_ROUGH_R) part.rough_r = lobes->rough_r;
        if (i == WGMD_ROUGH_T) part.rough_t = lobes->rough_t;
        if (i == WGMD_DIFFUSE_T) part.diffuse_t = scale3(lobes->diffuse_t, rest);
        wgmd_turn(&part, &c, i);
        sum = add3(sum, lobes_direct(&part, &c, l, w, dj));
    }

    return sum;
}
#endif
