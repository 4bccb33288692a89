// SPDX-License-Identifier: BSD-3-Clause
// What the ray has met: nothing that shows, an emitter, or a surface that scatters light by its lobes.
#ifndef LUX_PATH_HIT_H
#define LUX_PATH_HIT_H

// Position, normal and modifier of the hit; counts it.  0: the path has met more surfaces than it may.
FN int vertex_arrive(TABLES(const SceneTables) s, PRIVATE(Vertex) vertex) {
    if (vertex->flags >> PC_STEP_SHIFT >= PC_STEP_LIMIT) return 0;
    vertex->flags += 1u << PC_STEP_SHIFT;
    surface_at(s, &vertex->ray, &vertex->hit, &vertex->g);
    vertex->g.path_length = vertex->path_length_start + vertex->hit.t;
    return 1;
}

// -i: the first surface that the eye sees is white and Lambertian, so that its radiance is the irradiance there.
FN int irradiance_surface(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, int passes,
                          PRIVATE(Vertex) vertex) {
    // what the material knows of media does not count
    if (vertex->absorbs) vertex->arriving = path_medium(paths, vertex->path);
    vertex->medium_behind = vertex->arriving;
    if (passes || (mod_word(s, par, vertex->g.mod, MOD_FLAGS) & MF_SEEN_THROUGH) != 0u) return HIT_NULL;

    vertex->g.pert = vertex->g.pert_before;  // the white surface in its place has no texture of its own
    shading_normal(&vertex->g);
    lobes_clear(&vertex->lobes);
    vertex->lobes.diffuse_r = F3(K_PI, K_PI, K_PI);
    vertex->lobes.ambient_r = vertex->lobes.diffuse_r;
    return HIT_SURFACE;
}

FN int vertex_lobes(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Vertex) vertex) {
    PRIVATE(Surface) g = &vertex->g;
    if (HAS(SOLIDS) && g->type == M_MIST) {
        mist_crossing(s, par, g, &vertex->arriving, &vertex->medium_behind);
        return HIT_NULL;
    }

    int asked = path_sampled(vertex->flags) ? LOBES_SAMPLED : LOBES_EYE;
    material_lobes(s, par, g, asked, &vertex->rnd, &vertex->arriving, &vertex->medium_behind, &vertex->lobes);
    return (vertex->lobes.flags & LOBE_PASS) != 0u ? HIT_NULL : HIT_SURFACE;
}

// One of MET_*.
FN int vertex_hit(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                  PRIVATE(Vertex) vertex) {
    PRIVATE(Surface) g = &vertex->g;
    int antimatter = has_antimatter(par);
    uint carried = g->mod;

    // a hole that antimatter cuts; a chain without material; an illum or mirror with void in its place
    if (antimatter && clip_hit(s, par, g, &vertex->clip_behind) == CLIP_IGNORE) return HIT_NULL;
    if (!find_material(s, par, g, &vertex->rnd)) return HIT_NULL;
    if (take_alternate(s, par, g, vertex->flags, &vertex->rnd)) return HIT_NULL;

    if (material_has(g->type, MT_EMISSIVE) != 0u) {
        int passes;
        vertex->emitted = emitter_radiance(s, par, g, vertex->flags, &passes);
        return passes ? HIT_NULL : HIT_EMITTER;
    }

    int met = vertex_lobes(s, par, vertex);
    if (antimatter) clip_turned(s, par, g, carried, &vertex->clip_behind);
    if ((par->flags & PF_IRRADIANCE) == 0u || path_sampled(vertex->flags) || (vertex->flags & PC_BENT) != 0u)
        return met;
    return irradiance_surface(s, par, paths, met == HIT_NULL, vertex);
}

// The path ends in an emitter.
FN void path_hit_emitter(TABLES(const Paths) paths, PRIVATE(Vertex) vertex) {
    if (vertex->wanted) vertex_add(vertex, vertex->emitted);
    vertex_store_rad(paths, vertex, vertex->path_length_start);
}

// Straight on, as if nothing were there.
FN void path_pass(TABLES(const Paths) paths, PRIVATE(Vertex) vertex) {
    PRIVATE(const Surface) g = &vertex->g;
    float left = IS_DISTANT(vertex->ray.tmax) ? FAR_AWAY : vertex->ray.tmax - vertex->hit.t;
    uint path = vertex->path;

    vertex_store(paths, vertex, g->path_length);
    if (vertex->absorbs) set_path_medium(paths, path, &vertex->medium_behind);
    write4_(paths->throughput, path, pack4(vertex->throughput, vertex->weight));
    write4_(paths->org, path, pack4(offset_ray(g->p, neg3(g->ng), g->error_scale), as_float_(vertex->clip_behind)));
    write4_(paths->dir, path, pack4(vertex->ray.dir, left));
}
#endif
