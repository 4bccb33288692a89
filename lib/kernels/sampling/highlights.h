// SPDX-License-Identifier: BSD-3-Clause
// Technique of highlights: samples the cones of sunlit rectangles (lib/sampling/highlights.h) that are visible from a
// point.  A smooth rough plane reflects the sun into a narrow cone about one direction, the same everywhere, which
// cosine sampling hits once in hundreds of samples.
#ifndef LUX_HIGHLIGHTS_H
#define LUX_HIGHLIGHTS_H

#define HIGHLIGHT_SPREAD2 9.0f    // squared, in roughnesses: a rectangle this far from its cone is still sampled
#define HIGHLIGHT_FARTHEST 20.0f  // squared slope over squared roughness; the pdf is 0 above

FN float3 highlight_sun(GLOBAL const Highlight* h) {
    float3 n = f3_of(h->normal), dir = f3_of(h->dir);
    return sub3(dir, scale3(n, 2.0f * dot3(n, dir)));
}

// Returns 1 if the mirrored sun of this rectangle is above the surface with normal n at p.  Cheap tests come first.
FN int highlight_met(GLOBAL const Highlight* h, float3 p, float3 n) {
    float3 dir = f3_of(h->dir);
    if (dot3(dir, n) <= 0.0f) return 0;
    float3 plane = f3_of(h->normal), off = sub3(p, f3_of(h->corner));
    float height = dot3(off, plane);
    if (!(height > 0.0f)) return 0;

    float inv = -1.0f / dot3(plane, dir);
    float t = height * inv;
    float wide = t * inv;
    float3 at = madd3(dir, t, off), u = f3_of(h->u), v = f3_of(h->v);
    float uu = dot3(u, u), vv = dot3(v, v), a = dot3(at, u), b = dot3(at, v);
    float beside_u = MAX_(MAX_(-a, a - uu), 0.0f), beside_v = MAX_(MAX_(-b, b - vv), 0.0f);
    float far2 = HIGHLIGHT_SPREAD2 * h->alpha2 * wide * wide;
    return beside_u * beside_u <= far2 * uu && beside_v * beside_v <= far2 * vv;
}

// Rectangles that can be sampled, one bit each.
FN uint highlights_met(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n) {
    uint met = 0u;
    for (UNIFORM uint k = 0u; k < par->highlights_count; k++)
        if (highlight_met(&s->highlights[k], p, n)) met |= 1u << k;
    return met;
}

FN uint highlights_count(uint met) {
    uint count = 0u;
    for (; met != 0u; met &= met - 1u) count++;
    return count;
}

FN float highlights_weight(PARAMS(const Params) par, uint met) { return met != 0u ? par->highlight_share : 0.0f; }

// Samples a direction toward one of them.  The half vector between the sun and the viewer is a normal of the rough
// plane, whose slopes have a Gaussian distribution.
FN float3 highlights_sample(TABLES(const SceneTables) s, uint met, float x, float y) {
    float choice = x * (float)highlights_count(met);
    uint pick = 0u;
    while ((met & 1u) == 0u || (choice >= 1.0f && (met & (met - 1u)) != 0u)) {
        if ((met & 1u) != 0u) choice -= 1.0f;
        met >>= 1;
        pick++;
    }

    GLOBAL const Highlight* h = &s->highlights[pick];
    float3 n = f3_of(h->normal), sun = highlight_sun(h), e1, e2;
    float sn, cs, slope = sqrt_(-h->alpha2 * k_log(MAX_(1.0f - choice, 1e-7f)));
    orthonormal_basis(n, &e1, &e2);
    k_sincos(K_TURN * y, &sn, &cs);
    float3 half_way = unit3(add3(n, add3(scale3(e1, slope * cs), scale3(e2, slope * sn))));
    return sub3(sun, scale3(half_way, 2.0f * dot3(half_way, sun)));
}

// Pdf (per sr) of directions toward one rectangle.
FN float highlight_pdf(GLOBAL const Highlight* h, float3 dir) {
    float3 n = f3_of(h->normal), sun = highlight_sun(h);
    float3 half_way = sub3(sun, dir);
    float alpha2 = h->alpha2, hn = dot3(half_way, n), hs = dot3(half_way, sun);
    if (!(hn > 0.0f && hs > 0.0f)) return 0.0f;
    float3 off = sub3(half_way, scale3(n, hn));  // not hh - hn^2: sharp lobes would see its rounding
    float far = dot3(off, off) / (hn * hn * alpha2);
    if (!(far < HIGHLIGHT_FARTHEST)) return 0.0f;

    float hh = dot3(half_way, half_way), inv = 1.0f / hn;
    return k_exp(-far) * K_INV_PI / alpha2 * hh * hh * inv * inv * inv / (4.0f * hs);
}

// Pdf of direction dir among those toward the rectangles of `met`.
FN float highlights_pdf(TABLES(const SceneTables) s, uint met, float3 dir) {
    float sum = 0.0f;
    for (uint k = 0u, left = met; left != 0u; k++, left >>= 1)
        if ((left & 1u) != 0u) sum += highlight_pdf(&s->highlights[k], dir);
    return sum / (float)highlights_count(met);
}
#endif
