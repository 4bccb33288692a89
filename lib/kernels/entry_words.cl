// SPDX-License-Identifier: BSD-3-Clause
// What all __kernel entries begin with: each takes the buffers, finds its slot and calls one stage of path.h.
// Queues: counters[0] paths to extend, [1] next queue, [2] shadow queue, [3] shadow rays that are left to another
// kernel, [4] those whose lamp has patterns; a work item beyond the count leaves at once.

// Arguments of every kernel but k_swap and k_layout: the scene's tables, the parameters, the path state.
#define TABLE_ARG(type, name) __global const type *table_##name,
#define PATH_ARG(type, name, when) , __global type *path_##name
#define ALL_ARGS SCENE_TABLES(TABLE_ARG) __constant Params *par PATH_STATE(PATH_ARG)

#define TABLE_SET(type, name) s.name = table_##name;
#define PATH_SET(type, name, when) paths.name = path_##name;
#define SET_UP               \
    SceneTables s;           \
    Paths paths;             \
    SCENE_TABLES(TABLE_SET)  \
    PATH_STATE(PATH_SET)     \
    uint i = (uint)get_global_id(0);

#define COUNTERS 5

// A place in a queue for each work item that wants one: a group of them asks the queue's counter once, not each.
// All work items must come here; group: two words.
static inline void push(int wanted, uint slot, __global uint *counter, __global uint *queue, __local uint *group) {
    if (get_local_id(0) == 0) group[0] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    uint place = wanted ? atomic_inc(&group[0]) : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) group[1] = atomic_add(counter, group[0]);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (wanted) queue[group[1] + place] = slot;
}

// The sources that are drawn into frame 0: in both programs, of which that runs it that walks chains.
__kernel void k_draw(ALL_ARGS) {
    SET_UP
    if (i >= par->slots) return;
    path_draw(&s, par, &paths, i);
    path_shadow(&s, par, &paths, i, SHADOW_TO_TRACE);
}
