// SPDX-License-Identifier: BSD-3-Clause
// BSDF and aBSDF: tabulated scattering (spec: RADIANCE shading 3.16).  args: diffuse reflection front, back and
// transmission, RGB each; values: [thickness] up-vector.  The tables' Lambertian part joins the diffuse one.
// Where RADIANCE averages several jittered look-ups, one is drawn: the same mean.
//   thickness != 0  a proxy of real geometry: the eye and shadows pass, sampled rays scatter
//   aBSDF           what goes straight on is taken out of the table and becomes a sharp ray ("peak")
// Use of Lobes: trans_dir = the frame's x; u, v = jittered v (local) for reflection and transmission; au, av = their
// hemispherical values; tu = thickness; fn_r = peak: light beside it, squared radius, present.
#ifndef LUX_MAT_BSDF_H
#define LUX_MAT_BSDF_H

// what asks for the lobes
#define LOBES_EYE 0
#define LOBES_SHADOW 1
#define LOBES_SAMPLED 2  // a ray below a diffuse or rough-specular sample

#define PEAK_PROBES 29

FN float3 bsdf_normal(PRIVATE const Surface* g) { return g->front ? g->n : neg3(g->n); }
FN float3 bsdf_local(float3 x, float3 z, float3 d) { return F3(dot3(x, d), dot3(cross3(z, x), d), dot3(z, d)); }
FN float3 bsdf_world(float3 x, float3 z, float3 d) {
    return add3(scale3(x, d.x), add3(scale3(cross3(z, x), d.y), scale3(z, d.z)));
}
FN GLOBAL const uint* bsdf_component(PRIVATE const SceneTables* s, GLOBAL const uint* m, int front, int transmit) {
    return s->u + m[MOD_EXTRA] + BSDF_COMPONENT_WORDS * (uint)((front ? 0 : 2) + transmit);
}
// v moved by up to half a cell in x and y.
FN float3 bsdf_jitter(float3 v, float psa, float ss, float2 x) {
    float k = sqrt_(psa) * MIN_(ss, 1.0f);
    return unit3(F3(v.x + k * (0.5f - x.x), v.y + k * (0.5f - x.y), v.z));
}

// The straight-through peak around v, from 29 look-ups: its integral (0 if there is none), and what is left beside it.
FN float bsdf_peak(PRIVATE const SceneTables* s, GLOBAL const uint* t, float diffuse, float3 v, PRIVATE float* beside) {
    float f[PEAK_PROBES], w[PEAK_PROBES];
    float radius2 = as_float_(t[BT_MIN_PSA]), radius = sqrt_(radius2), base = diffuse * 0.31830989f;
    int count = 0;
    for (int i = 0; i < PEAK_PROBES; i++) {
        float x = 0.0f, y = 0.0f, psa;
        if (i >= 25) {  // the axes
            int k = i - 25;
            x = k == 0 ? 2.4f : k == 1 ? -2.4f : 0.0f;
            y = k == 2 ? 2.4f : k == 3 ? -2.4f : 0.0f;
        } else if (i > 0) {  // eight neighbours of the grid, in three sizes
            int k = (i - 1) & 7;
            float size = 0.6f * (float)(1 + ((i - 1) >> 3));
            k += k >= 4;
            x = size * (float)(k % 3 - 1);
            y = size * (float)(k / 3 - 1);
        }
        float3 l = unit3(F3(radius * x - v.x, radius * y - v.y, -v.z));
        float value = bsdf_value(s, t, v, l, &psa);
        int at = count;  // by falling value; equal ones are the same cell
        while (at > 0 && f[at - 1] < value) at--;
        if (at > 0 && f[at - 1] == value) continue;
        for (int j = count; j > at; j--) {
            f[j] = f[j - 1];
            w[j] = w[j - 1];
        }
        f[at] = value;
        w[at] = psa;
        count++;
    }
    float peak = 0.0f, peak_w = 0.0f, peak_f = 0.0f, rest = 0.0f, rest_w = 0.0f;
    int in_peak = 0;
    for (int i = 0; i < count; i++) {
        if (w[i] > 1.5f * radius2 || peak_f > 8.0f * (f[i] + base) * (float)in_peak) {
            if (i == 0) return 0.0f;
            rest += f[i] * w[i];
            rest_w += w[i];
        } else {
            peak += f[i] * w[i];
            peak_w += w[i];
            peak_f += f[i] + base;
            in_peak++;
        }
    }
    if (rest_w < 0.2f * peak_w || rest_w <= 0.0f) return 0.0f;
    *beside = rest / rest_w;
    return peak < 0.0005f ? 0.0f : peak;
}

