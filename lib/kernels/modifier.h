// SPDX-License-Identifier: BSD-3-Clause
// Walks a surface's modifier chain: patterns multiply, textures add, a mixture picks one branch by chance with its
// coefficient as probability (the mean is the mixture), until a material is found; the material's own chain follows.
#ifndef LUX_MODIFIER_H
#define LUX_MODIFIER_H

FN GLOBAL const uint* mod_record(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint mod) {
    return s->u + par->mods_at + MOD_WORDS * mod;
}

// The variables .cal programs see (spec: scene language 7.6), in world coordinates.  Patterns, textures and mixtures
// see the normal as modelled, from behind, too: RADIANCE turns it to the viewer after them.
FN void surface_vars(PRIVATE const Params* par, PRIVATE const Surface* g, PRIVATE float* vars) {
    float3 p = F3(g->p.x + par->centre.x, g->p.y + par->centre.y, g->p.z + par->centre.z);
    for (int i = 0; i < CAL_VARS; i++) vars[i] = 0.0f;
    vars[CAL_DX] = -g->v.x;
    vars[CAL_DY] = -g->v.y;
    vars[CAL_DZ] = -g->v.z;
    vars[CAL_NX] = g->nface.x;
    vars[CAL_NY] = g->nface.y;
    vars[CAL_NZ] = g->nface.z;
    vars[CAL_PX] = p.x;
    vars[CAL_PY] = p.y;
    vars[CAL_PZ] = p.z;
    vars[CAL_T] = g->total;
    vars[CAL_TS] = g->length;
    vars[CAL_RDOT] = dot3(g->nface, g->v);
    vars[CAL_LU] = g->u;
    vars[CAL_LV] = g->vv;
}

// Inside an instance functions see its coordinates (spec scene 3): turns the variables of surface_vars().
FN void vars_to_frame(PRIVATE const SceneTables* s, PRIVATE const Surface* g, PRIVATE float* vars) {
    const int dirs[5] = {CAL_DX, CAL_NX, CAL_NXP, CAL_DXA, CAL_LX};
    if (g->inst == NONE) return;
    GLOBAL const float* record = instance_record(s, g->inst);
    float scale = record[INST_SCALE];
    for (int i = 0; i < 5; i++) {
        PRIVATE float* d = vars + dirs[i];
        float3 v = scale3(affine_vector(record + INST_FRAME, F3(d[0], d[1], d[2])), 1.0f / scale);
        d[0] = v.x;
        d[1] = v.y;
        d[2] = v.z;
    }
    float3 p = affine_point(record + INST_FRAME, g->p);
    vars[CAL_PX] = p.x;
    vars[CAL_PY] = p.y;
    vars[CAL_PZ] = p.z;
    vars[CAL_T] *= scale;
    vars[CAL_TS] *= scale;
}

// A direction or displacement that such a function gave, in the world; its length is kept.
FN float3 vector_from_frame(PRIVATE const SceneTables* s, PRIVATE const Surface* g, float3 v) {
    if (g->inst == NONE) return v;
    GLOBAL const float* record = instance_record(s, g->inst);
    return scale3(affine_back(record + INST_FRAME, v), 1.0f / record[INST_SCALE]);
}
FN void turn_from_frame(PRIVATE const SceneTables* s, PRIVATE const Surface* g, PRIVATE float* v) {
    float3 w = vector_from_frame(s, g, F3(v[0], v[1], v[2]));
    v[0] = w.x;
    v[1] = w.y;
    v[2] = w.z;
}

// A mixture of patterns that is being walked through: what was found before it and in its first branch, where to go on.
typedef struct {
    float3 color, pert, color1, pert1;
    float share;  // of the first branch
    uint second, next;
    int first_done;
} PatternMix;

// Patterns and textures of a chain without material: colours and perturbations mix linearly (spec shading 3.10).
FN void chain_patterns(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g, uint mod,
                       PRIVATE const float* vars, PRIVATE float3* color, PRIVATE float3* pert) {
    float out[CAL_OUTPUTS];
    PatternMix stack[MIX_DEPTH];
    float3 white = F3(1.0f, 1.0f, 1.0f), none = F3(0.0f, 0.0f, 0.0f);
    int depth = 0;
    *color = white;
    *pert = none;
    for (int guard = 0; guard < 4096; guard++) {
        GLOBAL const uint* m = mod != NONE ? mod_record(s, par, mod) : s->u;
        if (mod == NONE || m[MOD_TYPE] >= M_FIRST_MATERIAL) {  // the end of a branch
            if (depth == 0) return;
            PRIVATE PatternMix* mix = &stack[depth - 1];
            if (!mix->first_done) {
                mix->first_done = 1;
                mix->color1 = *color;
                mix->pert1 = *pert;
                *color = white;
                *pert = none;
                mod = mix->second;
            } else {
                float c = mix->share;
                *color = mul3(mix->color, madd3(mix->color1, c, scale3(*color, 1.0f - c)));
                *pert = add3(mix->pert, madd3(mix->pert1, c, scale3(*pert, 1.0f - c)));
                mod = mix->next;
                depth--;
            }
            continue;
        }
        uint type = m[MOD_TYPE];
        mod = m[MOD_NEXT];
        if (type == M_SPECTRUM) {
            GLOBAL const float* a = s->f + m[MOD_ARGS];
            *color = mul3(*color, F3(a[0], a[1], a[2]));
            continue;
        }
        int bad = cal_run(s, m[MOD_PROGRAM], vars, out);
        if (bad) continue;
        if (type == M_MIXTURE && depth < MIX_DEPTH) {
            PRIVATE PatternMix* mix = &stack[depth++];
            mix->color = *color;
            mix->pert = *pert;
            mix->share = out[0] < 0.0f ? 0.0f : out[0] > 1.0f ? 1.0f : out[0];
            mix->second = m[MOD_BRANCH2];
            mix->next = mod;
            mix->first_done = 0;
            *color = white;
            *pert = none;
            mod = m[MOD_BRANCH1];
        }
        if (type == M_PATTERN1) *color = scale3(*color, out[0]);
        if (type == M_PATTERN3) *color = mul3(*color, F3(out[0], out[1], out[2]));
        if (type == M_TEXTURE) *pert = add3(*pert, vector_from_frame(s, g, F3(out[0], out[1], out[2])));
    }
}

