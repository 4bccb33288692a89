// SPDX-License-Identifier: BSD-3-Clause
// Directions for diffuse light: a share of them toward the windows ("portals"), the others by the cosine, one mixed
// density, so that the estimator stays unbiased whatever portals and share are (one-sample multiple importance sampling
// with the balance heuristic, Veach 1997, section 9.2.4).  trace/aim_shares.h finds the share.
// Another share goes toward highlights (highlights.h).
// The sky seen through a window is the main light of a daylit room and small in solid angle: this is where noise goes.
#ifndef LUX_PORTALS_H
#define LUX_PORTALS_H

FN GLOBAL const float* portal_record(PRIVATE const SceneTables* s, UNIFORM const Params* par, uint k) {
    return s->f + par->portals_at + PORTAL_FLOATS * k;
}

// Weight of portal k for choosing it at p: area over distance squared, with the cosine at the portal; 0 from outdoors.
FN float portal_weight(GLOBAL const float* portal, float3 p, float3 n) {
    float3 corner = f3_at(portal + PORTAL_CORNER), out = f3_at(portal + PORTAL_NORMAL);
    float3 u = f3_at(portal + PORTAL_U), v = f3_at(portal + PORTAL_V);
    float3 c = madd3(u, 0.5f, madd3(v, 0.5f, corner));
    float3 to = sub3(c, p);
    float height = dot3(to, out);
    if (height <= 1e-4f) return 0.0f;  // at or beyond the glass

    // is any corner above the surface's horizon?
    float e = dot3(to, n), su = fabs_(dot3(u, n)) * 0.5f, sv = fabs_(dot3(v, n)) * 0.5f;
    if (e + su + sv <= 0.0f) return 0.0f;
    float d2 = dot3(to, to), area = portal[PORTAL_AREA];
    return area * height / (sqrt_(d2) * MAX_(d2, 0.25f * area));
}

// Density (per sr) with which a uniform point on portal k lies in direction dir from p; 0 if dir misses it.
FN float portal_density(GLOBAL const float* portal, float3 p, float3 dir) {
    float3 u = f3_at(portal + PORTAL_U), v = f3_at(portal + PORTAL_V), out = f3_at(portal + PORTAL_NORMAL);
    float3 to = sub3(f3_at(portal + PORTAL_CORNER), p);
    float c = dot3(dir, out), h = dot3(to, out);
    if (c <= 1e-6f || h <= 0.0f) return 0.0f;
    float t = h / c;
    float3 r = sub3(scale3(dir, t), to);
    float uu = dot3(u, u), vv = dot3(v, v), uv = dot3(u, v), ru = dot3(r, u), rv = dot3(r, v);
    float det = uu * vv - uv * uv;
    float along_u = (ru * vv - rv * uv) / det, along_v = (rv * uu - ru * uv) / det;
    if (along_u < 0.0f || along_v < 0.0f || along_u > 1.0f || along_v > 1.0f) return 0.0f;
    return t * t / (portal[PORTAL_AREA] * c);
}

FN float portals_weight(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n) {
    float total = 0.0f;
    for (uint k = 0u; k < par->portal_count; k++) total += portal_weight(portal_record(s, par, k), p, n);
    return total;
}

// Density (per sr) of direction dir from p among those toward portals, whose weights sum to `total`.
FN float portals_density(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n, float3 dir,
                         float total) {
    float density = 0.0f;
    for (uint k = 0u; k < par->portal_count; k++) {
        GLOBAL const float* portal = portal_record(s, par, k);
        float d = portal_density(portal, p, dir);
        if (d > 0.0f) density += portal_weight(portal, p, n) / total * d;
    }

    return density;
}

// The direction from p to a point of a portal, which r, 0 .. the sum of their weights, picks by its weight.
FN float3 portal_direction(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n, float r,
                           float across) {
    float before = 0.0f, w = 0.0f;
    uint pick = 0u;

    for (uint k = 0u; k < par->portal_count; k++) {
        float wk = portal_weight(portal_record(s, par, k), p, n);
        if (wk <= 0.0f) continue;
        pick = k;
        w = wk;
        if (before + wk > r) break;
        before += wk;
    }

    GLOBAL const float* portal = portal_record(s, par, pick);
    float along = (r - before) / w;  // what is left of r
    along = along < 0.0f ? 0.0f : along > 1.0f ? 1.0f : along;
    float3 far_side = madd3(f3_at(portal + PORTAL_V), across, f3_at(portal + PORTAL_CORNER));
    return unit3(sub3(madd3(f3_at(portal + PORTAL_U), along, far_side), p));
}

// A direction about n, by the cosine.
FN float3 cosine_direction(float3 n, float x, float turn) {
    float3 e1, e2;
    float sn, cs, r = sqrt_(x), z = sqrt_(1.0f - x > 0.0f ? 1.0f - x : 0.0f);
    frame_of(n, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(n, z), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

// Samples a direction over the hemisphere of n.  Returns cos/(pi density): the factor of the diffuse coefficient.
FN float sample_diffuse(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n,
                        PRIVATE Sampler* rnd, PRIVATE float3* dir) {
    float2 x = sample2(rnd);
    float total = 0.0f;
    if (par->portal_share > 0.0f) total = portals_weight(s, par, p, n);
    float share = total > 0.0f ? par->portal_share : 0.0f;
    uint met = par->highlight_share > 0.0f ? highlights_met(s, par, p, n) : 0u;
    float shine = met != 0u ? par->highlight_share : 0.0f;

    int shines = shine > 0.0f && x.x < shine;
    if (shines) {
        *dir = highlight_direction(s, par, met, x.x / shine, x.y);
    } else {
        if (shine > 0.0f) x.x = (x.x - shine) / (1.0f - shine);
        if (share > 0.0f && x.x < share) *dir = portal_direction(s, par, p, n, x.x / share * total, x.y);
        else *dir = cosine_direction(n, share > 0.0f ? (x.x - share) / (1.0f - share) : x.x, x.y);
    }
    float c = dot3(*dir, n);
    if (c <= 0.0f) return 0.0f;
    if (share <= 0.0f && shine <= 0.0f) return 1.0f;

    float density = c * K_INV_PI;
    if (share > 0.0f) density = (1.0f - share) * c * K_INV_PI + share * portals_density(s, par, p, n, *dir, total);
    if (shine > 0.0f) {
        float bright = highlights_density(s, par, met, *dir);
        if (shines && !(bright > 0.0f)) return 0.0f;
        density = (1.0f - shine) * density + shine * bright;
    }

    return c * K_INV_PI / density;
}
#endif
