// SPDX-License-Identifier: BSD-3-Clause
// Directions for diffuse light: a share of them toward "portals", windows, patches of sun and narrow glossy reflectors
// in it, the others by the cosine, one mixed pdf, so that the estimator stays unbiased whatever portals and share are
// (one-sample multiple importance sampling with the balance heuristic, Veach 1997, section 9.2.4).
// sampling/portal_lights.h finds the share.
// Another share goes toward highlights (highlights.h).
// Most light of a daylit room comes from a small solid angle: this is where noise goes.
#ifndef LUX_PORTALS_H
#define LUX_PORTALS_H

FN GLOBAL const float* portal_record(TABLES(const SceneTables) s, PARAMS(const Params) par, uint k) {
    return s->f + par->portals_at + PORTAL_FLOATS * par->portal_pick[k];
}

// Seen from p, how bright is the sun's highlight on a polished rectangle, 1 where it is brightest?  *to, from p to its
// middle, becomes the way to its brightest place: where the mirrored sun stands, or what of the rectangle is next to
// that.  height: of p above its plane.
FN float portal_gloss(GLOBAL const float* portal, float height, PRIVATE(float3) to) {
    float s = height / portal[PORTAL_MIRRORED_OUT];

    // over the plane toward the mirrored sun, as far as that or to the rectangle
    float3 along_u = f3_at(portal + PORTAL_ALONG_U), along_v = f3_at(portal + PORTAL_ALONG_V);
    float a = -dot3(*to, along_u), b = -dot3(*to, along_v);
    float inv_a = portal[PORTAL_MIRRORED_PER_U], inv_b = portal[PORTAL_MIRRORED_PER_V];
    float a0 = (-0.5f - a) * inv_a, a1 = (0.5f - a) * inv_a, b0 = (-0.5f - b) * inv_b, b1 = (0.5f - b) * inv_b;
    float first = MAX_(MAX_(MIN_(a0, a1), MIN_(b0, b1)), 0.0f), last = MIN_(MAX_(a0, a1), MAX_(b0, b1));
    if (first <= last) s = MIN_(MAX_(s, first), last);
    a = MIN_(MAX_(a + s * portal[PORTAL_MIRRORED_U], -0.5f), 0.5f);
    b = MIN_(MAX_(b + s * portal[PORTAL_MIRRORED_V], -0.5f), 0.5f);
    *to = madd3(f3_at(portal + PORTAL_V), b, madd3(f3_at(portal + PORTAL_U), a, *to));

    float3 half_way = sub3(f3_at(portal + PORTAL_SUN), unit3(*to));
    float hn = -dot3(half_way, f3_at(portal + PORTAL_NORMAL));
    if (!(hn > 0.0f)) return 0.0f;
    float far = (dot3(half_way, half_way) - hn * hn) / (hn * hn * portal[PORTAL_GLOSS2]);
    if (!(far < HIGHLIGHT_FARTHEST)) return 0.0f;
    return k_exp(-far);
}

// How much of the view from p a portal takes up, with the cosines at both ends, about; 0 from behind it.
FN float portal_view(GLOBAL const float* portal, float3 p, float3 n) {
    float3 to = sub3(f3_at(portal + PORTAL_CENTRE), p);
    float height = dot3(to, f3_at(portal + PORTAL_NORMAL));
    if (height <= 1e-4f) return 0.0f;  // at or beyond the glass
    float bright = 1.0f;
    if (portal[PORTAL_GLOSS2] > 0.0f) {
        bright = portal_gloss(portal, height, &to);
        if (!(bright > 0.0f)) return 0.0f;
    }

    // its height above the surface's horizon; where the horizon cuts it, about that of the part above
    float e = dot3(to, n);
    float reach = 0.5f * (fabs_(dot3(f3_at(portal + PORTAL_U), n)) + fabs_(dot3(f3_at(portal + PORTAL_V), n)));
    if (e + reach <= 0.0f) return 0.0f;
    if (e < reach) e = 0.25f * (e + reach) * (e + reach) / reach;
    float area = portal[PORTAL_AREA];
    float d2 = MAX_(dot3(to, to), 0.25f * area);
    return bright * area * height * e / (d2 * d2);
}

// Density (per sr) with which a uniform point on portal k lies in direction dir from p; 0 if dir misses it.
FN float portal_pdf(GLOBAL const float* portal, float3 p, float3 dir) {
    float3 out = f3_at(portal + PORTAL_NORMAL), to = sub3(f3_at(portal + PORTAL_CENTRE), p);
    float c = dot3(dir, out), h = dot3(to, out);
    if (c <= 1e-6f || h <= 0.0f) return 0.0f;
    float t = h / c;
    float3 off = sub3(scale3(dir, t), to);
    float along_u = dot3(off, f3_at(portal + PORTAL_ALONG_U)), along_v = dot3(off, f3_at(portal + PORTAL_ALONG_V));
    if (fabs_(along_u) > 0.5f || fabs_(along_v) > 0.5f) return 0.0f;
    return t * t / (portal[PORTAL_AREA] * c);
}

