// SPDX-License-Identifier: BSD-3-Clause
// The __kernel entries: each takes the buffers, finds its path and calls one stage of path.h.
// Queues: counters[0] paths to extend, [1] next queue, [2] shadow queue; a work item beyond the count leaves at once.

// Arguments of every kernel but k_swap and k_layout: the scene's tables, the parameters, the path state.
#define TABLE_ARG(type, name) __global const type *table_##name,
#define PATH_ARG(type, name, when, members) , __global type *path_##name
#define ALL_ARGS SCENE_TABLES(TABLE_ARG) __constant Params *par PATH_STATE(PATH_ARG)

#define TABLE_SET(type, name) s.name = table_##name;
#define PATH_SET(type, name, when, members) paths.name = path_##name;
#define SET_UP               \
    SceneTables s;           \
    Paths paths;             \
    SCENE_TABLES(TABLE_SET)  \
    PATH_STATE(PATH_SET)     \
    uint i = (uint)get_global_id(0);

// A place in a queue for each work item that needs one: a group increments the queue's counter once.  All work items
// must call this; group: two words.
static inline void push(int wanted, uint path, __global uint *counter, __global uint *queue, __local uint *group) {
    if (get_local_id(0) == 0) group[0] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    uint place = wanted ? atomic_inc(&group[0]) : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) group[1] = atomic_add(counter, group[0]);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (wanted) queue[group[1] + place] = path;
}

__kernel void k_generate(ALL_ARGS, __global uint *counters, __global uint *queue) {
    SET_UP
    __local uint group[2];
    push(i < par->path_count && path_generate(&s, par, &paths, i), i, &counters[0], queue, group);
}

__kernel void k_extend(ALL_ARGS, __global uint *counters, __global const uint *queue) {
    SET_UP
    if (i < counters[0]) path_extend(&s, par, &paths, queue[i]);
}

// Sorts the queue by kind (integrator/state.h), so that a group of work items takes the same branches: the number of
// each kind, its first place, and the place of each path.  A group has a work item for each kind.
__kernel void k_count_kinds(ALL_ARGS, __global const uint *counters, __global const uint *queue, __global uint *kinds) {
    SET_UP
    __local uint count[PATH_KINDS];
    uint mine = (uint)get_local_id(0);
    count[mine] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (i < counters[0]) atomic_inc(&count[path_kind(&s, &paths, queue[i])]);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (count[mine] > 0) atomic_add(&kinds[mine], count[mine]);
}

__kernel void k_begin_kinds(__global uint *kinds) {
    if (get_global_id(0) != 0) return;
    uint sum = 0;
    for (uint k = 0; k < PATH_KINDS; k++) {
        uint count = kinds[k];
        kinds[PATH_KINDS + k] = sum;
        sum += count;
        kinds[k] = 0;  // for the next round
    }
}

__kernel void k_sort_kinds(ALL_ARGS, __global const uint *counters, __global const uint *queue, __global uint *kinds,
                           __global uint *sorted) {
    SET_UP
    __local uint count[PATH_KINDS], first[PATH_KINDS];
    uint mine = (uint)get_local_id(0);
    count[mine] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    int active = i < counters[0];
    uint kind = active ? path_kind(&s, &paths, queue[i]) : 0;
    uint place = active ? atomic_inc(&count[kind]) : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (count[mine] > 0) first[mine] = atomic_add(&kinds[PATH_KINDS + mine], count[mine]);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (active) sorted[first[kind] + place] = queue[i];
}

__kernel void k_shade(ALL_ARGS, __global uint *counters, __global const uint *queue, __global uint *next,
                      __global uint *shadow) {
    SET_UP
    __local uint going_on[2], shadowed[2];
    int active = i < counters[0];
    uint path = active ? queue[i] : 0;
    int result = active ? path_shade(&s, par, &paths, path) : 0;
    push((result & PATH_CONTINUES) != 0, path, &counters[1], next, going_on);
    push((result & PATH_SHADOW) != 0, path, &counters[2], shadow, shadowed);
}

