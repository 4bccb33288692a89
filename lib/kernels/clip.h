// SPDX-License-Identifier: BSD-3-Clause
// antimatter: a surface that cuts away what carries the modifiers it lists (spec: RADIANCE shading 3.17).
// A ray keeps one byte for each of up to four antimatters: how often it is inside (low 4 bits), and how many more of the
// listed surfaces it has entered than left (high 4 bits, 8 = none).
#ifndef LUX_CLIP_H
#define LUX_CLIP_H

#define CLIP_START 0x80808080u
#define CLIP_NO 0      // shade the surface
#define CLIP_IGNORE 1  // the ray goes on

FN int clip_hit(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE Surface* g, PRIVATE uint* state) {
    if (g->mod == NONE) return CLIP_NO;
    GLOBAL const uint* m = mod_record(s, par, g->mod);
    uint listed = (m[MOD_FLAGS] >> MF_CLIPPED_SHIFT) & 15u;
    int ignored = 0;
    for (uint i = 0u; i < 4u; i++) {
        if (((listed >> i) & 1u) == 0u) continue;
        uint b = (*state >> (8u * i)) & 255u, entered = b >> 4;
        if ((b & 15u) > 0u) ignored = 1;
        if (g->front && entered < 15u) entered++;
        if (!g->front && entered > 0u) entered--;
        *state = (*state & ~(255u << (8u * i))) | (((entered << 4) | (b & 15u)) << (8u * i));
    }
    if (ignored) return CLIP_IGNORE;
    if (m[MOD_TYPE] != M_ANTIMATTER) return CLIP_NO;
    uint i = (uint)s->f[m[MOD_ARGS]], b = (*state >> (8u * i)) & 255u, inside = b & 15u;
    if (m[MOD_BRANCH1] != NONE && (b >> 4) > 8u) {  // the cut face, in the first material, turned around
        g->mod = m[MOD_BRANCH1];
        g->nface = neg3(g->nface);
        g->front = !g->front;
        return CLIP_NO;
    }
    if (g->front && inside < 15u) inside++;
    if (!g->front && inside > 0u) inside--;
    *state = (*state & ~(255u << (8u * i))) | (((b & 240u) | inside) << (8u * i));
    return CLIP_IGNORE;
}
#endif
