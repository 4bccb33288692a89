// SPDX-License-Identifier: BSD-3-Clause
// Samples the direction of diffuse light by a mixture of techniques: by the cosine, toward portals, toward highlights.
// One-sample multiple importance sampling with the balance heuristic (Veach 1997, section 9.2.4): the pdf is that of
// the mixture, so the estimator is unbiased for any weights.  A technique is a file of NAME_weight, NAME_sample and
// NAME_pdf; to add one: CONTRIBUTING.md.  lib/sampling/mixture_weights.h chooses the weights.
#ifndef LUX_MIXTURE_H
#define LUX_MIXTURE_H

#include "kernels/sampling/highlights.h"
#include "kernels/sampling/portals.h"

// Direction about n, by the cosine.
FN float3 cosine_sample(float3 n, float x, float turn) {
    float3 e1, e2;
    float sn, cs, r = sqrt_(x), z = sqrt_(1.0f - x > 0.0f ? 1.0f - x : 0.0f);
    orthonormal_basis(n, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(n, z), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

FN Mixture mixture_at(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n) {
    Mixture mixture;
    mixture.light = portals_light(s, par, p, n);
    mixture.highlights = par->highlight_share > 0.0f ? highlights_met(s, par, p, n) : 0u;
    return mixture;
}

// Pdf (per sr) of direction dir about n from p for diffuse rays.
FN float diffuse_pdf(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Mixture) mixture, float3 p,
                     float3 n, float3 dir) {
    float c = dot3(dir, n);
    float pdf = c * K_INV_PI;
    float w = portals_weight(par, mixture->light);
    if (w > 0.0f) pdf = (1.0f - w) * c * K_INV_PI + w * portals_pdf(s, par, p, n, dir, mixture->light);
    w = highlights_weight(par, mixture->highlights);
    if (w > 0.0f) pdf = (1.0f - w) * pdf + w * highlights_pdf(s, mixture->highlights, dir);
    return pdf;
}

// Chooses a technique of this weight by the random number *u, which becomes a new one.
FN int mixture_takes(PRIVATE(float) u, float weight) {
    if (!(weight > 0.0f)) return 0;
    int taken = *u < weight;
    *u = taken ? *u / weight : (*u - weight) / (1.0f - weight);
    return taken;
}

// Samples a direction over the hemisphere of n.  Returns cos/(pi pdf), the weight of the diffuse coefficient.
// *mixture: as at p.
FN float sample_diffuse(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, PRIVATE(Sampler) rnd,
                        PRIVATE(Mixture) mixture, PRIVATE(float3) dir) {
    float2 x = sample2(rnd);
    float u = x.x;
    *mixture = mixture_at(s, par, p, n);

    if (mixture_takes(&u, highlights_weight(par, mixture->highlights))) {
        *dir = highlights_sample(s, mixture->highlights, u, x.y);
        if (!(highlights_pdf(s, mixture->highlights, *dir) > 0.0f)) return 0.0f;
    } else if (mixture_takes(&u, portals_weight(par, mixture->light))) {
        *dir = portals_sample(s, par, p, n, u * mixture->light, x.y);
    } else {
        *dir = cosine_sample(n, u, x.y);
    }
    float c = dot3(*dir, n);
    if (c <= 0.0f) return 0.0f;
    return c * K_INV_PI / diffuse_pdf(s, par, mixture, p, n, *dir);
}
#endif
