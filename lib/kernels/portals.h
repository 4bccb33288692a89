// SPDX-License-Identifier: BSD-3-Clause
// Directions for diffuse light: half of them by the cosine, half toward the windows ("portals"), one mixed density, so
// that the estimator stays unbiased whatever the portals are and no sample weighs more than twice its cosine weight
// (one-sample multiple importance sampling with the balance heuristic, Veach 1997, section 9.2.4).
// The sky seen through a window is the main light of a daylit room and small in solid angle: this is where noise goes.
#ifndef LUX_PORTALS_H
#define LUX_PORTALS_H

#define PORTAL_SHARE 0.5f

// Weight of portal k for choosing it at p: area over distance squared, with the cosine at the portal; 0 from outdoors.
FN float portal_weight(GLOBAL const float* q, float3 p, float3 n) {
    float3 corner = f3_at(q), u = f3_at(q + 3), v = f3_at(q + 6), out = f3_at(q + 9);
    float3 c = madd3(u, 0.5f, madd3(v, 0.5f, corner));
    float3 to = sub3(c, p);
    float height = dot3(to, out);
    if (height <= 1e-4f) return 0.0f;  // at or beyond the glass
    // is any corner above the surface's horizon?
    float e = dot3(to, n), su = fabs_(dot3(u, n)) * 0.5f, sv = fabs_(dot3(v, n)) * 0.5f;
    if (e + su + sv <= 0.0f) return 0.0f;
    float d2 = dot3(to, to), area = q[12];
    return area * height / (sqrt_(d2) * MAX_(d2, 0.25f * area));
}

// Density (per sr) with which a uniform point on portal k lies in direction dir from p; 0 if dir misses it.
FN float portal_density(GLOBAL const float* q, float3 p, float3 dir) {
    float3 u = f3_at(q + 3), v = f3_at(q + 6), out = f3_at(q + 9);
    float3 to = sub3(f3_at(q), p);
    float c = dot3(dir, out), h = dot3(to, out);
    if (c <= 1e-6f || h <= 0.0f) return 0.0f;
    float t = h / c;
    float3 r = sub3(scale3(dir, t), to);
    float uu = dot3(u, u), vv = dot3(v, v), uv = dot3(u, v), ru = dot3(r, u), rv = dot3(r, v);
    float det = uu * vv - uv * uv;
    float a = (ru * vv - rv * uv) / det, b = (rv * uu - ru * uv) / det;
    if (a < 0.0f || b < 0.0f || a > 1.0f || b > 1.0f) return 0.0f;
    return t * t / (q[12] * c);
}

// Samples a direction over the hemisphere of n.  Returns cos/(pi density): the factor of the diffuse coefficient.
FN float sample_diffuse(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 p, float3 n,
                        PRIVATE Sampler* rnd, PRIVATE float3* dir) {
    const float inv_pi = 0.31830989f;
    float2 x = sample2(rnd);
    float total = 0.0f, c;
    for (uint k = 0u; k < par->portal_count; k++)
        total += portal_weight(s->f + par->portals_at + PORTAL_FLOATS * k, p, n);
    float share = total > 0.0f ? PORTAL_SHARE : 0.0f;
    if (share > 0.0f && x.x < share) {
        float r = x.x / share * total, acc = 0.0f, w = 0.0f;
        uint pick = 0u;
        for (uint k = 0u; k < par->portal_count; k++) {
            float wk = portal_weight(s->f + par->portals_at + PORTAL_FLOATS * k, p, n);
            if (wk <= 0.0f) continue;
            pick = k;
            w = wk;
            if (acc + wk > r) break;
            acc += wk;
        }
        GLOBAL const float* q = s->f + par->portals_at + PORTAL_FLOATS * pick;
        float a = (r - acc) / w;
        a = a < 0.0f ? 0.0f : a > 1.0f ? 1.0f : a;
        float3 at = madd3(f3_at(q + 3), a, madd3(f3_at(q + 6), x.y, f3_at(q)));
        *dir = unit3(sub3(at, p));
        c = dot3(*dir, n);
        if (c <= 0.0f) return 0.0f;
    } else {
        float y = share > 0.0f ? (x.x - share) / (1.0f - share) : x.x, sn, cs;
        float3 t, b;
        frame_of(n, &t, &b);
        float r = sqrt_(y);
        k_sincos(6.28318531f * x.y, &sn, &cs);
        c = sqrt_(1.0f - y > 0.0f ? 1.0f - y : 0.0f);
        *dir = unit3(add3(scale3(n, c), add3(scale3(t, r * cs), scale3(b, r * sn))));
        c = dot3(*dir, n);
        if (c <= 0.0f) return 0.0f;
        if (share <= 0.0f) return 1.0f;
    }
    float density = (1.0f - share) * c * inv_pi;
    for (uint k = 0u; k < par->portal_count; k++) {
        GLOBAL const float* q = s->f + par->portals_at + PORTAL_FLOATS * k;
        float d = portal_density(q, p, *dir);
        if (d > 0.0f) density += share * portal_weight(q, p, n) / total * d;
    }
    return c * inv_pi / density;
}
#endif
