// SPDX-License-Identifier: BSD-3-Clause
// BSDF and aBSDF: tabulated scattering (spec: RADIANCE shading 3.16).  args: diffuse reflection front, back and
// transmission, RGB each; values: [thickness] up-vector.  The tables' Lambertian part joins the diffuse one.
// Where RADIANCE averages several jittered look-ups, one is drawn, with the same mean.
//   thickness != 0  a proxy of real geometry: the eye and shadows pass, sampled rays scatter
//   aBSDF           the straight-through peak is taken out of the table and becomes a sharp ray, for the eye's rays and
//                   for shadow rays
#ifndef LUX_MAT_BSDF_H
#define LUX_MAT_BSDF_H

// Purpose of a call.
#define LOBES_EYE 0
#define LOBES_SHADOW 1
#define LOBES_SAMPLED 2  // a ray behind a diffuse or rough specular bounce

// Fields of Lobes reused by a BSDF, which does not need them otherwise.  Its frame has z along the modelled normal.
#define BSDF_X trans_dir       // the frame's x in the world
#define BSDF_V_R u             // v in the frame, jittered: for reflection
#define BSDF_V_T v             // and for transmission
#define BSDF_HEMI_R alpha2_ru  // directional-hemispherical values there
#define BSDF_HEMI_T alpha2_rv
#define BSDF_THICKNESS alpha2_tu
#define BSDF_PEAK fn_r
#define BSDF_BESIDE_PEAK fn_r.x
#define BSDF_PEAK_RADIUS2 fn_r.y
#define BSDF_PEAK_KIND fn_r.z
#define PEAK_NONE 0.0f
#define PEAK_RAY 1.0f      // passes as a sharp ray
#define PEAK_SCATTER 2.0f  // is scattered with the rest, but not by direct light

#define PEAK_PROBES 29
#define PEAK_GRID 25  // of these on a grid, the others on the axes

FN float3 bsdf_normal(PRIVATE(const Surface) g) { return g->front ? g->n : neg3(g->n); }
FN float3 bsdf_local(float3 x, float3 z, float3 d) { return F3(dot3(x, d), dot3(cross3(z, x), d), dot3(z, d)); }

FN float3 bsdf_world(float3 x, float3 z, float3 d) {
    return add3(scale3(x, d.x), add3(scale3(cross3(z, x), d.y), scale3(z, d.z)));
}

FN GLOBAL const BsdfComponent* bsdf_component(TABLES(const SceneTables) s, GLOBAL const Modifier* m, int front,
                                              int transmit) {
    return &s->bsdf_components[m->bsdf_at + (uint)((front ? 0 : 2) + transmit)];
}

// v moved by up to half a cell in x and y.
FN float3 bsdf_jitter(float3 v, float psa, float ss, float2 x) {
    float k = sqrt_(psa) * MIN_(ss, 1.0f);
    return unit3(F3(v.x + k * (0.5f - x.x), v.y + k * (0.5f - x.y), v.z));
}

// Place of probe i about the straight direction, in radii of the smallest cell.
FN float2 peak_probe(int i) {
    float2 at;
    at.x = 0.0f;
    at.y = 0.0f;

    if (i >= PEAK_GRID) {  // the axes
        int k = i - PEAK_GRID;
        at.x = k == 0 ? 2.4f : k == 1 ? -2.4f : 0.0f;
        at.y = k == 2 ? 2.4f : k == 3 ? -2.4f : 0.0f;
    } else if (i > 0) {  // eight neighbours of the grid, in three sizes
        int k = (i - 1) & 7;
        float size = 0.6f * (float)(1 + ((i - 1) >> 3));
        k += k >= 4;
        at.x = size * (float)(k % 3 - 1);
        at.y = size * (float)(k / 3 - 1);
    }

    return at;
}

// Cells hit by the probes, by falling value f, and their projected solid angles w; returns their number.
FN int peak_cells(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, float radius, PRIVATE(float) f,
                  PRIVATE(float) w) {
    int count = 0;
    for (int i = 0; i < PEAK_PROBES; i++) {
        float2 at = peak_probe(i);
        float3 l = unit3(F3(radius * at.x - v.x, radius * at.y - v.y, -v.z));
        float psa;
        float value = bsdf_value(s, table, v, l, &psa);

        int place = count;  // equal values are the same cell
        while (place > 0 && f[place - 1] < value) place--;
        if (place > 0 && f[place - 1] == value) continue;
        for (int j = count; j > place; j--) {
            f[j] = f[j - 1];
            w[j] = w[j - 1];
        }
        f[place] = value;
        w[place] = psa;
        count++;
    }

    return count;
}

