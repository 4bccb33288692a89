// SPDX-License-Identifier: BSD-3-Clause
// Whether a path that has chosen its way takes it; and its next ray.
#ifndef LUX_PATH_END_H
#define LUX_PATH_END_H

#define RR_START 0.05f  // roulette sets in where a path carries less
#define RR_LEAST 0.05f  // least chance to survive it

// The constant that stands for light of deeper bounces (-av), where -ab ends.
FN void path_ambient_value(PARAMS(const Params) par, PRIVATE(Vertex) vertex) {
    int bounces = (int)((vertex->flags >> PC_AB_SHIFT) & 255u);
    if (bounces < par->ab || !vertex->wanted) return;
    float3 av = F3(par->av.x, par->av.y, par->av.z);
    float3 value = mul3(add3(vertex->lobes.ambient_r, vertex->lobes.ambient_t), av);
    if (vertex->at_suffix) vertex->suffix_rad = add3(vertex->suffix_rad, value);
    else vertex_add(vertex, value);
}

// The limits of -lr and -lw.
FN int path_limited(PARAMS(const Params) par, PRIVATE(const Vertex) vertex) {
    int level = (int)((vertex->flags >> PC_LEVEL_SHIFT) & 255u);
    if (par->lr > 0) return level > par->lr || vertex->weight < par->lw;
    return par->lr < 0 && level > -par->lr;
}

// Russian roulette on what the path carries: its throughput, but for the direction that it now takes.  That one is
// likely where much light is expected, and has a small factor for that alone; but directions of earlier bounces have
// found what they were to find, and a path that carries much for them must not be made to carry twenty times as much
// (spec shading 6).  0: the path ends.
FN int path_roulette(PRIVATE(Vertex) vertex, float carried) {
    uint bounces = (vertex->flags >> PC_AB_SHIFT) & 255u;
    if (bounces < 2u || !(carried < RR_START)) return 1;
    float chance = MAX_(carried / RR_START, RR_LEAST);
    if (sample1(&vertex->rnd) >= chance) return 0;
    vertex->thr = scale3(vertex->thr, 1.0f / chance);
    return 1;
}

// The path takes its way.  Returns PATH_GOES_ON, or 0 if it ends.
FN int path_go_on(PARAMS(const Params) par, TABLES(const Paths) paths, PRIVATE(Vertex) vertex,
                  PRIVATE(const LobeSample) way) {
    if (par->reuse_slot_count != 0u) path_ends(paths, vertex, way);
    vertex->weight *= MIN_(1.0f, max3(way->color));
    vertex->thr = scale3(mul3(vertex->thr, way->color), way->sum / MAX_(way->chance, 1e-30f));
    float carried = max3(vertex->thr);
    vertex->thr = scale3(vertex->thr, way->factor);

    int ends = way->factor <= 0.0f || max3(vertex->thr) <= 0.0f || path_limited(par, vertex) ||
               !path_roulette(vertex, carried);
    vertex_store(paths, vertex, ends ? vertex->before : vertex->g.total);
    if (ends) return 0;

    PRIVATE(const Surface) g = &vertex->g;
    uint slot = vertex->slot;
    int above = dot3(way->dir, g->ng) > 0.0f;
    float3 from = offset_ray(bsdf_start(&vertex->lobes, g, above), above ? g->ng : neg3(g->ng), g->reach);
    if (vertex->absorbs) {
        Medium there = lobe_reflects(way->way) ? vertex->arriving : vertex->beyond;
        set_path_medium(paths, slot, &there);
    }
    write4_(paths->org, slot, pack4(from, as_float_(above ? vertex->clip_before : vertex->clip_beyond)));
    write4_(paths->dir, slot, pack4(way->dir, FAR_AWAY));
    write4_(paths->thr, slot, pack4(vertex->thr, vertex->weight));
    return PATH_GOES_ON;
}
#endif
