// SPDX-License-Identifier: BSD-3-Clause
// Samples one of seven lobes of a surface, with a probability in proportion to the energy that the lobe scatters.
#ifndef LUX_SAMPLE_BSDF_H
#define LUX_SAMPLE_BSDF_H

// in the order in which one random number chooses
#define SAMPLE_DIFFUSE_R 0u  // into the hemisphere on the viewer's side
#define SAMPLE_THROUGH 1u    // straight on, or bent by a texture
#define SAMPLE_MIRROR 2u
#define SAMPLE_ROUGH_R 3u
#define SAMPLE_DIFFUSE_T 4u  // into the hemisphere behind
#define SAMPLE_ROUGH_T 5u
#define SAMPLE_REFRACT 6u
#define LOBES_TO_SAMPLE 7u

// The sampled lobe and direction.
STRUCT(LobeSample) {
    uint type;
    float3 dir;
    float3 color;     // of the lobe
    float weight;     // of the radiance found, besides the colour; 0: no valid direction
    float prob;       // in units of total
    float total;      // of the weights of all lobes
    Mixture mixture;  // of a diffuse one
};

FN int lobe_is_diffuse(PRIVATE(const LobeSample) lobe) {
    return lobe->type == SAMPLE_DIFFUSE_R || lobe->type == SAMPLE_DIFFUSE_T;
}

FN float lobe_weight(float3 color) {
    float m = max3(color);
    return m > 0.0f ? m : 0.0f;
}

// In MODE_IMAGE all specular lobes are equally likely, and there are no others.  Returns their number.
FN float image_lobes(PRIVATE(float) weight) {
    float count = 0.0f;
    for (UNIFORM uint lobe = 0u; lobe < LOBES_TO_SAMPLE; lobe++) {
        int specular = lobe == SAMPLE_THROUGH || lobe == SAMPLE_MIRROR || lobe == SAMPLE_REFRACT;
        weight[lobe] = specular && weight[lobe] > 0.0f ? 1.0f : 0.0f;
        count += weight[lobe];
    }

    return count;
}

// Raises the weight of each lobe that exists to this least value.  Returns the new sum.
FN float lobes_raise(float least, PRIVATE(float) weight) {
    float sum = 0.0f;
    for (UNIFORM uint lobe = 0u; lobe < LOBES_TO_SAMPLE; lobe++) {
        if (weight[lobe] > 0.0f) weight[lobe] = MAX_(weight[lobe], least);
        sum += weight[lobe];
    }

    return sum;
}

// Weights of the lobes and their sum; 0: there is none. The fourth internal reflection of a pane is rare (one path in
// millions), and usually dark.  Tests that look for it set a least probability; pictures do not.
FN float lobe_weights(PARAMS(const Params) par, PRIVATE(const Vertex) vertex, PRIVATE(float) weight) {
    PRIVATE(const Lobes) lobes = &vertex->lobes;
    int diffuse = (int)path_bounces(vertex->flags) < par->ab && par->mode != MODE_DIRECT;

    weight[SAMPLE_DIFFUSE_R] = diffuse ? lobe_weight(lobes->ambient_r) : 0.0f;
    weight[SAMPLE_DIFFUSE_T] = diffuse ? lobe_weight(lobes->ambient_t) : 0.0f;
    weight[SAMPLE_ROUGH_R] = (lobes->flags & LOBE_SAMPLE_R) != 0u ? lobe_weight(lobes->rough_r) : 0.0f;
    weight[SAMPLE_ROUGH_T] = (lobes->flags & LOBE_SAMPLE_T) != 0u ? lobe_weight(lobes->rough_t) : 0.0f;
    weight[SAMPLE_THROUGH] = lobe_weight(lobes->through);
    weight[SAMPLE_MIRROR] = lobe_weight(lobes->mirror);
    weight[SAMPLE_REFRACT] = lobe_weight(lobes->refract);

    // a solid's boundary splits energy; radiance is larger inside by the index squared, which does not matter here
    if (weight[SAMPLE_REFRACT] > 0.0f && (vertex->g.type == M_DIELECTRIC || vertex->g.type == M_INTERFACE))
        weight[SAMPLE_REFRACT] = 1.0f - weight[SAMPLE_MIRROR];

    float sum = weight[SAMPLE_MIRROR] + weight[SAMPLE_THROUGH] + weight[SAMPLE_REFRACT] + weight[SAMPLE_DIFFUSE_R] +
                weight[SAMPLE_DIFFUSE_T] + weight[SAMPLE_ROUGH_R] + weight[SAMPLE_ROUGH_T];
    if (par->mode == MODE_IMAGE) return image_lobes(weight);
    return par->least_lobe_prob > 0.0f ? lobes_raise(par->least_lobe_prob * sum, weight) : sum;
}

FN uint pick_lobe(PRIVATE(const float) weight, float r) {
    for (UNIFORM uint lobe = 0u; lobe < LOBES_TO_SAMPLE - 1u; lobe++)
        if ((r -= weight[lobe]) < 0.0f) return lobe;
    return LOBES_TO_SAMPLE - 1u;
}

