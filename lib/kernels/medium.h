// SPDX-License-Identifier: BSD-3-Clause
// Participating media: crossing a mist, extinction along a segment, single scattering (spec: RADIANCE shading 3.9).
#ifndef LUX_MEDIUM_H
#define LUX_MEDIUM_H

// Participating media (spec shading 3.9).  A medium is an extinction rgb and, in w (bits), the mist last entered.
// Crossing a mist's surface adds or takes away its extinction; for shadow rays without the albedo's share.
FN float4 mist_crossing(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g, float4 medium,
                        int shadow) {
    GLOBAL const float* arg = s->f + mod_record(s, par, g->mod)[MOD_ARGS];
    float3 k = mul3(F3(arg[0], arg[1], arg[2]), g->color);
    if (shadow) k = mul3(k, F3(1.0f - arg[3], 1.0f - arg[4], 1.0f - arg[5]));
    float sign = g->front ? 1.0f : -1.0f;
    float4 r;
    r.x = MAX_(medium.x + sign * k.x, 0.0f);
    r.y = MAX_(medium.y + sign * k.y, 0.0f);
    r.z = MAX_(medium.z + sign * k.z, 0.0f);
    r.w = as_float_(g->front ? g->mod : NONE);
    return r;
}
// Albedo and eccentricity of a medium: the mist's, else the global ones.
FN float3 medium_albedo(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint mist, PRIVATE float* g) {
    if (mist == NONE) { *g = par->albedo.w; return F3(par->albedo.x, par->albedo.y, par->albedo.z); }
    GLOBAL const float* arg = s->f + mod_record(s, par, mist)[MOD_ARGS];
    *g = arg[6];
    return F3(arg[3], arg[4], arg[5]);
}

// What a medium of extinction k lets through over a length (Beer's law).
FN float3 attenuation(float3 k, float length) {
    if (max3(k) <= 0.0f) return F3(1.0f, 1.0f, 1.0f);
    return F3(k_exp(-k.x * length), k_exp(-k.y * length), k_exp(-k.z * length));
}

// A mist may name sources whose light it scatters once into the ray (list: count, source indices).
FN int mist_scatters(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint mist) {
    uint list = mod_record(s, par, mist)[MOD_EXTRA];
    return list != NONE && list != 0u && s->u[list] > 0u;
}

// Single scattering along a segment that ends after `length`: a random point of it, a random source of the mist; with
// Henyey and Greenstein's phase function (spec shading 3.9).  Half of the steps do this, half light the surface.
FN int scatter_shadow(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* a, uint slot, float3 org,
                      float3 dir, float length, float3 k, float3 albedo, float ecc, uint mist, float3 thr, float total,
                      PRIVATE Sampler* rnd) {
    if (!mist_scatters(s, par, mist)) return 0;
    float2 x = sample2(rnd), y = sample2(rnd);
    if (x.x < 0.5f) return 0;
    uint list = mod_record(s, par, mist)[MOD_EXTRA], count = s->u[list];
    uint pick = (uint)((2.0f * x.x - 1.0f) * (float)count);
    pick = s->u[list + 1u + MIN_(pick, count - 1u)];
    float t = x.y * length;
    float3 p = madd3(dir, t, org);
    LightSample ls;
    sample_source(s, par, pick, p, y, par->dj, &ls);
    if (ls.w <= 0.0f) return 0;
    GLOBAL const float* q = source_record(s, par, pick);
    float3 e = F3(1.0f, 1.0f, 1.0f);  // a virtual source's radiance is known where its ray arrives
    if (as_uint_(q[SRC_VIRTUAL]) == NONE)
        e = light_radiance(s, par, as_uint_(q[SRC_MOD]), as_uint_(q[SRC_PRIM]), ls.dir, ls.point, ls.normal, ls.dist,
                           total + t + ls.dist, rnd);
    float c = dot3(ls.dir, dir), d = 1.0f + ecc * ecc - 2.0f * ecc * c;
    float phase = (1.0f - ecc * ecc) / (d * sqrt_(d)) * 0.0795774715f;
    float3 w = mul3(mul3(mul3(k, albedo), attenuation(k, t)), mul3(thr, e));
    w = scale3(w, 2.0f * (float)count * length * phase * ls.w);
    if (max3(w) <= 0.0f) return 0;
    a->sorg[slot] = pack4(p, as_float_(pick));
    a->sdir[slot] = pack4(ls.dir, ls.dist);
    a->scol[slot] = pack4(w, total + t);
    a->smed[slot] = pack4(mul3(k, sub3(F3(1.0f, 1.0f, 1.0f), albedo)), 0.0f);
    return 1;
}
#endif
