// SPDX-License-Identifier: BSD-3-Clause
// Materials whose lobes are .cal functions: plasfunc metfunc transfunc (and *data), BRTDfunc; and ashik2 (spec:
// RADIANCE shading 3.12-3.14).  Their functions scatter direct light only; they have no sampled lobe of their own.
#ifndef LUX_MAT_FUNCTION_H
#define LUX_MAT_FUNCTION_H

// ashik2 keeps its powers along u and v in fields of Lobes that it does not need otherwise.
#define ASHIK_POWER_U alpha2_ru
#define ASHIK_POWER_V alpha2_rv

FN void material_vars(PARAMS(const Params) par, PRIVATE(const Surface) g, PRIVATE(float) vars) {
    surface_vars(par, g, vars);
    // functions see the modelled normal
    if (g->type != M_BRTD && g->type != M_WGMD && g->type != M_PRISM && g->type != M_BSDF) {
        vars[CAL_NX] = g->ng.x;
        vars[CAL_NY] = g->ng.y;
        vars[CAL_NZ] = g->ng.z;
        vars[CAL_RDOT] = dot3(g->ng, g->v);
    }

    vars[CAL_NXP] = g->n.x;
    vars[CAL_NYP] = g->n.y;
    vars[CAL_NZP] = g->n.z;  // always on the viewer's side
    vars[CAL_RDOTP] = dot3(g->n, g->v);
    vars[CAL_CRP] = g->color.x;
    vars[CAL_CGP] = g->color.y;
    vars[CAL_CBP] = g->color.z;
}

// Turns the directions among the values of a material inside an instance (cal::MaterialProgram) back to the world.
// RADIANCE does not turn the grain of anisotropic materials with the instance (checked: plastic2, trans2, ashik2,
// WGMDfunc).
FN void values_from_frame(TABLES(const SceneTables) s, PRIVATE(const Surface) g, uint flags, PRIVATE(float) value) {
    if (g->type == M_PRISM) {
        turn_from_frame(s, g, value, 1u);
        if ((flags & MF_TWO_EXITS) != 0u) turn_from_frame(s, g, value, 5u);
    } else if (g->type == M_BSDF) {
        turn_from_frame(s, g, value, (flags & MF_ABSDF) != 0u ? 0u : 1u);
    }
}

// plasfunc.. : args R G B spec [trans tspec]; type of the specular colour by `metal`.
FN void mat_brdf(PRIVATE(const Surface) g, GLOBAL const float* arg, uint flags, PRIVATE(Lobes) lobes) {
    float3 C = mul3(f3_at(arg), g->color);
    float spec = arg[3], trans = 0.0f, trans_spec = 0.0f;
    if ((flags & MF_TRANS) != 0u) {
        trans = arg[4];
        trans_spec = arg[5];
    }

    float T = trans * (1.0f - spec);
    float rd = 1.0f - T - spec;
    lobes->diffuse_r = scale3(C, rd);
    lobes->diffuse_t = scale3(C, T - T * trans_spec);
    lobes->ambient_r = scale3(C, 1.0f - T);
    lobes->ambient_t = scale3(C, T);
    lobes->fn_r = (flags & MF_METAL) != 0u ? scale3(C, spec) : F3(spec, spec, spec);
    lobes->fn_t = scale3(C, T * trans_spec);
    lobes->flags |= LOBE_FUNCTION;
}

// ashik2: args diffuse3 specular3 u-power v-power; the frame comes in u.
FN void mat_ashik(PARAMS(const Params) par, PRIVATE(const Surface) g, GLOBAL const float* arg, float3 uvec,
                  PRIVATE(Lobes) lobes) {
    float cv = dot3(g->n, g->v);
    float f = 1.0f - MAX_(cv, 0.001f);
    f = f * f * f * f * f;
    lobes->diffuse_r = mul3(f3_at(arg), g->color);
    lobes->ambient_r = lobes->diffuse_r;

    float3 S = f3_at(arg + 3);
    float3 color = F3(S.x + (1.0f - S.x) * f, S.y + (1.0f - S.y) * f, S.z + (1.0f - S.z) * f);
    lobes_rough_r(par, color, luminance3(S), max3(lobes->diffuse_r), lobes);
    lobes->ASHIK_POWER_U = arg[6];
    lobes->ASHIK_POWER_V = arg[7];

    if (!tangent_frame(g->n, uvec, &lobes->u, &lobes->v)) orthonormal_basis(g->n, &lobes->u, &lobes->v);
    lobes->flags |= LOBE_ASHIK;
}