// Samples a direction of the rough reflected lobe; returns its weight. RADIANCE weights a rough lobe where the ray's
// weight allows two samples or more (-ss times the weight); here one sample has that weight (spec shading 3.4).
FN float sample_rough_r(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Vertex) vertex,
                        PRIVATE(LobeSample) lobe) {
    PRIVATE(Lobes) lobes = &vertex->lobes;
    PRIVATE(Surface) g = &vertex->g;
    int weighted = !path_sampled(vertex->flags) && par->ss * vertex->weight > 1.5f;
    if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(lobes, g, WGMD_ROUGH_R);
    if ((lobes->flags & LOBE_ASHIK) != 0u) return ashik_sample(lobes, g, &vertex->rnd, &lobe->dir);
    if ((lobes->flags & LOBE_BSDF) != 0u)
        return bsdf_sample_lobe(s, lobes, g, 0, &vertex->rnd, &lobe->color, &lobe->dir);
    return lobes_sample_rough_r(lobes, g, &vertex->rnd, weighted, par->ss, &lobe->dir);
}

FN float sample_rough_t(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Vertex) vertex,
                        PRIVATE(LobeSample) lobe) {
    PRIVATE(Lobes) lobes = &vertex->lobes;
    PRIVATE(Surface) g = &vertex->g;
    if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(lobes, g, WGMD_ROUGH_T);
    if ((lobes->flags & LOBE_BSDF) != 0u)
        return bsdf_sample_lobe(s, lobes, g, 1, &vertex->rnd, &lobe->color, &lobe->dir);
    return lobes_sample_rough_t(lobes, g, &vertex->rnd, par->ss, &lobe->dir);
}

// Samples a direction about n on either side; returns its weight, 0 if the direction lies below the geometric surface.
FN float sample_hemisphere(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Vertex) vertex, float side,
                           PRIVATE(LobeSample) lobe) {
    PRIVATE(const Surface) g = &vertex->g;
    float3 n = side > 0.0f ? g->n : neg3(g->n);
    float factor = sample_diffuse(s, par, g->p, n, &vertex->rnd, &lobe->mixture, &lobe->dir);
    return side * dot3(lobe->dir, g->ng) <= 0.0f ? 0.0f : factor;
}

// Direction, colour and weight of the sampled lobe, and the flags of the path after it.
FN void sample_chosen_lobe(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Vertex) vertex,
                           PRIVATE(LobeSample) lobe) {
    PRIVATE(Lobes) lobes = &vertex->lobes;
    lobe->weight = 1.0f;
    lobe->dir = vertex->ray.dir;

    switch (lobe->type) {
    case SAMPLE_DIFFUSE_R:
        lobe->color = lobes->ambient_r;
        lobe->weight = sample_hemisphere(s, par, vertex, 1.0f, lobe);
        break;
    case SAMPLE_DIFFUSE_T:
        lobe->color = lobes->ambient_t;
        if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(lobes, &vertex->g, WGMD_DIFFUSE_T);
        lobe->weight = sample_hemisphere(s, par, vertex, -1.0f, lobe);
        break;
    case SAMPLE_ROUGH_R:
        lobe->color = lobes->rough_r;
        lobe->weight = sample_rough_r(s, par, vertex, lobe);
        break;
    case SAMPLE_ROUGH_T:
        lobe->color = lobes->rough_t;
        lobe->weight = sample_rough_t(s, par, vertex, lobe);
        break;
    case SAMPLE_THROUGH:
        lobe->color = lobes->through;
        lobe->dir = lobes->through_dir;
        break;
    case SAMPLE_MIRROR:
        lobe->color = lobes->mirror;
        lobe->dir = lobes->mirror_dir;
        break;
    default:
        lobe->color = lobes->refract;
        lobe->dir = lobes->refract_dir;
        break;
    }

    if (lobe->prob <= 0.0f) lobe->weight = 0.0f;
}

// Returns 1 if the path stays in the medium before the surface, whatever a steep texture makes of its direction.
FN int lobe_reflects(uint lobe) { return lobe == SAMPLE_DIFFUSE_R || lobe == SAMPLE_ROUGH_R || lobe == SAMPLE_MIRROR; }

// Flags of the path once it follows this lobe.
FN uint lobe_path_flags(PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    uint flags = vertex->flags;
    if (lobe_is_diffuse(lobe)) flags = count_bounce(flags | PC_DIFFUSE);
    else if (lobe->type == SAMPLE_ROUGH_R || lobe->type == SAMPLE_ROUGH_T) flags |= PC_ROUGH | PC_BENT;
    else if (lobe->type != SAMPLE_THROUGH || dot3(lobe->dir, vertex->g.v) > -0.99999f) flags |= PC_BENT;

    int through = lobe->type == SAMPLE_THROUGH || lobe->type == SAMPLE_ROUGH_T || lobe->type == SAMPLE_REFRACT;
    return through ? flags : count_level(flags);
}

// Samples a lobe and a direction.  Returns 0 if there is none and the path ends.
FN int sample_lobe(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                   PRIVATE(Vertex) vertex, PRIVATE(LobeSample) lobe) {
    float weight[LOBES_TO_SAMPLE];
    lobe->total = lobe_weights(par, vertex, weight);
    if (lobe->total <= 0.0f) return 0;

    float number = par->mode == MODE_IMAGE ? image_way(paths, vertex->path, lobe->total) : sample1(&vertex->rnd);
    lobe->type = pick_lobe(weight, number * lobe->total);
    lobe->prob = weight[lobe->type];
    sample_chosen_lobe(s, par, vertex, lobe);
    vertex->flags = lobe_path_flags(vertex, lobe);
    return 1;
}
#endif
