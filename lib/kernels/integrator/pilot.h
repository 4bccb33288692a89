// SPDX-License-Identifier: BSD-3-Clause
// MODE_PILOT, by which shares of aimed directions are found (sampling/mixture_weights.h): a path from a ray that the
// host gives up to where the next diffuse bounce would begin.
#ifndef LUX_PATH_PILOT_H
#define LUX_PATH_PILOT_H

// org and dir of the slot hold the ray; 1 if there is one.
FN_RARE int path_begin_pilot(PARAMS(const Params) par, TABLES(const Paths) paths, uint slot) {
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, par->first + slot, par->frame, 3u);
    uint flags = PC_DIFFUSE | (1u << PC_AB_SHIFT);
    paths->rad[slot] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);

    if (paths->dir[slot].w == PILOT_FROM_EYE) {
        Ray ray;
        flags = 0u;
        int has_ray = view_lens_ray(par, paths->org[slot].x, paths->org[slot].y, F3(0.0f, 0.0f, 0.0f), &ray);
        paths->org[slot] = pack4(ray.org, 0.0f);
        paths->dir[slot] = pack4(ray.dir, ray.tmax);
        if (!has_ray) return 0;
    }

    path_start(par, paths, slot, xyz4(paths->org[slot]), &rnd, flags);
    return 1;
}

// The walk has come to a diffuse bounce: what the surface makes of the light that the bounce would find.
FN_RARE void path_end_pilot(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) way) {
    PRIVATE(const Surface) g = &vertex->g;
    uint slot = vertex->slot;
    float3 n = way->way == SAMPLE_DIFFUSE_R ? g->n : neg3(g->n);
    paths->org[slot] = pack4(g->p, 0.0f);
    paths->dir[slot] = pack4(n, PILOT_AT_BOUNCE);
    float share = way->chance > 0.0f ? way->sum / way->chance : 0.0f;
    paths->thr[slot] = pack4(scale3(mul3(vertex->thr, way->color), share), 0.0f);
    vertex_store(paths, vertex, vertex->before);
}
#endif
