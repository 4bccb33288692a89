// SPDX-License-Identifier: BSD-3-Clause
// The __kernel entries: each takes the buffers, finds its slot and calls one stage of path.h.
// Queues: counters[0] paths to extend, [1] next queue, [2] shadow queue; a work item beyond the count leaves at once.

#define SCENE_ARGS                                                                                    \
    __global const float *nodes, __global const float *leaves, __global const float *shapes,          \
        __global const float *polygon_uv, __global const uint *prims, __global const float *vertices, \
        __global const uint *u, __global const float *f, __global const Params *params
#define PATH_ARGS                                                                                                      \
    __global float4 *porg, __global float4 *pdir, __global float4 *pthr, __global float4 *prad, __global uint4 *pinfo, \
        __global float4 *phit, __global float4 *psorg, __global float4 *psdir, __global float4 *pscol,                 \
        __global float4 *pmed, __global float4 *palb, __global float4 *psmed, __global float4 *psalb
#define SET_UP                 \
    SceneTables s;             \
    Params par = *params;      \
    Paths a;                   \
    s.nodes = nodes;           \
    s.leaves = leaves;         \
    s.shapes = shapes;         \
    s.polygon_uv = polygon_uv; \
    s.prims = prims;           \
    s.vertices = vertices;     \
    s.u = u;                   \
    s.f = f;                   \
    a.org = porg;              \
    a.dir = pdir;              \
    a.thr = pthr;              \
    a.rad = prad;              \
    a.info = pinfo;            \
    a.hit = phit;              \
    a.sorg = psorg;            \
    a.sdir = psdir;            \
    a.scol = pscol;            \
    a.med = pmed;              \
    a.alb = palb;              \
    a.smed = psmed;            \
    a.salb = psalb;            \
    uint i = (uint)get_global_id(0);

__kernel void k_generate(SCENE_ARGS, PATH_ARGS, __global uint *counters, __global uint *queue) {
    SET_UP
    if (i >= par.slots) return;
    if (path_generate(&par, &a, i)) queue[atomic_inc(&counters[0])] = i;
}
__kernel void k_extend(SCENE_ARGS, PATH_ARGS, __global uint *counters, __global const uint *queue) {
    SET_UP
    if (i < counters[0]) path_extend(&s, &a, queue[i]);
}
__kernel void k_shade(SCENE_ARGS, PATH_ARGS, __global uint *counters, __global const uint *queue, __global uint *next,
                      __global uint *shadow) {
    SET_UP
    if (i >= counters[0]) return;
    uint slot = queue[i];
    int r = path_shade(&s, &par, &a, slot);
    if (r & PATH_GOES_ON) next[atomic_inc(&counters[1])] = slot;
    if (r & PATH_SHADOW) shadow[atomic_inc(&counters[2])] = slot;
}
__kernel void k_shadow(SCENE_ARGS, PATH_ARGS, __global uint *counters, __global const uint *shadow) {
    SET_UP
    if (i < counters[2]) path_shadow(&s, &par, &a, shadow[i]);
}
// After a round: the next queue becomes the current one.
__kernel void k_swap(__global uint *counters) {
    if (get_global_id(0) == 0) {
        counters[0] = counters[1];
        counters[1] = 0;
        counters[2] = 0;
    }
}
__kernel void k_draw(SCENE_ARGS, PATH_ARGS) {
    SET_UP
    if (i >= par.slots) return;
    path_draw(&s, &par, &a, i);
    path_shadow(&s, &par, &a, i);
}
// Sizes and offsets as the device sees them, for the test against the host's.
__kernel void k_layout(__global uint *out) {
    if (get_global_id(0) != 0) return;
    Params p;
    __private uchar *base = (__private uchar *)&p;
    out[0] = sizeof(Params);
    out[1] = (uint)((__private uchar *)&p.nx - base);
    out[2] = (uint)((__private uchar *)&p.mods_at - base);
    out[3] = (uint)((__private uchar *)&p.st - base);
    out[4] = (uint)((__private uchar *)&p.draw_count - base);
}
