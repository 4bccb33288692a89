// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the hit of a ray: a surface that it passes, an emitter, or a surface that scatters light by its lobes.
#ifndef LUX_PATH_HIT_H
#define LUX_PATH_HIT_H

// Sets position, normal and modifier of the hit, and counts it.  Returns 0 beyond the limit of hits per path.
FN int vertex_arrive(TABLES(const SceneTables) s, PRIVATE(Vertex) vertex) {
    if (path_steps(vertex->flags) >= PC_STEP_LIMIT) return 0;
    vertex->flags += 1u << PC_STEP_SHIFT;
    surface_at(s, &vertex->ray, &vertex->hit, &vertex->g);
    vertex->g.path_length = vertex->path_length_start + vertex->hit.t;
    return 1;
}

// A white surface that turns irradiance into radiance.
FN void lobes_of_sensor(PRIVATE(Lobes) lobes) {
    lobes_clear(lobes);
    lobes->diffuse_r = F3(K_PI, K_PI, K_PI);
    lobes->ambient_r = lobes->diffuse_r;
}

// Begins the path on the sensor from which its ray looks back.
FN int vertex_sensor(PRIVATE(Vertex) vertex) {
    PRIVATE(Surface) g = &vertex->g;
    vertex->flags += 1u << PC_STEP_SHIFT;
    surface_plain(ON_SENSOR, NONE, NO_HIT, 0.0f, g);
    g->p = vertex->ray.org;
    g->v = neg3(vertex->ray.dir);
    g->nface = g->ng = g->n = g->v;
    g->color_before = g->color;
    g->pert_before = g->pert;
    g->rounding = 0.0f;  // it lies above the surface already
    g->path_length = vertex->path_length_start;
    g->type = M_PLASTIC;
    g->front = g->flat = 1;
    lobes_of_sensor(&vertex->lobes);
    return HIT_SURFACE;
}

// -i: the first surface that the eye sees is white and Lambertian, so that its radiance is its irradiance.
FN int irradiance_surface(TABLES(const SceneTables) s, TABLES(const Paths) paths, int passes, PRIVATE(Vertex) vertex) {
    // the material's own media do not apply
    if (vertex->absorbs) vertex->arriving = path_medium(paths, vertex->path);
    vertex->medium_behind = vertex->arriving;
    if (passes || (s->modifiers[vertex->g.mod].flags & MF_SEEN_THROUGH) != 0u) return HIT_NULL;

    vertex->g.pert = vertex->g.pert_before;  // the white surface in its place has no texture of its own
    shading_normal(&vertex->g);
    lobes_of_sensor(&vertex->lobes);
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

// Returns HIT_NULL, HIT_EMITTER or HIT_SURFACE.
FN int vertex_hit(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                  PRIVATE(Vertex) vertex) {
    PRIVATE(Surface) g = &vertex->g;
    int antimatter = has_antimatter(par);
    uint carried = g->mod;

    // a hole cut by antimatter; a chain without material; an illum or mirror whose alternate is void
    if (antimatter && clip_hit(s, g, &vertex->clip_behind) == CLIP_IGNORE) return HIT_NULL;
    if (!find_material(s, par, g, &vertex->rnd)) return HIT_NULL;
    if (take_alternate(s, par, g, vertex->flags, &vertex->rnd)) return HIT_NULL;

    if (material_has(g->type, MT_EMISSIVE) != 0u) {
        int passes;
        vertex->emitted = emitter_radiance(s, par, g, vertex->flags, &passes);
        return passes ? HIT_NULL : HIT_EMITTER;
    }

    int kind = vertex_lobes(s, par, vertex);
    if (antimatter) clip_turned(s, par, g, carried, &vertex->clip_behind);
    if ((par->flags & PF_IRRADIANCE) == 0u || path_sampled(vertex->flags) || (vertex->flags & PC_BENT) != 0u)
        return kind;
    return irradiance_surface(s, paths, kind == HIT_NULL, vertex);
}

// Ends the path at an emitter.
FN void path_hit_emitter(TABLES(const Paths) paths, PRIVATE(Vertex) vertex) {
    if (vertex->wanted) vertex_add(vertex, vertex->emitted);
    vertex_store_rad(paths, vertex, vertex->path_length_start);
}

// Null surface: continues the ray in the same direction.
FN void path_pass(TABLES(const Paths) paths, PRIVATE(Vertex) vertex) {
    PRIVATE(const Surface) g = &vertex->g;
    float left = IS_DISTANT(vertex->ray.tmax) ? FAR_AWAY : vertex->ray.tmax - vertex->hit.t;
    uint path = vertex->path;

    vertex_store(paths, vertex, g->path_length);
    if (vertex->absorbs) set_path_medium(paths, path, &vertex->medium_behind);
    write4_(paths->throughput, path, throughput_words(vertex->throughput, vertex->weight));
    write4_(paths->org, path, org_words(offset_ray(g->p, neg3(g->ng), g->rounding), vertex->clip_behind));
    write4_(paths->dir, path, dir_words(vertex->ray.dir, left));
}
#endif
