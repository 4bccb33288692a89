// SPDX-License-Identifier: BSD-3-Clause
// Single scattering of the light sources that mists name (spec: RADIANCE shading 3.9).
#ifndef LUX_PATH_SCATTER_H
#define LUX_PATH_SCATTER_H

// Number of sources that a medium scatters.
FN uint scattered_count(TABLES(const SceneTables) s, PRIVATE(const Medium) medium) {
    uint count = 0u;
    if (medium->lights == 0u || max3(mul3(medium->k, medium->albedo)) <= 0.0f) return 0u;
    for (uint set = 0u, left = medium->lights; left != 0u; set++, left >>= 1)
        if ((left & 1u) != 0u) count += s->light_sets[set].count;
    return count;
}

FN uint scattered_source(TABLES(const SceneTables) s, uint lights, uint pick) {
    for (uint set = 0u, left = lights; left != 0u; set++, left >>= 1) {
        GLOBAL const LightSet* named = &s->light_sets[set];
        if ((left & 1u) == 0u) continue;
        if (pick < named->count) return s->u[named->at + pick];
        pick -= named->count;
    }

    return NONE;
}

// Single scattering along the ray to the vertex, through the medium m: a random point on the ray, a random source, and
// the phase function of Henyey and Greenstein.  x, y: random numbers, x.x in .5 .. 1, because half of the steps do this
// and half light the surface.  Returns PATH_SHADOW if a shadow ray was stored.
FN int path_scatter(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                    PRIVATE(const Medium) medium, float2 x, float2 y, PRIVATE(Vertex) vertex) {
    float count = (float)vertex->scatterers, length = vertex->g.length;
    uint pick = (uint)((2.0f * x.x - 1.0f) * count);
    uint source = scattered_source(s, medium->lights, MIN_(pick, vertex->scatterers - 1u));

    float t = x.y * length;
    float path_length = vertex->path_length_start + t;
    float3 p = madd3(vertex->ray.dir, t, vertex->ray.org);
    LightSample light;
    sample_source(s, par, source, p, y, par->dj, &light);
    if (light.w <= 0.0f) return 0;
    float3 radiance = sampled_radiance(s, par, &s->sources[source], &light, path_length, &vertex->rnd);

    float ecc = MAX_(medium->ecc, 0.0f);  // RADIANCE treats a negative value as 0
    float c = dot3(light.dir, vertex->ray.dir);
    float d = 1.0f + ecc * ecc - 2.0f * ecc * c;
    float phase = (1.0f - ecc * ecc) / (d * sqrt_(d)) * 0.0795774715f;
    float3 w =
        mul3(mul3(mul3(medium->k, medium->albedo), attenuation(medium->k, t)), mul3(vertex->throughput, radiance));
    w = scale3(w, 2.0f * count * length * phase * light.w);
    if (max3(w) <= 0.0f) return 0;

    paths->shadow_org[vertex->path] = shadow_org_words(p, source);
    if (!IS_DISTANT(light.dist)) {
        float3 way = way_before_source(s, &s->sources[source], p, scale3(light.dir, light.dist));
        light.dist = length3(way);
        light.dir = unit3(way);
    }
    paths->shadow_dir[vertex->path] = shadow_dir_words(light.dir, light.dist);
    paths->shadow_rad[vertex->path] = shadow_rad_words(w, path_length);
    if (par->reuse_path_count != 0u)
        write4_(paths->shadow_suffix, vertex->path, shadow_suffix_words(F3(0.0f, 0.0f, 0.0f), 0.0f));
    set_shadow_medium(paths, vertex->path, medium, vertex->clip_before);
    return PATH_SHADOW;
}
#endif
