// SPDX-License-Identifier: BSD-3-Clause
// Evaluates a surface's chain of modifiers: patterns multiply, textures add, a mixture chooses one branch with its
// coefficient as probability (the mean is the mixture), up to a material, whose own chain follows.
#ifndef LUX_MODIFIER_H
#define LUX_MODIFIER_H

#define LONGEST_CHAIN 4096  // modifiers in one chain

// Variables of .cal programs (spec: scene language 7.6), in world coordinates.  Patterns, textures and mixtures see the
// modelled normal, also from behind: RADIANCE turns it to the viewer after them.
FN void surface_vars(PARAMS(const Params) par, PRIVATE(const Surface) g, PRIVATE(float) vars) {
    float3 p = add3(g->p, f3_of(par->centre));
    for (UNIFORM int i = 0; i < CAL_VARS; i++) vars[i] = 0.0f;
    vars[CAL_DX] = -g->v.x;
    vars[CAL_DY] = -g->v.y;
    vars[CAL_DZ] = -g->v.z;
    vars[CAL_NX] = g->nface.x;
    vars[CAL_NY] = g->nface.y;
    vars[CAL_NZ] = g->nface.z;
    vars[CAL_PX] = p.x;
    vars[CAL_PY] = p.y;
    vars[CAL_PZ] = p.z;
    vars[CAL_T] = g->path_length;
    vars[CAL_TS] = g->length;
    vars[CAL_RDOT] = dot3(g->nface, g->v);
    vars[CAL_LU] = g->u;
    vars[CAL_LV] = g->vv;
}

// Inside an instance functions see the instance's coordinates (spec scene 3): transforms the variables of
// surface_vars().
FN void vars_to_frame(TABLES(const SceneTables) s, PRIVATE(const Surface) g, PRIVATE(float) vars) {
    const int dirs[5] = {CAL_DX, CAL_NX, CAL_NXP, CAL_DXA, CAL_LX};
    if (!in_instance(g->inst)) return;
    GLOBAL const Instance* record = &s->instances[g->inst];
    float scale = record->scale;

    for (UNIFORM int i = 0; i < 5; i++) {
        int k = dirs[i];
        float3 v = scale3(affine_vector(&record->frame[0], F3(vars[k], vars[k + 1], vars[k + 2])), 1.0f / scale);
        vars[k] = v.x;
        vars[k + 1] = v.y;
        vars[k + 2] = v.z;
    }

    float3 p = affine_point(&record->frame[0], g->p);
    vars[CAL_PX] = p.x;
    vars[CAL_PY] = p.y;
    vars[CAL_PZ] = p.z;
    vars[CAL_T] *= scale;
    vars[CAL_TS] *= scale;
}

// World direction or displacement for a result of such a function; its length is kept.
FN float3 vector_from_frame(TABLES(const SceneTables) s, PRIVATE(const Surface) g, float3 v) {
    if (!in_instance(g->inst)) return v;
    GLOBAL const Instance* record = &s->instances[g->inst];
    return scale3(affine_back(&record->frame[0], v), 1.0f / record->scale);
}

FN void turn_from_frame(TABLES(const SceneTables) s, PRIVATE(const Surface) g, PRIVATE(float) v, uint k) {
    float3 w = vector_from_frame(s, g, F3(v[k], v[k + 1u], v[k + 2u]));
    v[k] = w.x;
    v[k + 1u] = w.y;
    v[k + 2u] = w.z;
}

// Result of the patterns and textures so far.
STRUCT(Patterns) { float3 color, pert; };

FN Patterns no_patterns() {
    Patterns none;
    none.color = F3(1.0f, 1.0f, 1.0f);
    none.pert = F3(0.0f, 0.0f, 0.0f);
    return none;
}

// Adds the result of a pattern's or texture's program.
FN void apply_pattern(TABLES(const SceneTables) s, PRIVATE(const Surface) g, uint type, PRIVATE(const float) out,
                      PRIVATE(Patterns) sum) {
    if (type == M_PATTERN1) sum->color = scale3(sum->color, out[0]);
    if (type == M_PATTERN3) sum->color = mul3(sum->color, F3(out[0], out[1], out[2]));
    if (type == M_TEXTURE) sum->pert = add3(sum->pert, vector_from_frame(s, g, F3(out[0], out[1], out[2])));
}

// Weight of a mixture's foreground, from its program.
FN float mixture_share(float x) { return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x; }

// A mixture of patterns in progress: the result before it and of its first branch, and the modifier that follows.
STRUCT(PatternMix) {
    Patterns before, first;
    float share;  // of the first branch
    uint second, next;
    int first_done;
};

FN void mix_enter(GLOBAL const Modifier* m, float share, PRIVATE(Patterns) sum, PRIVATE(uint) mod,
                  PRIVATE(PatternMix) stack, int depth) {
    stack[depth].before = *sum;
    stack[depth].share = share;
    stack[depth].second = m->branch2;
    stack[depth].next = *mod;
    stack[depth].first_done = 0;
    *sum = no_patterns();
    *mod = m->branch1;
}

// Ends a branch: continues with the second one, or mixes both and continues after the mixture.  Returns 1 when the
// mixture is done.
FN int mix_branch_ends(PRIVATE(PatternMix) stack, int depth, PRIVATE(Patterns) sum, PRIVATE(uint) mod) {
    if (!stack[depth].first_done) {
        stack[depth].first_done = 1;
        stack[depth].first = *sum;
        *sum = no_patterns();
        *mod = stack[depth].second;
        return 0;
    }

    PatternMix mix = stack[depth];
    float c = mix.share;
    sum->color = mul3(mix.before.color, madd3(mix.first.color, c, scale3(sum->color, 1.0f - c)));
    sum->pert = add3(mix.before.pert, madd3(mix.first.pert, c, scale3(sum->pert, 1.0f - c)));
    *mod = mix.next;
    return 1;
}

