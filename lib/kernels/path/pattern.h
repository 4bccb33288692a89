// SPDX-License-Identifier: BSD-3-Clause
// From the modifier of a surface to its material.  Where chains are walked apart (features.h), a kernel does that
// before the others are shaded, for surfaces that have more than a material: a .cal program would take the registers
// of all.  What it has found stays with the path until the surface is shaded.
#ifndef LUX_PATH_PATTERN_H
#define LUX_PATH_PATTERN_H

// The word beside the textures' sum: the sampler's next dimension, which mixtures have moved, and two answers
#define PATTERN_DIM 0x00ffffffu
#define PATTERN_MIXED 0x40000000u  // Surface.mixed
#define PATTERN_FLAT 0x80000000u   // Surface.flat

// Finds the material, with its patterns and textures; alternates take their places.  0: the ray passes.
FN int vertex_material(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Vertex) vertex) {
    if (!find_material(s, par, &vertex->g, &vertex->rnd)) return 0;
    return !take_alternate(s, par, &vertex->g, vertex->flags, &vertex->rnd);
}

// Does so ahead, for what the ray of a slot has met.
FN void path_patterns(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot) {
    Vertex vertex;
    vertex_load(par, paths, slot, &vertex);
    if (vertex.hit.prim == NO_HIT || !vertex_arrive(s, &vertex)) return;

    PRIVATE(Surface) g = &vertex.g;
    if (has_antimatter(par) && clip_hit(s, par, g, &vertex.clip_beyond) == CLIP_IGNORE) return;
    if (is_material_alone(s, par, g->mod)) return;

    uint mod = vertex_material(s, par, &vertex) ? g->mod : NONE;
    uint word = vertex.rnd.dim | (g->mixed ? PATTERN_MIXED : 0u) | (g->flat ? PATTERN_FLAT : 0u);
    write4_(paths->pattern_color, slot, pack4(g->color, as_float_(mod)));
    write4_(paths->pattern_pert, slot, pack4(g->pert, as_float_(word)));
}

// Takes what it has found.  0: the ray passes.
FN int pattern_take(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths,
                    PRIVATE(Vertex) vertex) {
    PRIVATE(Surface) g = &vertex->g;
    float4 color = read4_(paths->pattern_color, vertex->slot), pert = read4_(paths->pattern_pert, vertex->slot);
    uint word = as_uint_(pert.w);
    vertex->rnd.dim = word & PATTERN_DIM;
    g->mixed = (word & PATTERN_MIXED) != 0u;
    g->flat = (word & PATTERN_FLAT) != 0u;
    g->color = xyz4(color);
    g->pert = xyz4(pert);
    g->mod = as_uint_(color.w);
    if (g->mod == NONE) return 0;
    g->type = mod_word(s, par, g->mod, MOD_TYPE);
    shading_normal(g);
    return 1;
}
#endif