FN_RARE void mat_bsdf(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g,
                      GLOBAL const uint* m, PRIVATE const float* value, int asked, PRIVATE Sampler* rnd,
                      PRIVATE Lobes* out) {
    GLOBAL const float* arg = s->f + m[MOD_ARGS];
    int peaked = (m[MOD_FLAGS] & MF_ABSDF) != 0u;
    float thickness = peaked || fabs_(value[0]) <= 1e-6f ? 0.0f : value[0];
    if (thickness != 0.0f && (asked != LOBES_SAMPLED || (thickness > 0.0f) != g->front)) {
        out->flags |= LOBE_PASS;
        return;
    }
    if (asked == LOBES_SHADOW && !peaked) return;
    float3 z = bsdf_normal(g), up = peaked ? F3(value[0], value[1], value[2]) : F3(value[1], value[2], value[3]);
    float3 x = cross3(up, z), y;
    if (length3(x) > 1e-6f) x = unit3(x);
    else frame_of(z, &x, &y);
    float3 v = bsdf_local(x, z, g->v), grey = F3(1.0f, 1.0f, 1.0f);
    GLOBAL const uint* r = bsdf_component(s, m, g->front, 0);
    GLOBAL const uint* t = bsdf_component(s, m, g->front, 1);
    float peak = 0.0f;
    if (peaked && t[0] != NONE) {
        GLOBAL const uint* table = s->u + t[0];
        float beside = 0.0f;
        peak = bsdf_peak(s, table, as_float_(t[1]), v, &beside);
        if (peak > 0.0f) {
            out->through = mul3(scale3(bsdf_color(s, table, v, neg3(v)), peak), g->color);
            out->through_dir = neg3(g->v);
            out->fn_r = F3(beside, as_float_(table[BT_MIN_PSA]), 1.0f);
        }
    }
    if (asked == LOBES_SHADOW) return;
    out->flags |= LOBE_BSDF;
    out->trans_dir = x;
    out->tu = thickness;
    arg += g->front ? 0 : 3;
    float rho = as_float_(r[1]);
    out->diffuse_r = mul3(F3(arg[0] + rho, arg[1] + rho, arg[2] + rho), g->color);
    arg += g->front ? 6 : 3;
    rho = as_float_(t[1]);
    out->diffuse_t = mul3(F3(arg[0] + rho, arg[1] + rho, arg[2] + rho), g->color);
    out->ambient_r = out->diffuse_r;
    out->ambient_t = out->diffuse_t;
    float2 move = sample2(rnd);
    if (r[0] != NONE) {
        GLOBAL const uint* table = s->u + r[0];
        out->u = bsdf_jitter(v, s->f[table[BT_PSA] + bsdf_cell(s, table, v)], par->ss, move);
        float hemi = bsdf_hemispherical(s, table, out->u);
        out->au = hemi;
        out->rough_r = scale3(grey, hemi);
        if (hemi > par->st) out->flags |= LOBE_SAMPLE_R;
        else out->ambient_r = add3(out->ambient_r, out->rough_r);
    }
    if (t[0] != NONE) {
        GLOBAL const uint* table = s->u + t[0];
        out->v = bsdf_jitter(v, s->f[table[BT_PSA] + bsdf_cell(s, table, v)], par->ss, move);
        out->av = bsdf_hemispherical(s, table, out->v);
        out->rough_t = scale3(g->color, out->av);  // with the peak, whose samples are dropped
        float hemi = out->av - peak;
        hemi = MAX_(hemi, 0.0f);
        if (hemi > par->st) out->flags |= LOBE_SAMPLE_T;
        else out->ambient_t = madd3(g->color, hemi, out->ambient_t);
    }
}

