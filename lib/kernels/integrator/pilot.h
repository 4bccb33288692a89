// SPDX-License-Identifier: BSD-3-Clause
// MODE_PILOT: pilot paths, from which sampling/mixture_weights.h estimates the mixture weights.  Follows a ray given by
// the host up to its next diffuse bounce.
#ifndef LUX_PATH_PILOT_H
#define LUX_PATH_PILOT_H

// The path's org and dir hold the ray; returns 1 if there is one.
FN_RARE int path_begin_pilot(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                             uint path) {
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, par->first + path, par->frame, 3u);
    uint flags = PC_DIFFUSE | (1u << PC_AB_SHIFT);
    paths->rad[path] = rad_words(F3(0.0f, 0.0f, 0.0f), 0.0f);

    if (dir_length(paths->dir[path]) == PILOT_FROM_EYE) {
        Ray ray;
        float3 place = xyz4(paths->org[path]);
        ray.org = place;  // gcc's -Wmaybe-uninitialized does not see that a ray has an origin
        flags = 0u;
        int has_ray = par->points_count > 0u ? point_ray(s, point_at(par, place.x, place.y), &ray)
                                             : view_lens_ray(par, place.x, place.y, F3(0.0f, 0.0f, 0.0f), &ray);
        image_way_start(par, paths, path, place.z);
        if (!has_ray) return 0;
        paths->org[path] = org_words(ray.org, 0u);
        paths->dir[path] = dir_words(ray.dir, ray.tmax);
    }

    path_start(par, paths, path, xyz4(paths->org[path]), &rnd, flags);
    return 1;
}

// At a diffuse bounce: the throughput of the light that the bounce would find.
FN_RARE void path_end_pilot(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    PRIVATE(const Surface) g = &vertex->g;
    uint path = vertex->path;
    float3 n = lobe->type == SAMPLE_DIFFUSE_R ? g->n : neg3(g->n);
    paths->org[path] = org_words(g->p, 0u);
    paths->dir[path] = dir_words(n, PILOT_AT_BOUNCE);
    float share = lobe->prob > 0.0f ? lobe->total / lobe->prob : 0.0f;
    paths->throughput[path] = throughput_words(scale3(mul3(vertex->throughput, lobe->color), share), 0.0f);
    vertex_store(paths, vertex, vertex->path_length_start);
}
#endif
