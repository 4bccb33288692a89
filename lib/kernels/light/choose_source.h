// SPDX-License-Identifier: BSD-3-Clause
// Chooses the active source of a shadow ray, with a probability in proportion to its importance at the point (power,
// solid angle, cosines, the apertures that the light of a virtual source must pass).  A few sources are all evaluated,
// many stand in a tree (light_tree.h).  Unbiased for any importance that is positive wherever the source can add light.
#ifndef LUX_CHOOSE_SOURCE_H
#define LUX_CHOOSE_SOURCE_H

#define LEAST_COSINE 0.05f  // a source behind the surface or on edge may still be visible through it or at its rim

// Importance of source i at p with normal n, up to a factor; both: also from behind.
FN float source_importance(TABLES(const SceneTables) s, PARAMS(const Params) par, UNIFORM uint i, float3 p, float3 n,
                           int both) {
    GLOBAL const float* UNIFORM src = s->f + par->sources_at + SOURCE_FLOATS * i;
    UNIFORM uint kind = as_uint_(src[SRC_KIND]), relay = as_uint_(src[SRC_VIRTUAL]);
    float3 to = f3_at(src + SRC_CENTRE);
    float r = src[SRC_RADIUS], power = src[SRC_POWER] * src[SRC_AREA], d2 = 1.0f, d = 1.0f;
    if (kind == SK_CYLINDER) r += length3(f3_at(src + SRC_U));
    if (src[SRC_SHEARED] != 0.0f)  // no more than the distance of any sampled point
        r = 2.0f * (length3(f3_at(src + SRC_U)) + length3(f3_at(src + SRC_V)) + length3(f3_at(src + SRC_NORMAL)));

    if (kind != SK_DISTANT) {
        to = sub3(to, p);
        d2 = dot3(to, to);
        d = sqrt_(d2);
        if (src[SRC_MAXRAD] > 0.0f && d > src[SRC_MAXRAD] + r) return 0.0f;
        power /= MAX_(d2, 0.25f * r * r);
    }

    float sine = r / MAX_(d, 1e-9f);  // sine of its half angle
    if (relay != NONE) {
        UNIFORM uint count = s->u[relay + RELAY_APERTURES];
        GLOBAL const float* UNIFORM aperture = s->f + s->u[relay + RELAY_APERTURES_AT];
        for (UNIFORM uint k = 0u; k < count; k++, aperture += APERTURE_FLOATS)
            if (aperture_occludes(aperture, p, to, sine, 0)) return 0.0f;
    }

    if (kind == SK_PARALLELOGRAM || kind == SK_POLYGON || kind == SK_RING) {
        float c = -dot3(to, f3_at(src + SRC_NORMAL));
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
    uint count = par->source_count, picked = 0u;
    if (count == 0u) return 0.0f;
    if (count == 1u) {
        *chosen = 0u;
        return 1.0f;
    }

    float2 x = sample2(rnd);
    if (par->light_nodes > 0u) return choose_light(s, par, p, n, both, x, chosen);

    float sum = 0.0f, kept = 0.0f, r = x.x;
    for (UNIFORM uint i = 0u; i < par->source_count; i++) {
        float w = source_importance(s, par, i, p, n, both);
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