// Light that comes to p through all portals.
FN float portals_light(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n) {
    float total = 0.0f;
    for (UNIFORM uint k = 0u; k < par->portal_count; k++)
        total += par->portal_light[k] * portal_view(portal_record(s, par, k), p, n);
    return total;
}

// The share of the directions that aim at portals, whose light sums to `total`.
FN float portals_share(PARAMS(const Params) par, float total) {
    if (!(total > 0.0f)) return 0.0f;
    return MIN_(MAX_(total / (total + par->portal_rest), par->portal_least), par->portal_most);
}

// Density (per sr) of direction dir from p among those toward portals, whose light sums to `total`.
FN float portals_pdf(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, float3 dir,
                     float total) {
    float pdf = 0.0f;
    for (UNIFORM uint k = 0u; k < par->portal_count; k++) {
        GLOBAL const float* portal = portal_record(s, par, k);
        float d = portal_pdf(portal, p, dir);
        if (d > 0.0f) pdf += par->portal_light[k] * portal_view(portal, p, n) / total * d;
    }

    return pdf;
}

// The direction from p to a point of a portal, which r, 0 .. the sum of their light, picks by its light.
FN float3 portal_direction(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, float r,
                           float across) {
    float before = 0.0f, w = 0.0f;
    uint pick = 0u;

    for (UNIFORM uint k = 0u; k < par->portal_count; k++) {
        float wk = par->portal_light[k] * portal_view(portal_record(s, par, k), p, n);
        if (wk <= 0.0f) continue;
        pick = k;
        w = wk;
        if (before + wk > r) break;
        before += wk;
    }

    GLOBAL const float* portal = portal_record(s, par, pick);
    float along = (r - before) / w;  // what is left of r
    along = along < 0.0f ? 0.0f : along > 1.0f ? 1.0f : along;
    float3 middle = madd3(f3_at(portal + PORTAL_V), across - 0.5f, f3_at(portal + PORTAL_CENTRE));
    return unit3(sub3(madd3(f3_at(portal + PORTAL_U), along - 0.5f, middle), p));
}

// A direction about n, by the cosine.
FN float3 cosine_direction(float3 n, float x, float turn) {
    float3 e1, e2;
    float sn, cs, r = sqrt_(x), z = sqrt_(1.0f - x > 0.0f ? 1.0f - x : 0.0f);
    frame_of(n, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(n, z), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

// What diffuse rays from a place aim at.
STRUCT(Mixture) {
    float light;      // that comes through all portals
    uint highlights;  // those that can be met, a bit each
};

FN Mixture mixture_at(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n) {
    Mixture mixture;
    mixture.light = portals_light(s, par, p, n);
    mixture.highlights = par->highlight_share > 0.0f ? highlights_met(s, par, p, n) : 0u;
    return mixture;
}

FN float highlights_share(PARAMS(const Params) par, PRIVATE(const Mixture) mixture) {
    return mixture->highlights != 0u ? par->highlight_share : 0.0f;
}

// Density (per sr) of direction dir about n from p among diffuse rays.
FN float diffuse_pdf(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Mixture) mixture, float3 p,
                     float3 n, float3 dir) {
    float share = portals_share(par, mixture->light), shine = highlights_share(par, mixture);
    float c = dot3(dir, n);
    float pdf = c * K_INV_PI;
    if (share > 0.0f) pdf = (1.0f - share) * c * K_INV_PI + share * portals_pdf(s, par, p, n, dir, mixture->light);
    if (shine > 0.0f) pdf = (1.0f - shine) * pdf + shine * highlights_pdf(s, par, mixture->highlights, dir);
    return pdf;
}

// Samples a direction over the hemisphere of n.  Returns cos/(pi pdf): the factor of the diffuse coefficient.
// *mixture: what it may have aimed at.
FN float sample_diffuse(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, PRIVATE(Sampler) rnd,
                        PRIVATE(Mixture) mixture, PRIVATE(float3) dir) {
    float2 x = sample2(rnd);
    *mixture = mixture_at(s, par, p, n);
    float share = portals_share(par, mixture->light), shine = highlights_share(par, mixture);

    if (shine > 0.0f && x.x < shine) {
        *dir = highlight_direction(s, par, mixture->highlights, x.x / shine, x.y);
        if (!(highlights_pdf(s, par, mixture->highlights, *dir) > 0.0f)) return 0.0f;
    } else {
        if (shine > 0.0f) x.x = (x.x - shine) / (1.0f - shine);
        if (share > 0.0f && x.x < share) *dir = portal_direction(s, par, p, n, x.x / share * mixture->light, x.y);
        else *dir = cosine_direction(n, share > 0.0f ? (x.x - share) / (1.0f - share) : x.x, x.y);
    }
    float c = dot3(*dir, n);
    if (c <= 0.0f) return 0.0f;
    if (share <= 0.0f && shine <= 0.0f) return 1.0f;
    return c * K_INV_PI / diffuse_pdf(s, par, mixture, p, n, *dir);
}
#endif
