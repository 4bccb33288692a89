// SPDX-License-Identifier: BSD-3-Clause
// Stages of path.h for a row of paths, one in each lane (called by device/cpu_kernels.inl).
#include "kernels/dialect/compat_lanes.isph"
#include "kernels/all.h"

// What C++ calls: without the copy of each function that ispc's own code could call, which takes as long to compile.
#if ISPC_MAJOR_VERSION > 1 || ISPC_MINOR_VERSION >= 26
#define EXPORT __attribute__((external_only)) export
#else
#define EXPORT export
#endif

EXPORT void LANE_CALL(layout)(uniform uint* uniform sizes) { record_sizes(sizes); }

// result: of paths 0 .. n-1, the value of path_generate.
EXPORT void LANE_CALL(generate)(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                                uniform uint n, uniform int* uniform result) {
    foreach (i = 0 ... n) result[i] = path_generate(s, par, paths, i);
}

// result: of each path of the queue, the value of path_shade.
EXPORT void LANE_CALL(shade)(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                             const uniform uint* uniform queue, uniform uint n, uniform int* uniform result) {
    foreach (i = 0 ... n) result[i] = path_shade(s, par, paths, queue[i]);
}

// known: visibility of each path's shadow ray (integrator/shadow.h).
EXPORT void LANE_CALL(shadow)(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                              const uniform uint* uniform queue, uniform uint n, const uniform int* uniform known) {
    foreach (i = 0 ... n) path_shadow(s, par, paths, queue[i], known[i]);
}

// For each member of the groups of a square, one group after another.
#define OF_GROUPS(stage)                                        \
    for (uniform uint group = 0; group < REUSE_GROUPS; group++) \
        foreach (which = 0 ... REUSE_GROUP) stage

EXPORT void LANE_CALL(suffix_roulette)(PARAMS(const Params) par, TABLES(const Paths) paths) {
    OF_GROUPS(path_suffix_roulette(par, paths, REUSE_FIRST(group), which));
}

// connections: paths and members of their groups, path * REUSE_GROUP + member.
EXPORT void LANE_CALL(transmittance)(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                                    const uniform uint* uniform connections, uniform uint n) {
    foreach (i = 0 ... n)
        connection_transmittance(s, par, paths, connections[i] / REUSE_GROUP, connections[i] % REUSE_GROUP);
}

EXPORT void LANE_CALL(connect)(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths) {
    OF_GROUPS(path_connect(s, par, paths, REUSE_FIRST(group), which));
}

EXPORT void LANE_CALL(normalise_mis)(TABLES(const Paths) paths, const uniform uint* uniform queue, uniform uint n) {
    foreach (i = 0 ... n) path_normalise_mis(paths, queue[i]);
}

EXPORT void LANE_CALL(gather)(TABLES(const Paths) paths) {
    OF_GROUPS(path_gather(paths, REUSE_FIRST(group), which));
}
