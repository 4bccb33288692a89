// SPDX-License-Identifier: BSD-3-Clause
// The __kernel entries that walk chains of modifiers where those of entry.cl do not (CHAINS_APART, features.h): a
// program of its own, with all features of the scene and FEATURE_CHAINS.

__kernel void k_patterns(ALL_ARGS, __global const uint *counters, __global const uint *queue) {
    SET_UP
    if (i < counters[0]) path_patterns(&s, par, &paths, queue[i]);
}

__kernel void k_lamps(ALL_ARGS, __global uint *counters, __global const uint *lamps, __global uint *shadow) {
    SET_UP
    __local uint group[2];
    int active = i < counters[4];
    uint slot = active ? lamps[i] : 0;
    push(active && path_lamp_shines(&s, par, &paths, slot), slot, &counters[2], shadow, group);
}

__kernel void k_shadow_left(ALL_ARGS, __global const uint *counters, __global const uint *left) {
    SET_UP
    if (i < counters[3]) path_shadow(&s, par, &paths, left[i], SHADOW_TO_TRACE);
}

__kernel void k_panes_left(ALL_ARGS) {
    SET_UP
    if (i >= par->slots || !HAS_FAR_END(&paths, i)) return;
    uint through = links_to_look_through(paths.links[i], share_which(i));
    for (uint m = 0; m < SHARE_GROUP; m++)
        if ((through >> m & 1u) != 0 && paths.panes[i].of[m].w == LINK_LEFT) path_look_through(&s, par, &paths, i, m);
}
