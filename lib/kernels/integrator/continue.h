// SPDX-License-Identifier: BSD-3-Clause
// Continues a path along its sampled direction, or terminates it.
#ifndef LUX_PATH_CONTINUE_H
#define LUX_PATH_CONTINUE_H

// Russian roulette begins with the second diffuse bounce, or with this reflection where mirrors face each other
// (docs/decisions/0029-roulette.md).
#define RR_BOUNCES 2u
#define RR_LEVELS 13u
#define RR_START 0.05f      // it applies to a throughput below this
#define RR_EARLY 5u         // up to this bounce, and later
#define RR_START_LATE 0.5f  // below this
#define RR_LEAST 0.05f      // least survival probability

// Constant radiance that stands for deeper bounces (-av), where -ab ends the path.
FN void path_ambient_value(PARAMS(const Params) par, PRIVATE(Vertex) vertex) {
    if ((int)path_bounces(vertex->flags) < par->ab || !vertex->wanted) return;
    float3 av = f3_of(par->av);
    float3 value = mul3(add3(vertex->lobes.ambient_r, vertex->lobes.ambient_t), av);
    if (vertex->at_suffix) vertex->suffix_rad = add3(vertex->suffix_rad, value);
    else vertex_add(vertex, value);
}

// Limits of -lr and -lw.
FN int path_limited(PARAMS(const Params) par, PRIVATE(const Vertex) vertex) {
    int level = (int)path_level(vertex->flags);  // PC_MOST_LEVELS at most: a higher limit is none
    if (par->lr > 0) return level > par->lr || vertex->weight < par->lw;
    return par->lr < 0 && level > -par->lr;
}

// Russian roulette on the throughput without the weight of the direction just sampled.  A direction is likely where
// much light is expected, and its weight is small for this reason alone; earlier directions have already found their
// light, and a path with a large weight from them must not be amplified twenty-fold (spec shading 6).  Returns 0 if the
// path ends.
FN int path_roulette(PRIVATE(Vertex) vertex, float carried) {
    uint bounces = path_bounces(vertex->flags);
    float start = bounces > RR_EARLY ? RR_START_LATE : RR_START;
    if ((bounces < RR_BOUNCES && path_level(vertex->flags) < RR_LEVELS) || !(carried < start)) return 1;
    float prob = MAX_(carried / start, RR_LEAST);
    if (sample1(&vertex->rnd) >= prob) return 0;
    vertex->throughput = scale3(vertex->throughput, 1.0f / prob);
    return 1;
}

// Moves the path along its sampled lobe.  Returns PATH_CONTINUES, or 0 if the path ends.
FN int path_continue(PARAMS(const Params) par, TABLES(const Paths) paths, PRIVATE(Vertex) vertex,
                     PRIVATE(const LobeSample) lobe) {
    if (par->reuse_path_count != 0u) path_record_prefix(paths, vertex, lobe);
    vertex->weight *= MIN_(1.0f, max3(lobe->color));
    vertex->throughput = scale3(mul3(vertex->throughput, lobe->color), lobe->total / MAX_(lobe->prob, 1e-30f));
    float carried = max3(vertex->throughput);
    vertex->throughput = scale3(vertex->throughput, lobe->weight);

    int ends = lobe->weight <= 0.0f || max3(vertex->throughput) <= 0.0f || path_limited(par, vertex) ||
               !path_roulette(vertex, carried);
    vertex_store(paths, vertex, ends ? vertex->path_length_start : vertex->g.path_length);
    if (ends) return 0;

    PRIVATE(const Surface) g = &vertex->g;
    uint path = vertex->path;
    int above = dot3(lobe->dir, g->ng) > 0.0f;
    float3 from = offset_ray(bsdf_start(&vertex->lobes, g, above), above ? g->ng : neg3(g->ng), g->rounding);
    if (vertex->absorbs) {
        Medium there = lobe_reflects(lobe->type) ? vertex->arriving : vertex->medium_behind;
        set_path_medium(paths, path, &there);
    }
    write4_(paths->org, path, org_words(from, above ? vertex->clip_before : vertex->clip_behind));
    write4_(paths->dir, path, dir_words(lobe->dir, FAR_AWAY));
    write4_(paths->throughput, path, throughput_words(vertex->throughput, vertex->weight));
    return PATH_CONTINUES;
}
#endif