// Patterns and textures of a chain without material: colours and perturbations mix linearly (spec shading 3.10).
FN Patterns chain_patterns(TABLES(const SceneTables) s, PRIVATE(const Surface) g, uint mod, PRIVATE(const float) vars) {
    float out[CAL_OUTPUTS];
    PatternMix stack[MIX_DEPTH];
    int depth = 0;
    Patterns sum = no_patterns();

    for (int guard = 0; guard < LONGEST_CHAIN; guard++) {
        GLOBAL const Modifier* m = &s->modifiers[mod != NONE ? mod : 0u];
        if (mod == NONE || m->type >= M_FIRST_MATERIAL) {  // the end of a branch
            if (depth == 0) return sum;
            depth -= mix_branch_ends(stack, depth - 1, &sum, &mod);
            continue;
        }

        uint type = m->type;
        mod = m->next;
        if (cal_run(s, m->program, vars, out)) continue;
        if (type != M_MIXTURE) apply_pattern(s, g, type, out, &sum);
        else if (depth < MIX_DEPTH) mix_enter(m, mixture_share(out[0]), &sum, &mod, stack, depth++);
    }

    return sum;
}

// Shading normal of textures and smoothing (spec shading 2), on the viewer's side.
FN void shading_normal(PRIVATE(Surface) g) {
    g->n = g->ng;
    if (!is_textured(g)) return;

    // g->pert is in the frame of the modelled normal; from behind it is negated with the normal
    float3 n = unit3(add3(g->nface, g->pert));
    if (!g->front) n = neg3(n);
    if (dot3(n, g->v) < 0.0f) n = madd3(g->v, -2.0f * dot3(n, g->v), n);
    g->n = unit3(n);
}

// Restores the patterns and textures above the material, before another chain replaces the material's own.
FN void without_own_chain(TABLES(const SceneTables) s, PRIVATE(Surface) g) {
    g->color = g->color_before;
    g->pert = g->pert_before;
    g->flat = drawn_flat(s, g) && !is_textured(g);
}

// A mixture of patterns alone: both branches, mixed.
FN void apply_pattern_mixture(TABLES(const SceneTables) s, GLOBAL const Modifier* m, float share,
                              PRIVATE(const float) vars, PRIVATE(Surface) g) {
    Patterns first = chain_patterns(s, g, m->branch1, vars);
    Patterns second = chain_patterns(s, g, m->branch2, vars);
    float3 pert = madd3(first.pert, share, scale3(second.pert, 1.0f - share));
    g->color = mul3(g->color, madd3(first.color, share, scale3(second.color, 1.0f - share)));
    g->pert = add3(g->pert, pert);
    if (is_textured(g)) g->flat = 0;
}

// The same of a single pattern or texture.
FN void apply_single_pattern(TABLES(const SceneTables) s, uint type, PRIVATE(const float) out, PRIVATE(Surface) g) {
    Patterns sum;
    sum.color = g->color;
    sum.pert = g->pert;
    apply_pattern(s, g, type, out, &sum);
    g->color = sum.color;
    g->pert = sum.pert;
    if (is_textured(g)) g->flat = 0;
}

// Returns 1 if g->mod, g->type, g->color, g->pert hold the material, 0 if the chain has none and the ray passes.
FN int chain_material(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g, PRIVATE(Sampler) rnd) {
    uint stack[MIX_DEPTH];  // where the chains after mixtures continue
    int depth = 0, have_vars = 0;
    uint mod = g->mod, material = NONE;
    float vars[CAL_VARS], out[CAL_OUTPUTS];

    for (int guard = 0; guard < LONGEST_CHAIN; guard++) {
        if (mod == NONE) {
            if (depth == 0) break;
            mod = stack[--depth];
            continue;
        }

        GLOBAL const Modifier* m = &s->modifiers[mod];
        uint type = m->type;
        if (type >= M_FIRST_MATERIAL) {
            if (material != NONE) break;  // a second material above one is an error at load
            material = mod;
            g->type = type;
            g->color_before = g->color;
            g->pert_before = g->pert;
            mod = m->next;
            continue;
        }

        if (!have_vars) {
            surface_vars(par, g, vars);
            vars_to_frame(s, g, vars);
            have_vars = 1;
        }
        int bad = cal_run(s, m->program, vars, out);
        mod = m->next;
        if (type != M_MIXTURE) {
            if (!bad) apply_single_pattern(s, type, out, g);
            continue;
        }

        if (bad) return 0;  // after an error a chain has no material
        float share = mixture_share(out[0]);
        if ((m->flags & MF_PATTERNS_ONLY) != 0u) {
            apply_pattern_mixture(s, m, share, vars, g);
            continue;
        }
        if (mod != NONE && depth < MIX_DEPTH) stack[depth++] = mod;
        mod = share >= 1.0f || (share > 0.0f && sample1(rnd) < share) ? m->branch1 : m->branch2;
        g->mixed = 1;
    }

    if (material == NONE) return 0;
    g->mod = material;
    shading_normal(g);
    return 1;
}

// The same for a surface or an active source.  A chain without patterns is its material.
FN int find_material(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g, PRIVATE(Sampler) rnd) {
    if (HAS(PATTERNS)) return chain_material(s, par, g, rnd);
    if (g->mod == NONE) return 0;
    g->type = s->modifiers[g->mod].type;
    g->color_before = g->color;
    g->pert_before = g->pert;
    shading_normal(g);
    return 1;
}
#endif
