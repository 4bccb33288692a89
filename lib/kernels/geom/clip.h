// SPDX-License-Identifier: BSD-3-Clause
// antimatter: a surface that cuts away other surfaces whose modifiers it lists (spec: RADIANCE shading 3.17).
// Modifiers listed by the same of up to four antimatters form one group, numbered by the bits of these antimatters.  A
// ray stores the groups that are cut away (low 16 bits), and for each antimatter the number of listed surfaces entered
// less those left (4 bits each, 8 = 0).
#ifndef LUX_CLIP_H
#define LUX_CLIP_H

#define CLIP_START 0x88880000u
#define CLIP_NO 0      // shade the surface
#define CLIP_IGNORE 1  // the ray passes

// Groups that antimatter i lists: those with bit i in their number.
FN uint clip_groups(uint i) { return i == 0u ? 0xaaaau : i == 1u ? 0xccccu : i == 2u ? 0xf0f0u : 0xff00u; }

FN uint clip_entered(uint state, uint i) { return (state >> (16u + 4u * i)) & 15u; }

// Adds `step` surfaces to the antimatters that list group `listed`.
FN uint clip_count(uint state, uint listed, int step) {
    for (UNIFORM uint i = 0u; i < 4u; i++) {
        if (((listed >> i) & 1u) == 0u) continue;
        int entered = (int)clip_entered(state, i) + step;
        entered = entered < 0 ? 0 : entered > 15 ? 15 : entered;
        state = (state & ~(15u << (16u + 4u * i))) | ((uint)entered << (16u + 4u * i));
    }

    return state;
}

FN uint clip_group(TABLES(const SceneTables) s, uint mod) {
    return mod == NONE ? 0u : (s->modifiers[mod].flags >> MF_CLIPPED_SHIFT) & 15u;
}

FN int clip_hit(TABLES(const SceneTables) s, PRIVATE(Surface) g, PRIVATE(uint) state) {
    if (g->mod == NONE) return CLIP_NO;
    uint listed = clip_group(s, g->mod);
    int ignored = listed != 0u && ((*state >> listed) & 1u) != 0u;
    *state = clip_count(*state, listed, g->front ? 1 : -1);
    if (ignored) return CLIP_IGNORE;
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    if (m->type != M_ANTIMATTER) return CLIP_NO;
    uint i = (uint)s->f[m->args];
    *state = g->front ? *state | clip_groups(i) : *state & ~clip_groups(i);
    if (m->branch1 == NONE || clip_entered(*state, i) <= 8u) return CLIP_IGNORE;
    g->mod = m->branch1;  // the cut face, in the first material, turned around
    g->nface = neg3(g->nface);
    g->front = !g->front;
    return CLIP_NO;
}

// A material that turns its back to the viewer is entered from behind, too.  mod: the surface's modifier.
FN void clip_turned(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, uint mod,
                    PRIVATE(uint) state) {
    if (g->front || par->bv == 0u || material_has(g->type, MT_TURNS) == 0u) return;
    *state = clip_count(*state, clip_group(s, mod), 2);
}
#endif
