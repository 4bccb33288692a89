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
    paths->rad[path] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);

    if (paths->dir[path].w == PILOT_FROM_EYE) {
        Ray ray;
        flags = 0u;
        float x = paths->org[path].x, y = paths->org[path].y;
        int has_ray = par->point_count > 0u ? point_ray(s, par, point_at(par, x, y), &ray)
                                            : view_lens_ray(par, x, y, F3(0.0f, 0.0f, 0.0f), &ray);
        image_way_start(par, paths, path, paths->org[path].z);
        paths->org[path] = pack4(ray.org, 0.0f);
        paths->dir[path] = pack4(ray.dir, ray.tmax);
        if (!has_ray) return 0;
    }

    path_start(par, paths, path, xyz4(paths->org[path]), &rnd, flags);
    return 1;
}

// At a diffuse bounce: the throughput of the light that the bounce would find.
FN_RARE void path_end_pilot(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    PRIVATE(const Surface) g = &vertex->g;
    uint path = vertex->path;
    float3 n = lobe->type == SAMPLE_DIFFUSE_R ? g->n : neg3(g->n);
    paths->org[path] = pack4(g->p, 0.0f);
    paths->dir[path] = pack4(n, PILOT_AT_BOUNCE);
    float share = lobe->prob > 0.0f ? lobe->total / lobe->prob : 0.0f;
    paths->throughput[path] = pack4(scale3(mul3(vertex->throughput, lobe->color), share), 0.0f);
    vertex_store(paths, vertex, vertex->path_length_start);
}
#endif