// Responses to the suns of many hours (integrator/hours.h), before k_shade: of each path of the queue and each sun 6
// floats, those of path_sun() times their weight.
__kernel void k_suns(ALL_ARGS, __global const uint *counters, __global const uint *queue, __global float *rows) {
    SET_UP
    if (i >= counters[0]) return;
    Vertex vertex;
    int lit = sun_vertex(&s, par, &paths, queue[i], &vertex);
    SunSampling sampling = sun_sampling(par, &vertex);
    int through = lit && lobes_transmit(&vertex.lobes);
    AskedSuns asked = asked_suns(&s, par, queue[i]);
    for (uint sun = 0; sun < par->suns_count && !asked.all; sun++)
        for (uint k = 0; k < 6; k++) rows[6 * ((size_t)i * par->suns_count + sun) + k] = 0.0f;
    for (uint k = 0; k < asked.count; k++) {
        uint sun = asked_sun(&s, &asked, k);
        float3 own = F3(0.0f, 0.0f, 0.0f), shared = own;
        if (lit && samples_sun(&sampling, &s.suns[sun])) {
            float3 way = sun_way(&s.suns[sun], sampling.place);
            if (through || dot3(way, vertex.g.ng) > 0.0f)
                path_sun(&s, par, &vertex, sun, unit3(way), SHADOW_TO_TRACE, &own, &shared);
        }
        size_t at = 2 * ((size_t)i * par->suns_count + sun);
        vstore3(scale3(own, (float)sampling.step), at, rows);
        vstore3(scale3(shared, (float)sampling.step), at + 1, rows);
    }
}

// What each path gets of the suffix vertices of a group (path_share_of_suffix).
__kernel void k_suffix_shares(ALL_ARGS, __global float4 *shares) {
    SET_UP
    if (i >= par->path_count) return;
    for (uint m = 0; m < REUSE_GROUP; m++)
        shares[(size_t)i * REUSE_GROUP + m] = path_share_of_suffix(par, &paths, i, m);
}

// Paths without a hit, if k_shade leaves them (HAS(SKY)): a sky may be a long program, which would cost registers for
// surfaces.
__kernel void k_sky(ALL_ARGS, __global uint *counters, __global const uint *queue) {
    SET_UP
    if (i < counters[0]) path_sky(&s, par, &paths, queue[i]);
}

__kernel void k_shadow(ALL_ARGS, __global uint *counters, __global const uint *shadow) {
    SET_UP
    if (i < counters[2]) path_shadow(&s, par, &paths, shadow[i], SHADOW_TO_TRACE);
}

__kernel void k_suffix_roulette(ALL_ARGS) {
    SET_UP
    if (i < par->path_count) path_suffix_roulette(par, &paths, reuse_first(i), reuse_which(i));
}

__kernel void k_connection(ALL_ARGS) {
    SET_UP
    if (i < par->path_count && CONNECTS_SUFFIX(&paths, i)) paths.connections[i] = connections_known(&s, par, &paths, i);
}

__kernel void k_transmittance(ALL_ARGS) {
    SET_UP
    if (i >= par->path_count || !CONNECTS_SUFFIX(&paths, i)) return;
    uint through = connections_to_attenuate(paths.connections[i], REUSE_FINDER(par, reuse_which(i)));
    for (uint m = 0; m < REUSE_GROUP; m++)
        if (through >> m & 1u) connection_transmittance(&s, par, &paths, i, m);
}

__kernel void k_connect(ALL_ARGS) {
    SET_UP
    if (i < par->path_count) path_connect(&s, par, &paths, reuse_first(i), reuse_which(i));
}

__kernel void k_normalise_mis(ALL_ARGS) {
    SET_UP
    if (i < par->path_count && CONNECTS_SUFFIX(&paths, i)) path_normalise_mis(&paths, i);
}

__kernel void k_gather(ALL_ARGS) {
    SET_UP
    if (i < par->path_count) path_gather(&paths, reuse_first(i), reuse_which(i));
}

// Radiance of the paths, in the film's layout.
__kernel void k_film(__constant Params *par, __global const float4 *rad, __global float *film) {
    uint i = (uint)get_global_id(0);
    if (i >= par->path_count) return;
    uint place = film_place(par, i);
    if (place != NONE) vstore3(rad[i].xyz, place, film);
}

// After a round: the next queue becomes the current one.
__kernel void k_swap(__global uint *counters) {
    if (get_global_id(0) == 0) {
        counters[0] = counters[1];
        counters[1] = 0;
        counters[2] = 0;
    }
}

__kernel void k_splat(ALL_ARGS) {
    SET_UP
    if (i >= par->path_count) return;
    path_splat(&s, par, &paths, i);
    path_shadow(&s, par, &paths, i, SHADOW_TO_TRACE);
}

__kernel void k_pilot(ALL_ARGS, __global uint *counters, __global uint *queue) {
    SET_UP
    __local uint group[2];
    push(i < par->path_count && path_begin_pilot(&s, par, &paths, i), i, &counters[0], queue, group);
}

__kernel void k_layout(__global uint *sizes) {
    if (get_global_id(0) == 0) record_sizes(sizes);
}

__kernel void k_self_test(__global float *out) {
    uint i = (uint)get_global_id(0);
    if (i < SELF_TEST_INPUTS * SELF_TEST_VALUES) out[i] = self_test_value(i / SELF_TEST_VALUES, i % SELF_TEST_VALUES);
}
