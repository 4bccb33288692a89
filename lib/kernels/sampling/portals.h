// SPDX-License-Identifier: BSD-3-Clause
// Technique of portals: samples points of windows, patches of sun and narrow glossy reflectors in it.  Most light of a
// daylit room comes from this small solid angle, which causes most of the noise.  lib/sampling/portal_lights.h chooses
// the weights.
#ifndef LUX_PORTALS_H
#define LUX_PORTALS_H

FN GLOBAL const Portal* portal_record(TABLES(const SceneTables) s, PARAMS(const Params) par, uint k) {
    return &s->portals[par->portal_pick[k]];
}

// Brightness of the sun's highlight on a glossy rectangle as seen from p, relative to its maximum.  *to, from p to the
// rectangle's middle, becomes the vector to the brightest point: where the mirrored sun is, or the nearest point of the
// rectangle.  height: of p above its plane.
FN float portal_gloss(GLOBAL const Portal* portal, float height, PRIVATE(float3) to) {
    float s = height / portal->mirrored_out;

    // along the plane toward the mirrored sun, up to it or to the rectangle
    float3 along_u = f3_of(portal->along_u), along_v = f3_of(portal->along_v);
    float a = -dot3(*to, along_u), b = -dot3(*to, along_v);
    float inv_a = portal->mirrored_per_u, inv_b = portal->mirrored_per_v;
    float a0 = (-0.5f - a) * inv_a, a1 = (0.5f - a) * inv_a, b0 = (-0.5f - b) * inv_b, b1 = (0.5f - b) * inv_b;
    float first = MAX_(MAX_(MIN_(a0, a1), MIN_(b0, b1)), 0.0f), last = MIN_(MAX_(a0, a1), MAX_(b0, b1));
    if (first <= last) s = MIN_(MAX_(s, first), last);
    a = MIN_(MAX_(a + s * portal->mirrored_u, -0.5f), 0.5f);
    b = MIN_(MAX_(b + s * portal->mirrored_v, -0.5f), 0.5f);
    *to = madd3(f3_of(portal->v), b, madd3(f3_of(portal->u), a, *to));

    float3 half_way = sub3(f3_of(portal->sun), unit3(*to));
    float hn = -dot3(half_way, f3_of(portal->normal));
    if (!(hn > 0.0f)) return 0.0f;
    float far = (dot3(half_way, half_way) - hn * hn) / (hn * hn * portal->gloss2);
    if (!(far < HIGHLIGHT_FARTHEST)) return 0.0f;
    return k_exp(-far);
}

// Approximate solid angle of a portal from p, times the cosines at both ends; 0 from behind it.
FN float portal_view(GLOBAL const Portal* portal, float3 p, float3 n) {
    float3 to = sub3(f3_of(portal->centre), p);
    float height = dot3(to, f3_of(portal->normal));
    if (height <= 1e-4f) return 0.0f;  // on the glass or behind it
    float bright = 1.0f;
    if (portal->gloss2 > 0.0f) {
        bright = portal_gloss(portal, height, &to);
        if (!(bright > 0.0f)) return 0.0f;
    }

    // its height above the surface's horizon; where the horizon cuts it, about that of the part above
    float e = dot3(to, n);
    float reach = 0.5f * (fabs_(dot3(f3_of(portal->u), n)) + fabs_(dot3(f3_of(portal->v), n)));
    if (e + reach <= 0.0f) return 0.0f;
    if (e < reach) e = 0.25f * (e + reach) * (e + reach) / reach;
    float area = portal->area;
    float d2 = MAX_(dot3(to, to), 0.25f * area);
    return bright * area * height * e / (d2 * d2);
}

// Pdf (per sr) of a uniform point on portal k in direction dir from p; 0 if dir misses the portal.
FN float portal_pdf(GLOBAL const Portal* portal, float3 p, float3 dir) {
    float3 out = f3_of(portal->normal), to = sub3(f3_of(portal->centre), p);
    float c = dot3(dir, out), h = dot3(to, out);
    if (c <= 1e-6f || h <= 0.0f) return 0.0f;
    float t = h / c;
    float3 off = sub3(scale3(dir, t), to);
    float along_u = dot3(off, f3_of(portal->along_u)), along_v = dot3(off, f3_of(portal->along_v));
    if (fabs_(along_u) > 0.5f || fabs_(along_v) > 0.5f) return 0.0f;
    return t * t / (portal->area * c);
}

// Light that reaches p through all portals.
FN float portals_light(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n) {
    float total = 0.0f;
    for (UNIFORM uint k = 0u; k < par->portals_count; k++)
        total += par->portal_light[k] * portal_view(portal_record(s, par, k), p, n);
    return total;
}

// Mixture weight of the directions toward portals, whose light sums to `total`.
FN float portals_weight(PARAMS(const Params) par, float total) {
    if (!(total > 0.0f)) return 0.0f;
    return MIN_(MAX_(total / (total + par->portal_rest), par->portal_least), par->portal_most);
}

// Pdf (per sr) of direction dir from p among those toward portals, whose light sums to `total`.
FN float portals_pdf(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, float3 dir,
                     float total) {
    float pdf = 0.0f;
    for (UNIFORM uint k = 0u; k < par->portals_count; k++) {
        GLOBAL const Portal* portal = portal_record(s, par, k);
        float d = portal_pdf(portal, p, dir);
        if (d > 0.0f) pdf += par->portal_light[k] * portal_view(portal, p, n) / total * d;
    }

    return pdf;
}

// Direction from p to a point of a portal; r, from 0 to the sum of their light, chooses the portal by its light.
FN float3 portals_sample(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 p, float3 n, float r,
                         float across) {
    float before = 0.0f, w = 0.0f;
    uint pick = 0u;

    for (UNIFORM uint k = 0u; k < par->portals_count; k++) {
        float wk = par->portal_light[k] * portal_view(portal_record(s, par, k), p, n);
        if (wk <= 0.0f) continue;
        pick = k;
        w = wk;
        if (before + wk > r) break;
        before += wk;
    }

    GLOBAL const Portal* portal = portal_record(s, par, pick);
    float along = (r - before) / w;  // the remainder of r
    along = along < 0.0f ? 0.0f : along > 1.0f ? 1.0f : along;
    float3 middle = madd3(f3_of(portal->v), across - 0.5f, f3_of(portal->centre));
    return unit3(sub3(madd3(f3_of(portal->u), along - 0.5f, middle), p));
}
#endif
