// SPDX-License-Identifier: BSD-3-Clause
// Emission that a sampled ray sees, by its class: the partition into active sources and other emitters (spec shading
// 0.1, 3.8).
#ifndef LUX_PATH_EMISSION_H
#define LUX_PATH_EMISSION_H

// Returns 1 if this pass records light of the path's present class.
FN int class_wanted(PARAMS(const Params) par, uint flags, uint index) {
    if (par->mode == MODE_RAY || par->mode == MODE_PILOT) return 1;
    if (par->mode == MODE_IMAGE) return 0;  // only the sun (path_background)
    if ((flags & PC_DIFFUSE) != 0u) return par->mode == MODE_FRAMES;
    return par->mode == MODE_DIRECT || index > par->skip_direct_below;
}

// Radiance of a ray without a hit: sun, sky, ground glow.
FN float3 path_background(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path, float3 org, float3 dir,
                          uint flags, PRIVATE(Sampler) rnd) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    int sampled = path_sampled(flags), images_only = par->mode == MODE_IMAGE;
    uint i = distant_at(s, par, dir, sampled);
    if (i == NONE) return black;
    GLOBAL const Distant* distant = &s->distant[i];
    uint source = distant->source;

    if (source != NONE) {  // an active source (the sun): only eye and mirror rays see it (spec shading 0.1)
        if (sampled || (par->flags & PF_DV) == 0u) return black;
        if (held_by_area(s, par, path, flags, source) != images_only) return black;
    } else if (images_only) {
        return black;
    }

    if (distant->seen >= DISTANT_BLACK) return black;
    return sky_radiance(s, par, distant->seen, org, dir, rnd);
}

// Radiance of a light surface at a hit (spec shading 3.8, in its order).  *pass = 1: the ray passes through it.
FN float3 emitter_radiance(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, uint flags,
                           PRIVATE(int) pass) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    GLOBAL const float* arg = s->f + m->args;
    uint source = s->prims[g->prim].source;
    *pass = 0;
    int sampled = path_sampled(flags);
    if (sampled && g->front) {
        if (g->type != M_GLOW || arg[3] < 0.0f) return black;
        if (arg[3] > 0.0f && g->length <= arg[3]) return black;
    }

    if ((par->flags & PF_DV) == 0u && !(g->type == M_GLOW && arg[3] >= 0.0f && g->path_length > arg[3])) return black;
    if (!g->front) {
        *pass = par->bv == 0u;
        return black;
    }

    if (!sampled && source != NONE && (flags & PC_BENT) == 0u && par->mode != MODE_RAY &&
        (drawn_by_area(s, par, source) & DRAWN_STRAIGHT) != 0u)
        return black;
    if (g->type == M_SPOTLIGHT) {
        float3 aim = f3_at(arg + 4);
        if (dot3(unit3(aim), g->v) < k_cos(arg[3] * 0.5f * K_RADIANS)) return black;
    }

    return mul3(g->color, f3_at(arg));
}
#endif
