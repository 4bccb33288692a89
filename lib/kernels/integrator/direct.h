// SPDX-License-Identifier: BSD-3-Clause
// Direct light: one active source, one point on it, one shadow ray (shadow.h follows it later).
#ifndef LUX_PATH_DIRECT_H
#define LUX_PATH_DIRECT_H

// Response of the lobes to light from the sampled point: outgoing radiance over the source's.
FN float3 direct_response(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const LightSample) light,
                          PRIVATE(Vertex) vertex) {
    PRIVATE(const Surface) g = &vertex->g;
    PRIVATE(const Lobes) lobes = &vertex->lobes;
    float w = light->w / light->pieces;
    float3 c;

    if ((lobes->flags & LOBE_ASHIK) != 0u) c = ashik_direct(lobes, g, light->dir, w);
    else if ((lobes->flags & LOBE_BSDF) != 0u) c = bsdf_direct(s, par, lobes, g, light->dir, w, &vertex->rnd);
    else if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) c = wgmd_direct(lobes, g, light->dir, w, par->dj);
    else c = lobes_direct(lobes, g, light->dir, w, par->dj);

    if ((lobes->flags & LOBE_FUNCTION) != 0u) c = add3(c, function_direct(s, par, lobes, g, light->dir, w));
    return scale3(c, light->pieces);
}

// Stores the shadow ray, which adds `radiance` if it is unoccluded, and `far` to the suffix vertex.
FN void direct_shadow_ray(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                          PRIVATE(const Vertex) vertex, uint source, PRIVATE(LightSample) light, float3 radiance,
                          float3 far) {
    PRIVATE(const Surface) g = &vertex->g;
    uint path = vertex->path;
    int above = dot3(light->dir, g->ng) > 0.0f;
    float3 start = bsdf_start(&vertex->lobes, g, above);
    float3 from = offset_ray(start, above ? g->ng : neg3(g->ng), g->rounding);

    if (!IS_DISTANT(light->dist)) {  // aimed again from its offset origin, or the source would shadow itself
        float3 to = sub3(scale3(light->dir, light->dist), sub3(from, start));
        to = way_before_source(s, &s->sources[source], from, to);
        light->dist = length3(to);
        light->dir = scale3(to, 1.0f / MAX_(light->dist, 1e-9f));
    }

    write4_(paths->shadow_org, path, shadow_org_words(from, source));
    write4_(paths->shadow_dir, path, shadow_dir_words(light->dir, light->dist));
    write4_(paths->shadow_rad, path, shadow_rad_words(radiance, g->path_length));
    if (par->reuse_path_count != 0u)
        write4_(paths->shadow_suffix, path, shadow_suffix_words(far, vertex->at_suffix ? 1.0f : 0.0f));
    if (path_media_used(par)) {
        Medium there = above ? vertex->arriving : vertex->medium_behind;
        set_shadow_medium(paths, path, &there, above ? vertex->clip_before : vertex->clip_behind);
    }
}

// Returns PATH_SHADOW if a shadow ray was stored.
FN int path_direct(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                   PRIVATE(Vertex) vertex) {
    PRIVATE(const Surface) g = &vertex->g;
    if (!vertex->wanted || par->sources_count == 0u) return 0;

    // Source, chosen by importance at this point.  Where the medium scatters, it takes half of the shadow rays.
    uint source = 0u;
    int both = par->sources_count > 1u && lobes_transmit(&vertex->lobes);
    float inv_p = choose_source(s, par, g->p, g->n, both, &vertex->rnd, &source);
    float2 x = sample2(&vertex->rnd);
    if (vertex->went_to_medium) return 0;
    if (vertex->scatterers > 0u) inv_p *= 2.0f;
    if (!(inv_p > 0.0f)) return 0;

    // Point on the source, and the response of the surface.
    LightSample light;
    sample_source(s, par, source, g->p, x, par->dj, &light);
    if (!(light.w > 0.0f)) return 0;
    float3 response = direct_response(s, par, &light, vertex);
    if (!(max3(response) > 0.0f)) return 0;

    // Radiance of the source.  Where a pattern falls below 0, RADIANCE keeps light whose luminance is positive.  An
    // illum does not light itself.
    GLOBAL const Source* src = &s->sources[source];
    float3 radiance = sampled_radiance(s, par, src, &light, g->path_length, &vertex->rnd);
    int itself = src->prim == g->prim && src->relay == NONE;
    if (!(luminance3(mul3(response, radiance)) > 0.0f) || itself) return 0;

    radiance = scale3(radiance, inv_p);
    float3 far = F3(0.0f, 0.0f, 0.0f);
    if (vertex->at_suffix) {  // diffuse light goes to the whole group, the rest back along this path
        float3 even = scale3(lobes_even(&vertex->lobes, g, light.dir, light.w / light.pieces), light.pieces);
        far = mul3(even, radiance);
        response = sub3(response, even);
    }
    radiance = mul3(mul3(vertex->throughput, response), radiance);
    direct_shadow_ray(s, par, paths, vertex, source, &light, radiance, far);
    return PATH_SHADOW;
}
#endif