// Straight-through peak around v, from 29 look-ups: its integral (0 if there is none), and the rest of the
// transmission.
FN float bsdf_peak(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float diffuse, float3 v,
                   PRIVATE(float) beside) {
    float f[PEAK_PROBES], w[PEAK_PROBES];
    float radius2 = table->min_psa, base = diffuse * K_INV_PI;
    int count = peak_cells(s, table, v, sqrt_(radius2), f, w);

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

// aBSDF: the peak as a sharp ray.  Returns its integral.  Sampled rays hit it, but scatter the whole transmission
// (vectors absdf_sampled_*).
FN float bsdf_through(TABLES(const SceneTables) s, GLOBAL const BsdfComponent* component, PRIVATE(const Surface) g,
                      float3 v, int asked, PRIVATE(Lobes) lobes) {
    if (component->table == NONE) return 0.0f;
    GLOBAL const BsdfTable* table = &s->bsdf_tables[component->table];
    float beside = 0.0f;
    float peak = bsdf_peak(s, table, component->lambertian, v, &beside);

    if (peak <= 0.0f) return 0.0f;
    lobes->BSDF_PEAK = F3(beside, table->min_psa, asked == LOBES_SAMPLED ? PEAK_SCATTER : PEAK_RAY);
    if (asked == LOBES_SAMPLED) return 0.0f;

    lobes->through = mul3(scale3(bsdf_color(s, table, v, neg3(v)), peak), g->color);
    lobes->through_dir = neg3(g->v);
    return peak;
}

// Lambertian part: from the arguments and from the table.
FN float3 bsdf_diffuse(GLOBAL const float* arg, GLOBAL const BsdfComponent* component, PRIVATE(const Surface) g) {
    float rho = component->lambertian;
    return mul3(F3(arg[0] + rho, arg[1] + rho, arg[2] + rho), g->color);
}

// v in the frame, jittered in its cell of the table.
FN float3 bsdf_moved(TABLES(const SceneTables) s, PARAMS(const Params) par, GLOBAL const BsdfTable* table, float3 v,
                     float2 move) {
    return bsdf_jitter(v, s->f[table->v_psa + bsdf_cell(s, table, v)], par->ss, move);
}

// The rest of both tables, sampled if there is more of it than -st, else part of the indirect light.
FN void bsdf_tables(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, uint refl,
                    uint trans, float3 v, float peak, float2 move, PRIVATE(Lobes) lobes) {
    if (refl != NONE) {
        lobes->BSDF_V_R = bsdf_moved(s, par, &s->bsdf_tables[refl], v, move);
        float hemi = bsdf_hemispherical(s, &s->bsdf_tables[refl], lobes->BSDF_V_R);
        lobes->BSDF_HEMI_R = hemi;
        lobes->rough_r = F3(hemi, hemi, hemi);
        if (hemi > par->st) lobes->flags |= LOBE_SAMPLE_R;
        else lobes->ambient_r = add3(lobes->ambient_r, lobes->rough_r);
    }

    if (trans != NONE) {
        lobes->BSDF_V_T = bsdf_moved(s, par, &s->bsdf_tables[trans], v, move);
        lobes->BSDF_HEMI_T = bsdf_hemispherical(s, &s->bsdf_tables[trans], lobes->BSDF_V_T);
        lobes->rough_t = scale3(g->color, lobes->BSDF_HEMI_T);  // with the peak, whose samples are dropped
        float hemi = MAX_(lobes->BSDF_HEMI_T - peak, 0.0f);
        if (hemi > par->st) lobes->flags |= LOBE_SAMPLE_T;
        else lobes->ambient_t = madd3(g->color, hemi, lobes->ambient_t);
    }
}

FN_RARE void mat_bsdf(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g,
                      GLOBAL const Modifier* m, PRIVATE(const float) value, int asked, PRIVATE(Sampler) rnd,
                      PRIVATE(Lobes) lobes) {
    GLOBAL const float* arg = s->f + m->args;
    int peaked = (m->flags & MF_ABSDF) != 0u;
    float thickness = peaked || fabs_(value[0]) <= 1e-6f ? 0.0f : value[0];
    if (thickness != 0.0f && (asked != LOBES_SAMPLED || (thickness > 0.0f) != g->front)) {
        lobes->flags |= LOBE_PASS;
        return;
    }

    if (asked == LOBES_SHADOW && !peaked) return;

    float3 z = bsdf_normal(g), up = peaked ? F3(value[0], value[1], value[2]) : F3(value[1], value[2], value[3]);
    float3 x = cross3(up, z);
    if (length3(x) <= 1e-6f) return;  // without orientation it is black
    x = unit3(x);
    float3 v = bsdf_local(x, z, g->v);

    GLOBAL const BsdfComponent* refl = bsdf_component(s, m, g->front, 0);
    GLOBAL const BsdfComponent* trans = bsdf_component(s, m, g->front, 1);
    float peak = peaked ? bsdf_through(s, trans, g, v, asked, lobes) : 0.0f;
    if (asked == LOBES_SHADOW) return;

    lobes->flags |= LOBE_BSDF;
    lobes->BSDF_X = x;
    lobes->BSDF_THICKNESS = thickness;
    lobes->diffuse_r = bsdf_diffuse(arg + (g->front ? 0 : 3), refl, g);
    lobes->diffuse_t = bsdf_diffuse(arg + 6, trans, g);
    lobes->ambient_r = lobes->diffuse_r;
    lobes->ambient_t = lobes->diffuse_t;
    bsdf_tables(s, par, g, refl->table, trans->table, v, peak, sample2(rnd), lobes);
}

// Origin of a ray on this side: a transmitted ray starts behind the geometry that a proxy represents.
FN float3 bsdf_start(PRIVATE(const Lobes) lobes, PRIVATE(const Surface) g, int above) {
    if (above || (lobes->flags & LOBE_BSDF) == 0u || lobes->BSDF_THICKNESS == 0.0f) return g->p;
    return madd3(g->nface, -lobes->BSDF_THICKNESS, g->p);
}

// Coefficient of a source sample, as lobes_direct().
FN_RARE float3 bsdf_direct(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Lobes) lobes,
                           PRIVATE(const Surface) g, float3 dir, float w, PRIVATE(Sampler) rnd) {
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    float3 z = bsdf_normal(g);
    float3 v = bsdf_local(lobes->BSDF_X, z, g->v), l = bsdf_local(lobes->BSDF_X, z, dir);
    int transmit = (l.z > 0.0f) != (v.z > 0.0f);
    float3 sum = scale3(transmit ? lobes->diffuse_t : lobes->diffuse_r, fabs_(l.z) * w * K_INV_PI);
    GLOBAL const BsdfComponent* component = bsdf_component(s, m, g->front, transmit);
    if (component->table == NONE) return sum;
    GLOBAL const BsdfTable* table = &s->bsdf_tables[component->table];
    float3 tint = transmit ? g->color : F3(1.0f, 1.0f, 1.0f);

    if (transmit && lobes->BSDF_PEAK_KIND != PEAK_NONE) {
        float dx = l.x + v.x, dy = l.y + v.y, W = w * fabs_(l.z), r2 = lobes->BSDF_PEAK_RADIUS2;
        if (dx * dx + dy * dy <= 3.18309886f * (W + r2 + 2.0f * sqrt_(W * r2)))
            return madd3(mul3(tint, bsdf_color(s, table, v, l)), lobes->BSDF_BESIDE_PEAK * fabs_(l.z) * w, sum);
    }

    float psa, psa0;
    float f = bsdf_value(s, table, v, l, &psa0);
    float3 seen = v;

    if (par->ss > 0.0f) {
        f = 0.0f;
        for (int i = 0; i < 8; i++) {  // cells much smaller than the first do not represent it
            float3 moved = bsdf_jitter(v, psa0, par->ss, sample2(rnd));
            float value = bsdf_value(s, table, moved, l, &psa);
            if (psa < 0.12f * psa0) continue;
            f = value;
            seen = moved;
            break;
        }
    }

    if (f <= 0.0f) return sum;
    return madd3(mul3(tint, bsdf_color(s, table, seen, l)), f * fabs_(l.z) * w, sum);
}

