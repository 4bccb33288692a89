// SPDX-License-Identifier: BSD-3-Clause
// Chooses the active source of a shadow ray, with a probability in proportion to its importance at the point (power,
// solid angle, cosines, the apertures that the light of a virtual source must pass).  A few sources are all evaluated,
// many stand in a tree (light_tree.h).  Unbiased for any importance that is positive wherever the source can add light.
#ifndef LUX_CHOOSE_SOURCE_H
#define LUX_CHOOSE_SOURCE_H

#define LEAST_COSINE 0.05f  // a source behind the surface or on edge may still be visible through it or at its rim

// Importance of source i at p with normal n, up to a factor; both: also from behind.
FN float source_importance(TABLES(const SceneTables) s, UNIFORM uint i, float3 p, float3 n, int both) {
    GLOBAL const Source* UNIFORM src = &s->sources[i];
    UNIFORM uint kind = src->kind, relay = src->relay;
    float3 to = f3_of(src->centre);
    float r = src->radius, power = src->power * src->area, d2 = 1.0f, d = 1.0f;
    if (kind == SK_CYLINDER) r += length3(f3_of(src->u));
    if (src->sheared != 0u)  // no more than the distance of any sampled point
        r = 2.0f * (length3(f3_of(src->u)) + length3(f3_of(src->v)) + length3(f3_of(src->normal)));

    if (kind != SK_DISTANT) {
        to = sub3(to, p);
        d2 = dot3(to, to);
        d = sqrt_(d2);
        if (src->max_radius > 0.0f && d > src->max_radius + r) return 0.0f;
        power /= MAX_(d2, 0.25f * r * r);
    }

    float sine = r / MAX_(d, 1e-9f);  // sine of its half angle
    if (relay != NONE) {
        UNIFORM uint first = s->relays[relay].aperture_at, count = s->relays[relay].aperture_count;
        for (UNIFORM uint k = first; k < first + count; k++)
            if (aperture_occludes(&s->apertures[k], p, to, sine, 0)) return 0.0f;
    }

    if (kind == SK_PARALLELOGRAM || kind == SK_POLYGON || kind == SK_RING) {
        float c = -dot3(to, f3_of(src->normal));
        if (c <= 0.0f) return 0.0f;
        power *= MIN_(c / MAX_(d, 1e-9f) + sine, 1.0f);
    }

    float c = dot3(to, n) / MAX_(d, 1e-9f);
    c = (both ? fabs_(c) : c) + sine;
    return power * MIN_(MAX_(c, 0.0f) + LEAST_COSINE, 1.0f);
}

// Chooses an active source for a surface at p with normal n, lit from both sides or one.  Returns 1/probability, or 0
// if no source can light it.
FN float choose_source(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, int both,
                       PRIVATE(Sampler) rnd, PRIVATE(uint) chosen) {
    uint count = par->sources_count, picked = 0u;
    if (count == 0u) return 0.0f;
    if (count == 1u) {
        *chosen = 0u;
        return 1.0f;
    }

    float2 x = sample2(rnd);
    if (par->light_nodes_count > 0u) return choose_light(s, par, p, n, both, x, chosen);

    float sum = 0.0f, kept = 0.0f, r = x.x;
    for (UNIFORM uint i = 0u; i < par->sources_count; i++) {
        float w = source_importance(s, i, p, n, both);
        if (w <= 0.0f) continue;
        sum += w;
        if (!reservoir_accept(w / sum, &r)) continue;
        picked = i;
        kept = w;
    }

    if (sum <= 0.0f) return 0.0f;
    *chosen = picked;
    return sum / kept;
}
#endif
