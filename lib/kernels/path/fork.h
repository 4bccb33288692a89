// SPDX-License-Identifier: BSD-3-Clause
// A guided path forks at its first diffuse bounce: several sub-paths leave it one after another in the same slot, each
// with its share of the light.  The eye's ray and its shadow ray are traced once for all of them; roulette
// (path/ways.h) keeps the sub-paths short.
#ifndef LUX_PATH_FORK_H
#define LUX_PATH_FORK_H

FN uint path_forks_left(uint flags) { return (flags >> PC_FORK_SHIFT) & PC_FORK_MASK; }

// Keeps what the sub-paths begin with.  vertex: at its first bounce, the way chosen, the throughput not yet with the
// direction's factor.
FN void path_fork(SHARED(const Paths) paths, PRIVATE(Vertex) vertex, PRIVATE(const Way) way) {
    PRIVATE(const Surface) g = &vertex->g;
    uint slot = vertex->slot;
    int above = way->way == WAY_DIFFUSE_R;
    float3 n = above ? g->n : neg3(g->n), ng = above ? g->ng : neg3(g->ng);
    float3 from = offset_ray(bsdf_start(&vertex->lobes, g, above), ng, g->reach);

    vertex->thr = scale3(vertex->thr, 1.0f / (float)FORKS);
    vertex->flags |= (FORKS - 1u) << PC_FORK_SHIFT;
    paths->fork_org[slot] = pack4(from, as_float_(way->fork_dim));
    paths->fork_n[slot] = pack4(n, g->total);
    paths->fork_ng[slot] = pack4(ng, as_float_(vertex->flags));
    paths->fork_thr[slot] = pack4(vertex->thr, vertex->weight);
}

// The next sub-path that finds a direction.  Returns PATH_GOES_ON, or 0 if none is left.
FN int path_fork_again(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot) {
    uint4 info = paths->info[slot];
    uint left = path_forks_left(info.x);
    if (left == 0u) return 0;

    float4 org = paths->fork_org[slot], n4 = paths->fork_n[slot], ng4 = paths->fork_ng[slot],
           thr = paths->fork_thr[slot];
    float3 n = xyz4(n4);
    while (left > 0u) {
        left--;
        Sampler rnd = path_sampler(info);
        float3 dir;
        rnd.index = rnd.index - rnd.index % FORKS + (FORKS - 1u - left);
        rnd.dim = as_uint_(org.w);
        uint cell = guide_cell(s, par, xyz4(org), n, &rnd);
        float factor = guided_direction(s, par, cell, xyz4(org), n, &rnd, &dir);
        if (!(factor > 0.0f) || dot3(dir, xyz4(ng4)) <= 0.0f) continue;

        info.x = (as_uint_(ng4.w) & ~(PC_FORK_MASK << PC_FORK_SHIFT)) | left << PC_FORK_SHIFT;
        info.z = path_sampler_word(&rnd);
        paths->info[slot] = info;
        paths->org[slot] = pack4(xyz4(org), as_float_(CLIP_START));
        paths->dir[slot] = pack4(dir, FAR_AWAY);
        paths->thr[slot] = pack4(scale3(xyz4(thr), factor), thr.w);
        paths->rad[slot].w = n4.w;
        return PATH_GOES_ON;
    }

    return 0;
}
#endif