// Where a ray of this side starts: transmitted ones beyond what a proxy stands for.
FN float3 bsdf_start(PRIVATE const Lobes* a, PRIVATE const Surface* g, int above) {
    if (above || (a->flags & LOBE_BSDF) == 0u || a->tu == 0.0f) return g->p;
    return madd3(g->nface, -a->tu, g->p);
}

// Coefficient of a source sample, as lobes_direct().
FN_RARE float3 bsdf_direct(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Lobes* a,
                           PRIVATE const Surface* g, float3 dir, float w, PRIVATE Sampler* rnd) {
    GLOBAL const uint* m = s->u + par->mods_at + MOD_WORDS * g->mod;
    float3 z = bsdf_normal(g), v = bsdf_local(a->trans_dir, z, g->v), l = bsdf_local(a->trans_dir, z, dir);
    int transmit = (l.z > 0.0f) != (v.z > 0.0f);
    if (transmit != (dot3(dir, g->ng) < 0.0f)) return F3(0.0f, 0.0f, 0.0f);
    float3 sum = scale3(transmit ? a->diffuse_t : a->diffuse_r, fabs_(l.z) * w * 0.31830989f);
    uint at = bsdf_component(s, m, g->front, transmit)[0];
    if (at == NONE) return sum;
    GLOBAL const uint* t = s->u + at;
    float3 tint = transmit ? g->color : F3(1.0f, 1.0f, 1.0f);
    if (transmit && a->fn_r.z > 0.0f) {
        float dx = l.x + v.x, dy = l.y + v.y, W = w * fabs_(l.z), r2 = a->fn_r.y;
        if (dx * dx + dy * dy <= 3.18309886f * (W + r2 + 2.0f * sqrt_(W * r2)))
            return madd3(mul3(tint, bsdf_color(s, t, v, l)), a->fn_r.x * fabs_(l.z) * w, sum);
    }
    float psa, psa0, f = bsdf_value(s, t, v, l, &psa0);
    float3 seen = v;
    if (par->ss > 0.0f) {
        f = 0.0f;
        for (int i = 0; i < 8; i++) {  // cells much smaller than the first do not stand for it
            float3 moved = bsdf_jitter(v, psa0, par->ss, sample2(rnd));
            float value = bsdf_value(s, t, moved, l, &psa);
            if (psa < 0.12f * psa0) continue;
            f = value;
            seen = moved;
            break;
        }
    }
    if (f <= 0.0f) return sum;
    return madd3(mul3(tint, bsdf_color(s, t, seen, l)), f * fabs_(l.z) * w, sum);
}

// One sample of the tabulated part.  *coef: its colour; returns the factor beside it, 0 = lost.
FN_RARE float bsdf_sample_lobe(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Lobes* a,
                               PRIVATE const Surface* g, int transmit, PRIVATE Sampler* rnd, PRIVATE float3* coef,
                               PRIVATE float3* dir) {
    GLOBAL const uint* m = s->u + par->mods_at + MOD_WORDS * g->mod;
    GLOBAL const uint* t = s->u + bsdf_component(s, m, g->front, transmit)[0];
    float3 v = transmit ? a->v : a->u, l, z = bsdf_normal(g);
    float hemi = transmit ? a->av : a->au, weight = bsdf_sample(s, t, v, rnd, &l);
    if (weight <= 0.0f || hemi <= 0.0f) return 0.0f;
    if ((v.z > 0.0f) == transmit) l.z = -l.z;
    if (transmit && a->fn_r.z > 0.0f) {  // the peak has its own ray
        float dx = l.x + v.x, dy = l.y + v.y;
        float3 straight = bsdf_local(a->trans_dir, z, g->v);
        if (dx * dx + dy * dy <= s->f[t[BT_PSA] + bsdf_cell(s, t, straight)]) return 0.0f;
    }
    *coef = scale3(bsdf_color(s, t, v, l), hemi);
    if (transmit) *coef = mul3(*coef, g->color);
    *dir = bsdf_world(a->trans_dir, z, l);
    if ((dot3(*dir, g->ng) < 0.0f) != transmit) return 0.0f;
    return weight / hemi;
}
#endif