// The normal that textures and smoothing make (spec shading 2): on the viewer's side.
FN void shading_normal(PRIVATE Surface* g) {
    g->n = g->ng;
    if (dot3(g->pert, g->pert) <= 1e-12f) return;
    // g->pert is in the frame of the modelled normal; seen from behind it turns with the normal
    float3 n = unit3(add3(g->nface, g->pert));
    if (!g->front) n = neg3(n);
    if (dot3(n, g->v) < 0.0f) n = madd3(g->v, -2.0f * dot3(n, g->v), n);
    g->n = unit3(n);
}

// Back to the patterns and textures met before the material, for another chain in place of the material's own.
FN void without_own_chain(PRIVATE const SceneTables* s, PRIVATE Surface* g) {
    g->color = g->color_before;
    g->pert = g->pert_before;
    g->flat = drawn_flat(s, g) && dot3(g->pert, g->pert) <= 0.0f;
}

// 1: g->mod, g->type, g->color, g->pert hold the material; 0: the chain has none, the ray passes.
FN int find_material(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE Surface* g,
                     PRIVATE Sampler* rnd) {
    uint stack[MIX_DEPTH];
    int depth = 0, found = 0;
    uint mod = g->mod, material = NONE;
    float vars[CAL_VARS], out[CAL_OUTPUTS];
    int have_vars = 0;
    for (int guard = 0; guard < 4096; guard++) {
        if (mod == NONE) {
            if (depth == 0) break;
            mod = stack[--depth];
            continue;
        }
        GLOBAL const uint* m = mod_record(s, par, mod);
        uint type = m[MOD_TYPE];
        if (type >= M_FIRST_MATERIAL) {
            if (found) break;  // a second material above one is an error at load
            found = 1;
            material = mod;
            g->type = type;
            g->color_before = g->color;
            g->pert_before = g->pert;
            mod = m[MOD_NEXT];
            continue;
        }
        if (type == M_SPECTRUM) {
            GLOBAL const float* a = s->f + m[MOD_ARGS];
            g->color = mul3(g->color, F3(a[0], a[1], a[2]));
            mod = m[MOD_NEXT];
            continue;
        }
        if (!have_vars) {
            surface_vars(par, g, vars);
            vars_to_frame(s, g, vars);
            have_vars = 1;
        }
        int bad = cal_run(s, m[MOD_PROGRAM], vars, out);
        if (type == M_MIXTURE) {
            if (bad) return 0;  // an error yields no material here
            float c = out[0] < 0.0f ? 0.0f : out[0] > 1.0f ? 1.0f : out[0];
            if ((m[MOD_FLAGS] & MF_PATTERNS_ONLY) !=
                0u) {  // colours and perturbations mix linearly (spec shading 3.10)
                float3 c1, c2, p1, p2;
                chain_patterns(s, par, g, m[MOD_BRANCH1], vars, &c1, &p1);
                chain_patterns(s, par, g, m[MOD_BRANCH2], vars, &c2, &p2);
                g->color = mul3(g->color, madd3(c1, c, scale3(c2, 1.0f - c)));
                p1 = madd3(p1, c, scale3(p2, 1.0f - c));
                g->pert = add3(g->pert, p1);
                if (dot3(p1, p1) > 0.0f) g->flat = 0;
                mod = m[MOD_NEXT];
                continue;
            }
            uint branch = (c >= 1.0f || (c > 0.0f && sample1(rnd) < c)) ? MOD_BRANCH1 : MOD_BRANCH2;
            if (m[MOD_NEXT] != NONE && depth < MIX_DEPTH) stack[depth++] = m[MOD_NEXT];
            mod = m[branch];
            g->mixed = 1;
            continue;
        }
        if (!bad) {
            if (type == M_PATTERN1) g->color = scale3(g->color, out[0]);
            if (type == M_PATTERN3) g->color = mul3(g->color, F3(out[0], out[1], out[2]));
            if (type == M_TEXTURE) {
                g->pert = add3(g->pert, vector_from_frame(s, g, F3(out[0], out[1], out[2])));
                g->flat = 0;
            }
        }
        mod = m[MOD_NEXT];
    }
    if (!found) return 0;
    g->mod = material;
    shading_normal(g);
    return 1;
}
#endif
