// SPDX-License-Identifier: BSD-3-Clause
// Light of the sources that mists name, scattered once into the ray (spec: RADIANCE shading 3.9).
#ifndef LUX_SCATTER_H
#define LUX_SCATTER_H

FN GLOBAL const uint* light_set(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint set) {
    return s->u + par->light_sets_at + LIGHT_SET_WORDS * set;
}

// How many sources a medium scatters.
FN uint scattered_count(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Medium* m) {
    uint count = 0u;
    if (m->lights == 0u || max3(mul3(m->k, m->albedo)) <= 0.0f) return 0u;
    for (uint set = 0u, left = m->lights; left != 0u; set++, left >>= 1)
        if ((left & 1u) != 0u) count += light_set(s, par, set)[LIGHT_SET_COUNT];
    return count;
}

FN uint scattered_source(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint lights, uint pick) {
    for (uint set = 0u, left = lights; left != 0u; set++, left >>= 1) {
        GLOBAL const uint* q = light_set(s, par, set);
        if ((left & 1u) == 0u) continue;
        if (pick < q[LIGHT_SET_COUNT]) return s->u[q[LIGHT_SET_FIRST] + pick];
        pick -= q[LIGHT_SET_COUNT];
    }
    return NONE;
}

// Single scattering along a segment that ends after `length`: a random point of it, a random one of `count` sources;
// with Henyey and Greenstein's phase function.  x, y: random, x.x in .5 .. 1, for half of the steps do this and half
// light the surface.  1: a shadow ray waits.
FN int scatter_shadow(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* a, uint slot,
                      float3 org, float3 dir, float length, PRIVATE const Medium* m, uint count, uint clip, float3 thr,
                      float total, float2 x, float2 y, PRIVATE Sampler* rnd) {
    uint pick = (uint)((2.0f * x.x - 1.0f) * (float)count);
    pick = scattered_source(s, par, m->lights, MIN_(pick, count - 1u));
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
    float ecc = MAX_(m->ecc, 0.0f);  // RADIANCE takes one below 0 for 0
    float c = dot3(ls.dir, dir), d = 1.0f + ecc * ecc - 2.0f * ecc * c;
    float phase = (1.0f - ecc * ecc) / (d * sqrt_(d)) * 0.0795774715f;
    float3 w = mul3(mul3(mul3(m->k, m->albedo), attenuation(m->k, t)), mul3(thr, e));
    w = scale3(w, 2.0f * (float)count * length * phase * ls.w);
    if (max3(w) <= 0.0f) return 0;
    a->sorg[slot] = pack4(p, as_float_(pick));
    a->sdir[slot] = pack4(ls.dir, ls.dist);
    a->scol[slot] = pack4(w, total + t);
    set_shadow_medium(a, slot, m, clip);
    return 1;
}
#endif