// BRTDfunc (spec 3.14): mirror and straight transmission by functions (values), diffuse args front3 back3 trans3.  The
// surface is not turned to the viewer.
FN void mat_brtd(PRIVATE(const Surface) g, GLOBAL const float* arg, PRIVATE(const float) value, PRIVATE(Lobes) lobes) {
    lobes->diffuse_r = mul3(f3_at(arg + (g->front ? 0 : 3)), g->color);
    lobes->diffuse_t = mul3(f3_at(arg + 6), g->color);
    lobes->ambient_r = lobes->diffuse_r;
    lobes->ambient_t = lobes->diffuse_t;

    if (value[0] + value[1] + value[2] > 0.0f) {
        lobes_mirror(g, F3(value[0], value[1], value[2]), lobes);
        lobes->mirror_dir = unit3(reflection(g->n, g->v));  // it may point below the surface
    }
    if (value[3] + value[4] + value[5] > 0.0f)
        lobes_through(bent_direction(g), F3(value[3], value[4], value[5]), lobes);  // so may this

    lobes->fn_r = F3(1.0f, 1.0f, 1.0f);
    lobes->fn_t = lobes->fn_r;
    lobes->flags |= LOBE_FUNCTION;
}

FN float3 ashik_direct(PRIVATE(const Lobes) lobes, PRIVATE(const Surface) g, float3 l, float w) {
    float cl = dot3(g->n, l), cv = MAX_(dot3(g->n, g->v), 0.001f);
    if (cl <= 0.0f) return F3(0.0f, 0.0f, 0.0f);
    float q = 1.0f - cl;
    float3 sum = scale3(lobes->diffuse_r, cl * w * K_INV_PI * (1.0f - q * q * q * q * q));

    float3 h = unit3(add3(l, g->v));
    float hn = dot3(h, g->n), hu = dot3(h, lobes->u), hv = dot3(h, lobes->v);
    float s2 = 1.0f - hn * hn;
    float e = s2 > 1e-9f ? (lobes->ASHIK_POWER_U * hu * hu + lobes->ASHIK_POWER_V * hv * hv) / s2 : 0.0f;
    float D = k_pow(MAX_(hn, 1e-9f), e) * sqrt_((lobes->ASHIK_POWER_U + 1.0f) * (lobes->ASHIK_POWER_V + 1.0f)) /
              (25.1327412f * dot3(l, h) * MAX_(cl, cv));
    return madd3(lobes->rough_r, D * cl * w, sum);
}

// Half-vector of the anisotropic power lobe (Ashikhmin & Shirley 2000), never weighted (spec 3.12).
FN float ashik_sample(PRIVATE(const Lobes) lobes, PRIVATE(const Surface) g, PRIVATE(Sampler) rnd, PRIVATE(float3) dir) {
    for (int i = 0; i < 10; i++) {
        float2 x = sample2(rnd);
        float sn, cs;
        k_sincos(K_TURN * x.x, &sn, &cs);
        // azimuth: tan phi = sqrt((pu+1)/(pv+1)) tan(2 pi x)
        float ku = cs * sqrt_(lobes->ASHIK_POWER_V + 1.0f), kv = sn * sqrt_(lobes->ASHIK_POWER_U + 1.0f);
        float kk = sqrt_(ku * ku + kv * kv);
        ku /= kk;
        kv /= kk;
        float e = lobes->ASHIK_POWER_U * ku * ku + lobes->ASHIK_POWER_V * kv * kv;
        float cos_h = k_pow(MAX_(1.0f - x.y, 1e-9f), 1.0f / (e + 1.0f));
        float sin_h = 1.0f - cos_h * cos_h;
        sin_h = sqrt_(sin_h > 0.0f ? sin_h : 0.0f);
        float3 h = add3(scale3(g->n, cos_h), add3(scale3(lobes->u, sin_h * ku), scale3(lobes->v, sin_h * kv)));
        float3 r = sub3(scale3(h, 2.0f * dot3(h, g->v)), g->v);
        if (dot3(r, g->ng) > 1e-6f) {
            *dir = unit3(r);
            return 1.0f;
        }
    }

    return 0.0f;
}

// Direct coefficient of the function lobes: s f(l) cos w on the viewer's side, Ts f(l) |cos| w on the other.
FN float3 function_direct(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Lobes) lobes,
                          PRIVATE(const Surface) g, float3 l, float w) {
    float vars[CAL_VARS], out[CAL_OUTPUTS];
    float3 zero = F3(0.0f, 0.0f, 0.0f);
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    uint count = m->flags >> MF_LOBES_SHIFT;
    if (count == 0u) return zero;
    float cl = dot3(g->n, l);
    float3 k = cl > 0.0f ? lobes->fn_r : lobes->fn_t;
    if (max3(k) <= 0.0f) return zero;

    material_vars(par, g, vars);
    vars[CAL_LX] = l.x;
    vars[CAL_LY] = l.y;
    vars[CAL_LZ] = l.z;
    vars[CAL_OMEGA] = w;
    vars_to_frame(s, g, vars);
    if (cal_run(s, m->lobe_program, vars, out)) return zero;

    float3 f = count >= 3u ? F3(out[0], out[1], out[2]) : F3(out[0], out[0], out[0]);
    if (max3(f) <= 1e-6f) return zero;
    return scale3(mul3(k, f), fabs_(cl) * w);
}
#endif
