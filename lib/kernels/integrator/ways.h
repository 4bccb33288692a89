// SPDX-License-Identifier: BSD-3-Clause
// The seven ways on from a surface, of which a path takes one, with a chance in proportion to what the surface sends
// along it.
#ifndef LUX_PATH_WAYS_H
#define LUX_PATH_WAYS_H

// in the order in which one random number chooses
#define WAY_DIFFUSE_R 0u  // into the hemisphere on the viewer's side
#define WAY_THROUGH 1u    // straight on, or bent by a texture
#define WAY_MIRROR 2u
#define WAY_ROUGH_R 3u
#define WAY_DIFFUSE_T 4u  // into the hemisphere behind
#define WAY_ROUGH_T 5u
#define WAY_REFRACT 6u
#define WAYS 7u

// What is known of the way taken.
STRUCT(Way) {
    uint way;
    float3 dir;
    float3 color;  // of the lobe
    float factor;  // of the sampled radiance beside the colour; 0: the sample is lost
    float chance;  // in units of sum
    float sum;
    Aims aims;  // of a diffuse one
};

FN int way_bounces(PRIVATE(const Way) way) { return way->way == WAY_DIFFUSE_R || way->way == WAY_DIFFUSE_T; }

FN float way_weight(float3 color) {
    float m = max3(color);
    return m > 0.0f ? m : 0.0f;
}

// Each way that there is gets at least this weight.  Returns the new sum.
FN float ways_raise(float least, PRIVATE(float) weight) {
    float sum = 0.0f;
    for (SAME uint way = 0u; way < WAYS; way++) {
        if (weight[way] > 0.0f) weight[way] = MAX_(weight[way], least);
        sum += weight[way];
    }

    return sum;
}

// How likely each way is, and the sum; 0: there is none.
// Light that comes by the fourth reflection in a pane is rare: one path in millions finds it.  Tests that look for it
// give each way a least chance; pictures do not, for what is rare here is dark as a rule.
FN float ways_weigh(UNIFORM(const Params) par, PRIVATE(const Vertex) vertex, PRIVATE(float) weight) {
    PRIVATE(const Lobes) lobes = &vertex->lobes;
    int bounces = (int)((vertex->flags >> PC_AB_SHIFT) & 255u);
    int diffuse = bounces < par->ab && par->mode != MODE_DIRECT;

    weight[WAY_DIFFUSE_R] = diffuse ? way_weight(lobes->ambient_r) : 0.0f;
    weight[WAY_DIFFUSE_T] = diffuse ? way_weight(lobes->ambient_t) : 0.0f;
    weight[WAY_ROUGH_R] = (lobes->flags & LOBE_SAMPLE_R) != 0u ? way_weight(lobes->rough_r) : 0.0f;
    weight[WAY_ROUGH_T] = (lobes->flags & LOBE_SAMPLE_T) != 0u ? way_weight(lobes->rough_t) : 0.0f;
    weight[WAY_THROUGH] = way_weight(lobes->through);
    weight[WAY_MIRROR] = way_weight(lobes->mirror);
    weight[WAY_REFRACT] = way_weight(lobes->refract);

    // a solid's surface shares out energy; that radiance is greater inside, by the index squared, does not matter
    if (weight[WAY_REFRACT] > 0.0f && (vertex->g.type == M_DIELECTRIC || vertex->g.type == M_INTERFACE))
        weight[WAY_REFRACT] = 1.0f - weight[WAY_MIRROR];

    float sum = weight[WAY_MIRROR] + weight[WAY_THROUGH] + weight[WAY_REFRACT] + weight[WAY_DIFFUSE_R] +
                weight[WAY_DIFFUSE_T] + weight[WAY_ROUGH_R] + weight[WAY_ROUGH_T];
    return par->way_least > 0.0f ? ways_raise(par->way_least * sum, weight) : sum;
}

FN uint way_pick(PRIVATE(const float) weight, float r) {
    for (SAME uint way = 0u; way < WAYS - 1u; way++)
        if ((r -= weight[way]) < 0.0f) return way;
    return WAYS - 1u;
}

// A direction of the reflected rough lobe; returns the factor.
// RADIANCE weights a rough lobe where its ray's weight earns it two samples or more, -ss times the weight; what several
// samples or a hemisphere of them sent out earns one (spec shading 3.4).
FN float sample_rough_r(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Vertex) vertex,
                        PRIVATE(Way) way) {
    PRIVATE(Lobes) lobes = &vertex->lobes;
    PRIVATE(Surface) g = &vertex->g;
    int weighted = !path_sampled(vertex->flags) && par->ss * vertex->weight > 1.5f;
    if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(lobes, g, WGMD_ROUGH_R);
    if ((lobes->flags & LOBE_ASHIK) != 0u) return ashik_sample(lobes, g, &vertex->rnd, &way->dir);
    if ((lobes->flags & LOBE_BSDF) != 0u)
        return bsdf_sample_lobe(s, par, lobes, g, 0, &vertex->rnd, &way->color, &way->dir);
    return lobes_sample_rough_r(lobes, g, &vertex->rnd, weighted, par->ss, &way->dir);
}

