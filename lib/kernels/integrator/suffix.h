// SPDX-License-Identifier: BSD-3-Clause
// Path reuse (path_reuse.h).  The prefix vertex of a path is the point where it first leaves, by a diffuse ray, a
// surface that the eye sees directly or through panes.  The suffix vertex is the hit of that ray, directly or through
// panes, if it sends the same radiance in all directions: the sky, an emitter, a diffuse surface.  The suffix vertex
// lights the prefix vertices of the whole group (connect.h).
#ifndef LUX_PATH_SUFFIX_H
#define LUX_PATH_SUFFIX_H

// Returns 1 if the surface or one of its modifiers depends on how it is seen.  on: MF_LOOKS or MF_TOTAL.
FN int surface_depends(TABLES(const SceneTables) s, PRIVATE(const Surface) g, uint on) {
    uint mod = s->prims[g->prim].mod;
    if (in_instance(g->inst)) {
        uint of_all = s->instances[g->inst].mod;
        if (of_all != NONE) mod = of_all;
    }
    return (s->modifiers[mod].flags & on) != 0u;
}

// Plain pane, through which a connection may pass.  A connection knows its direction and length, but not the distance
// to the eye.
FN int is_pane(TABLES(const SceneTables) s, PRIVATE(const Surface) g) {
    return g->type == M_GLASS && !g->mixed && (g->smooth || !is_textured(g)) && !surface_depends(s, g, MF_TOTAL);
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

// Returns 1 if a suffix vertex on this surface sends the same radiance everywhere.
FN int is_even_suffix(TABLES(const SceneTables) s, PRIVATE(const Surface) g, PRIVATE(const Lobes) lobes) {
    return !surface_depends(s, g, MF_LOOKS) && scatters_evenly(g, lobes);
}

FN void suffix_point(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex) {
    PRIVATE(const Surface) g = &vertex->g;
    write4_(paths->suffix_p, vertex->path, suffix_p_words(g->p, SUFFIX_POINT));
    write4_(paths->suffix_n, vertex->path, suffix_n_words(g->ng, g->rounding));
}

// A path without a suffix vertex has hit a surface.
FN void path_record_suffix(TABLES(const SceneTables) s, TABLES(const Paths) paths, PRIVATE(Vertex) vertex, int kind) {
    PRIVATE(const Surface) g = &vertex->g;
    if (kind == HIT_SURFACE && is_pane(s, g)) return;
    vertex->flags &= ~PC_RECORDS_SUFFIX;
    if (kind == HIT_SURFACE) {
        if (!is_even_suffix(s, g, &vertex->lobes)) return;
        vertex->at_suffix = 1;
        suffix_point(paths, vertex);
        return;
    }

    // an emitter; the radiance of a glow with a radius depends on the distance
    if (kind == HIT_NULL || surface_depends(s, g, MF_LOOKS)) return;
    GLOBAL const float* arg = s->f + s->modifiers[g->mod].args;
    if (!vertex->wanted || g->mixed || (g->type == M_GLOW && arg[3] > 0.0f)) return;
    suffix_point(paths, vertex);
    write4_(paths->suffix_rad, vertex->path, suffix_rad_words(vertex->emitted, vertex->path_length_start));
    vertex->emitted = F3(0.0f, 0.0f, 0.0f);
}

// A path without a suffix vertex has left the scene.
FN void suffix_sky(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, float3 radiance) {
    write4_(paths->suffix_p, vertex->path, suffix_p_words(vertex->ray.dir, SUFFIX_DIRECTION));
    write4_(paths->suffix_rad, vertex->path, suffix_rad_words(radiance, vertex->path_length_start));
}

// Adds the light of the shadow ray of the last step; T: its transmittance.
FN void path_receive(PARAMS(const Params) par, TABLES(const Paths) paths, uint path, float3 light, float3 T) {
    if (par->reuse_path_count != 0u) {
        Row_shadow_suffix even = shadow_suffix_of(read4_(paths->shadow_suffix, path));
        Row_suffix_rad far = suffix_rad_of(read4_(paths->suffix_rad, path));
        int at_suffix = even.there > 0.0f;
        uint flags = info_flags(paths->info[path]);
        if (at_suffix || (flags & PC_SUFFIX) != 0u) {
            float3 more = at_suffix ? mul3(even.rgb, T) : light;
            write4_(paths->suffix_rad, path, suffix_rad_words(add3(far.rgb, more), far.path_length));
        }
        if (!at_suffix && (flags & PC_SUFFIX) != 0u) return;
    }
    Row_rad sum = rad_of(read4_(paths->rad, path));
    write4_(paths->rad, path, rad_words(add3(sum.rgb, light), sum.path_length));
}
#endif
