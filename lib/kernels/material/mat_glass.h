// SPDX-License-Identifier: BSD-3-Clause
// glass: a thin pane with internal reflections (spec: RADIANCE shading 3.5).  args: transmissivity r g b [index 1.52]
#ifndef LUX_MAT_GLASS_H
#define LUX_MAT_GLASS_H

FN void glass_channel(float t, float r1, float r2, float c2, PRIVATE(float) T, PRIVATE(float) R) {
    float d = t <= 1e-15f ? 0.0f : k_pow(t, 1.0f / c2);
    float d2 = d * d;
    float k1 = 0.5f / (1.0f - r1 * r1 * d2), k2 = 0.5f / (1.0f - r2 * r2 * d2);
    *T = d * ((1.0f - r1) * (1.0f - r1) * k1 + (1.0f - r2) * (1.0f - r2) * k2);
    *R = r1 * (1.0f + (1.0f - 2.0f * r1) * d2) * k1 + r2 * (1.0f + (1.0f - 2.0f * r2) * d2) * k2;
}

FN void mat_glass(PRIVATE(const Surface) g, GLOBAL const float* arg, int shadow, PRIVATE(Lobes) lobes) {
    float n = arg[3], cv = fabs_(dot3(g->n, g->v));
    float c2 = sqrt_(1.0f - 1.0f / (n * n) + cv * cv / (n * n));
    float r1 = (cv - n * c2) / (cv + n * c2);
    float inv = cv > 1e-9f ? 1.0f / cv : 1e9f;
    float r2 = (inv - n / c2) / (inv + n / c2);
    r1 *= r1;
    r2 *= r2;
    float Tr, Tg, Tb, Rr, Rg, Rb;
    glass_channel(arg[0], r1, r2, c2, &Tr, &Rr);
    glass_channel(arg[1], r1, r2, c2, &Tg, &Rg);
    glass_channel(arg[2], r1, r2, c2, &Tb, &Rb);
    lobes->through = mul3(F3(Tr, Tg, Tb), g->color);
    float3 p = neg3(g->v);
    if (!shadow && !g->smooth && is_textured(g)) {
        p = unit3(madd3(g->pert, (g->front ? 2.0f : -2.0f) * (1.0f - n), p));  // it turns with the normal
    }

    lobes->through_dir = p;
    if (!shadow) {  // the only mirror direction that may lie below the surface
        lobes->mirror = F3(Rr, Rg, Rb);
        lobes->mirror_dir = unit3(sub3(scale3(g->n, 2.0f * dot3(g->n, g->v)), g->v));
    }
}
#endif