FN float sample_rough_t(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Vertex) vertex,
                        PRIVATE(Way) way) {
    PRIVATE(Lobes) lobes = &vertex->lobes;
    PRIVATE(Surface) g = &vertex->g;
    if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(lobes, g, WGMD_ROUGH_T);
    if ((lobes->flags & LOBE_BSDF) != 0u)
        return bsdf_sample_lobe(s, par, lobes, g, 1, &vertex->rnd, &way->color, &way->dir);
    return lobes_sample_rough_t(lobes, g, &vertex->rnd, par->ss, &way->dir);
}

// A direction about n on either side of the surface; returns the factor, 0 if it is on the wrong side of the geometry.
FN float sample_hemisphere(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Vertex) vertex, float side,
                           PRIVATE(Way) way) {
    PRIVATE(const Surface) g = &vertex->g;
    float3 n = side > 0.0f ? g->n : neg3(g->n);
    float factor = sample_diffuse(s, par, g->p, n, &vertex->rnd, &way->aims, &way->dir);
    return side * dot3(way->dir, g->ng) <= 0.0f ? 0.0f : factor;
}

// The direction, colour and factor of the way taken, and what the path is from here on.
FN void way_sample(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Vertex) vertex, PRIVATE(Way) way) {
    PRIVATE(Lobes) lobes = &vertex->lobes;
    way->factor = 1.0f;
    way->dir = vertex->ray.dir;

    switch (way->way) {
    case WAY_DIFFUSE_R:
        way->color = lobes->ambient_r;
        way->factor = sample_hemisphere(s, par, vertex, 1.0f, way);
        break;
    case WAY_DIFFUSE_T:
        way->color = lobes->ambient_t;
        if ((lobes->flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(lobes, &vertex->g, WGMD_DIFFUSE_T);
        way->factor = sample_hemisphere(s, par, vertex, -1.0f, way);
        break;
    case WAY_ROUGH_R:
        way->color = lobes->rough_r;
        way->factor = sample_rough_r(s, par, vertex, way);
        break;
    case WAY_ROUGH_T:
        way->color = lobes->rough_t;
        way->factor = sample_rough_t(s, par, vertex, way);
        break;
    case WAY_THROUGH:
        way->color = lobes->through;
        way->dir = lobes->through_dir;
        break;
    case WAY_MIRROR:
        way->color = lobes->mirror;
        way->dir = lobes->mirror_dir;
        break;
    default:
        way->color = lobes->refract;
        way->dir = lobes->refract_dir;
        break;
    }

    if (way->chance <= 0.0f) way->factor = 0.0f;
}

// Whether it stays before the surface, in the medium there; steep textures may turn its direction all the same.
FN int way_reflects(uint way) { return way == WAY_DIFFUSE_R || way == WAY_ROUGH_R || way == WAY_MIRROR; }

// What the path has been through once it takes this way.
FN uint way_flags(PRIVATE(const Vertex) vertex, PRIVATE(const Way) way) {
    uint flags = vertex->flags;
    if (way_bounces(way)) flags = (flags | PC_DIFFUSE) + (1u << PC_AB_SHIFT);
    else if (way->way == WAY_ROUGH_R || way->way == WAY_ROUGH_T) flags |= PC_ROUGH | PC_BENT;
    else if (way->way != WAY_THROUGH || dot3(way->dir, vertex->g.v) > -0.99999f) flags |= PC_BENT;

    int through = way->way == WAY_THROUGH || way->way == WAY_ROUGH_T || way->way == WAY_REFRACT;
    return through ? flags : flags + (1u << PC_LEVEL_SHIFT);
}

// Chooses a way and a direction along it.  0: there is none, the path ends.
FN int choose_way(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Vertex) vertex, PRIVATE(Way) way) {
    float weight[WAYS];
    way->sum = ways_weigh(par, vertex, weight);
    if (way->sum <= 0.0f) return 0;

    way->way = way_pick(weight, sample1(&vertex->rnd) * way->sum);
    way->chance = weight[way->way];
    way_sample(s, par, vertex, way);
    vertex->flags = way_flags(vertex, way);
    return 1;
}
#endif