// Samples the tabulated part.  *coef: its colour; returns the weight besides it, 0 = no valid direction.
FN_RARE float bsdf_sample_lobe(TABLES(const SceneTables) s, PRIVATE(const Lobes) lobes, PRIVATE(const Surface) g,
                               int transmit, PRIVATE(Sampler) rnd, PRIVATE(float3) coef, PRIVATE(float3) dir) {
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    GLOBAL const BsdfComponent* component = bsdf_component(s, m, g->front, transmit);
    GLOBAL const BsdfTable* table = &s->bsdf_tables[component->table];
    float3 v = transmit ? lobes->BSDF_V_T : lobes->BSDF_V_R, l, z = bsdf_normal(g);
    float hemi = transmit ? lobes->BSDF_HEMI_T : lobes->BSDF_HEMI_R, weight = bsdf_sample(s, table, v, rnd, &l);
    if (weight <= 0.0f || hemi <= 0.0f) return 0.0f;
    if ((v.z > 0.0f) == transmit) l.z = -l.z;

    if (transmit && lobes->BSDF_PEAK_KIND == PEAK_RAY) {
        float dx = l.x + v.x, dy = l.y + v.y;
        float3 straight = bsdf_local(lobes->BSDF_X, z, g->v);
        if (dx * dx + dy * dy <= s->f[table->v_psa + bsdf_cell(s, table, straight)]) return 0.0f;
    }

    *coef = scale3(bsdf_color(s, table, v, l), hemi);
    if (transmit) *coef = mul3(*coef, g->color);
    *dir = bsdf_world(lobes->BSDF_X, z, l);  // a texture may turn it to the other side, where it continues
    return weight / hemi;
}
#endif
