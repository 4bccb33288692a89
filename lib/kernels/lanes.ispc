// SPDX-License-Identifier: BSD-3-Clause
// Stages of path.h for a row of slots, as many side by side as there are lanes (device/cpu_kernels.inl calls these).
#include "kernels/dialect/compat_lanes.isph"
#include "kernels/all.h"

// result: of slots 0 .. n-1, that of path_generate.
export void LANE_CALL(generate)(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths,
                                uniform uint n, uniform int* uniform result) {
    foreach (i = 0 ... n) result[i] = path_generate(s, par, paths, i);
}

// result: of each slot of the queue, that of path_shade.
export void LANE_CALL(shade)(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths,
                             const uniform uint* uniform queue, uniform uint n, uniform int* uniform result) {
    foreach (i = 0 ... n) result[i] = path_shade(s, par, paths, queue[i]);
}

// known: what is known of each slot's shadow ray (integrator/shadow.h).
export void LANE_CALL(shadow)(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths,
                              const uniform uint* uniform queue, uniform uint n, const uniform int* uniform known) {
    foreach (i = 0 ... n) path_shadow(s, par, paths, queue[i], known[i]);
}

// Of each member of the groups of a square, one group after another.
#define OF_GROUPS(stage)                                        \
    for (uniform uint group = 0; group < SHARE_GROUPS; group++) \
        foreach (which = 0 ... SHARE_GROUP) stage

export void LANE_CALL(thin)(SHARED(const Paths) paths) { OF_GROUPS(path_thin(paths, SHARE_FIRST(group), which)); }

// links: slots and members of their groups, slot * SHARE_GROUP + member.
export void LANE_CALL(look_through)(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths,
                                    const uniform uint* uniform links, uniform uint n) {
    foreach (i = 0 ... n) path_look_through(s, par, paths, links[i] / SHARE_GROUP, links[i] % SHARE_GROUP);
}

export void LANE_CALL(connect)(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths) {
    OF_GROUPS(path_connect(s, par, paths, SHARE_FIRST(group), which));
}

export void LANE_CALL(weigh)(SHARED(const Paths) paths, const uniform uint* uniform queue, uniform uint n) {
    foreach (i = 0 ... n) path_weigh(paths, queue[i]);
}

export void LANE_CALL(collect)(SHARED(const Paths) paths) {
    OF_GROUPS(path_collect(paths, SHARE_FIRST(group), which));
}
