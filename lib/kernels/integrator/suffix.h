// SPDX-License-Identifier: BSD-3-Clause
// Path reuse (path_reuse.h).  The prefix vertex of a path is the point where it first leaves, by a diffuse ray, a
// surface that the eye sees directly or through panes.  The suffix vertex is the hit of that ray, directly or through
// panes, if it sends the same radiance in all directions: the sky, an emitter, a diffuse surface.  The suffix vertex
// lights the prefix vertices of the whole group (connect.h).
#ifndef LUX_PATH_SUFFIX_H
#define LUX_PATH_SUFFIX_H

// Returns 1 if the surface or one of its modifiers depends on how it is seen.  on: MF_LOOKS or MF_TOTAL.
FN int surface_depends(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, uint on) {
    uint mod = s->prims[PRIM_WORDS * g->prim + PRIM_MOD];
    if (in_instance(g->inst)) {
        uint of_all = as_uint_(*(instance_record(s, g->inst) + INST_MOD));
        if (of_all != NONE) mod = of_all;
    }
    return (mod_word(s, par, mod, MOD_FLAGS) & on) != 0u;
}

// Plain pane, through which a connection may pass.  A connection knows its direction and length, but not the distance
// to the eye.
FN int is_pane(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g) {
    return g->type == M_GLASS && !g->mixed && (g->smooth || !is_textured(g)) && !surface_depends(s, par, g, MF_TOTAL);
}

// Probability that a path passes a pane rather than being reflected.
FN float pane_prob(PRIVATE(const Lobes) lobes) {
    float through = max3(lobes->through), mirror = max3(lobes->mirror);
    through = through > 0.0f ? through : 0.0f;
    mirror = mirror > 0.0f ? mirror : 0.0f;
    return through > 0.0f ? through / (through + mirror) : 0.0f;
}

// Returns 1 if a part of the scattered light is the same in all directions.
FN int scatters_evenly(PRIVATE(const Surface) g, PRIVATE(const Lobes) lobes) {
    if (material_has(g->type, MT_EVEN) == 0u || is_textured(g)) return 0;
    if ((lobes->flags & LOBE_FRESNEL) != 0u || max3(lobes->through) > 0.0f) return 0;
    return max3(add3(lobes->diffuse_r, lobes->diffuse_t)) > 0.0f;
}

FN void suffix_point(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex) {
    PRIVATE(const Surface) g = &vertex->g;
    write4_(paths->suffix_p, vertex->path, pack4(g->p, SUFFIX_POINT));
    write4_(paths->suffix_n, vertex->path, pack4(g->ng, g->rounding));
}

// A path without a suffix vertex has hit a surface.
FN void path_record_suffix(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                           PRIVATE(Vertex) vertex, int kind) {
    PRIVATE(const Surface) g = &vertex->g;
    if (kind == HIT_SURFACE && is_pane(s, par, g)) return;
    vertex->flags &= ~PC_RECORDS_SUFFIX;
    if (kind == HIT_NULL || surface_depends(s, par, g, MF_LOOKS)) return;

    if (kind == HIT_SURFACE) {
        if (!scatters_evenly(g, &vertex->lobes)) return;
        vertex->at_suffix = 1;
        suffix_point(paths, vertex);
        return;
    }

    // an emitter; the radiance of a glow with a radius depends on the distance
    GLOBAL const float* arg = s->f + mod_word(s, par, g->mod, MOD_ARGS);
    if (!vertex->wanted || g->mixed || (g->type == M_GLOW && arg[3] > 0.0f)) return;
    suffix_point(paths, vertex);
    write4_(paths->suffix_rad, vertex->path, pack4(vertex->emitted, vertex->path_length_start));
    vertex->emitted = F3(0.0f, 0.0f, 0.0f);
}

// A path without a suffix vertex has left the scene.
FN void suffix_sky(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, float3 radiance) {
    write4_(paths->suffix_p, vertex->path, pack4(vertex->ray.dir, SUFFIX_DIRECTION));
    write4_(paths->suffix_rad, vertex->path, pack4(radiance, vertex->path_length_start));
}

// Adds the light of the shadow ray of the last step; T: its transmittance.
FN void path_receive(PARAMS(const Params) par, TABLES(const Paths) paths, uint path, float3 light, float3 T) {
    if (par->reuse_path_count != 0u) {
        float4 even = read4_(paths->shadow_suffix, path), far = read4_(paths->suffix_rad, path);
        int at_suffix = even.w > 0.0f;
        if (at_suffix || (paths->info[path].x & PC_SUFFIX) != 0u)
            write4_(paths->suffix_rad, path, pack4(add3(xyz4(far), at_suffix ? mul3(xyz4(even), T) : light), far.w));
        if (!at_suffix && (paths->info[path].x & PC_SUFFIX) != 0u) return;
    }
    float4 sum = read4_(paths->rad, path);
    write4_(paths->rad, path, pack4(add3(xyz4(sum), light), sum.w));
}
#endif
