// SPDX-License-Identifier: BSD-3-Clause
// Active sources: their records and radiance; and the distant background (sun, sky).  source_sample.h samples points on
// them. Active sources light surfaces through this file alone, all other emitters through sampled rays alone (spec
// shading 0.1).
#ifndef LUX_SOURCES_H
#define LUX_SOURCES_H

STRUCT(LightSample) {
    float3 dir;     // from the point to the source, unit
    float dist;     // FAR_AWAY for distant ones
    float w;        // solid angle of this sample
    float pieces;   // with -ds: the number of pieces of a source; lobes are widened by one piece
    float3 point;   // on the source (local sources)
    float3 normal;  // there
};

// Record of an active source, or of a sun of many hours (SUN_OF_HOUR).
FN GLOBAL const Source* source_record(TABLES(const SceneTables) s, uint source) {
    return (source & SUN_OF_HOUR) != 0u ? &s->suns[source & ~SUN_OF_HOUR] : &s->sources[source];
}

// A point of an emitter, seen along dir (from the viewer to the light); mod: its modifier.
FN void light_surface(uint mod, uint prim, float3 dir, float3 point, float3 normal, float length, float path_length,
                      PRIVATE(Surface) g) {
    surface_plain(prim, mod, NONE, length, g);
    g->p = point;
    g->nface = normal;
    g->ng = normal;
    g->n = normal;
    g->v = neg3(dir);
    g->path_length = path_length;
    g->type = 0u;
    g->front = 1;
    g->flat = 0;
}

// Returns 1 if this material is the only modifier of its chain.
FN int is_bare(TABLES(const SceneTables) s, uint mod) {
    GLOBAL const Modifier* m = &s->modifiers[mod];
    return m->type >= M_FIRST_MATERIAL && m->next == NONE;
}

// Radiance of light material `mod` seen along dir, patterns included.
FN float3 light_radiance(TABLES(const SceneTables) s, PARAMS(const Params) par, uint mod, uint prim, float3 dir,
                         float3 point, float3 normal, float length, float path_length, PRIVATE(Sampler) rnd) {
    Surface g;
    light_surface(mod, prim, dir, point, normal, length, path_length, &g);
    if (!is_bare(s, mod) && !find_material(s, par, &g, rnd)) return F3(0.0f, 0.0f, 0.0f);
    return mul3(g.color, f3_at(s->f + s->modifiers[g.mod].args));
}

// The same of the background, which may have patterns where nothing else has.
FN float3 sky_radiance(TABLES(const SceneTables) s, PARAMS(const Params) par, uint mod, float3 org, float3 dir,
                       PRIVATE(Sampler) rnd) {
    Surface g;
    light_surface(mod, NONE, dir, org, neg3(dir), FAR_AWAY, FAR_AWAY, &g);
    if (!is_bare(s, mod) && !chain_material(s, par, &g, rnd)) return F3(0.0f, 0.0f, 0.0f);
    return mul3(g.color, f3_at(s->f + s->modifiers[g.mod].args));
}

// Radiance of the source of record src at its sampled point.  path_length_start: from the eye to the point lit.  1 for
// a virtual source, whose radiance is known only at the end of its shadow ray.
FN float3 sampled_radiance(TABLES(const SceneTables) s, PARAMS(const Params) par, GLOBAL const Source* src,
                           PRIVATE(const LightSample) light, float path_length_start, PRIVATE(Sampler) rnd) {
    if (src->relay != NONE) return F3(1.0f, 1.0f, 1.0f);
    return light_radiance(s, par, src->mod, src->prim, light->dir, light->point, light->normal, light->dist,
                          path_length_start + light->dist, rnd);
}

// Distant surface seen in direction dir: the first non-glow that matches, else the first glow.  NONE if there is none.
// sampled: for a ray that illums stop (emission.h).
FN uint distant_at(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 dir, int sampled) {
    uint glow = NONE;
    for (UNIFORM uint i = 0u; i < par->distant_count; i++) {
        GLOBAL const Distant* distant = &s->distant[i];
        float cap = distant->cap;
        float3 d = f3_of(distant->dir);
        // 1 - cos by the chord: single precision would lose a sun of half a degree in 1 - dot
        float3 e = sub3(dir, d);
        if (0.5f * dot3(e, e) > cap || (distant->seen == NONE && !sampled)) continue;
        if (distant->source != NONE) return i;
        if (glow == NONE) glow = i;
    }

    return glow;
}
#endif
