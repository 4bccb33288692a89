// SPDX-License-Identifier: BSD-3-Clause
// dielectric and interface: a solid's boundary (spec: RADIANCE shading 3.6).
// args, dielectric: transmission per length r g b, index, Hartmann constant; interface: inside r g b n, outside r g b
// n.
#ifndef LUX_MAT_DIELECTRIC_H
#define LUX_MAT_DIELECTRIC_H

FN float extinction(float t) { return t < 1e-40f ? 100.0f : t >= 1.0f ? 0.0f : -k_log(t); }

FN float3 extinction3(GLOBAL const float* t, float3 pattern) {
    return F3(extinction(t[0] * pattern.x), extinction(t[1] * pattern.y), extinction(t[2] * pattern.z));
}

FN Medium solid_medium(float3 k, PRIVATE(const Medium) around) {
    Medium m;
    m.k = k;
    m.albedo = F3(0.0f, 0.0f, 0.0f);
    m.ecc = 0.0f;
    m.lights = around->lights;
    return m;
}

// Refracted direction of a ray from v.  Not of unit length unless the cosines are n's own.
FN float3 refracted(float ratio, float c1, float c2, float3 n, float3 v) {
    return madd3(n, ratio * c1 - c2, scale3(v, -ratio));
}

// *arriving becomes the medium of the segment that ends here, if the surface defines it, *medium_behind that of the
// refracted ray. Solids do not scatter.
FN void mat_dielectric(PARAMS(const Params) par, PRIVATE(const Surface) g, uint type, GLOBAL const float* arg,
                       PRIVATE(Lobes) lobes, PRIVATE(Medium) arriving, PRIVATE(Medium) medium_behind) {
    Medium inside = solid_medium(extinction3(arg, g->color), arriving);
    float ratio;  // index on the viewer's side over index behind

    if (type == M_DIELECTRIC) {
        float n = arg[3] + arg[4] * 0.002f;
        ratio = g->front ? 1.0f / n : n;
        if (g->front) *medium_behind = inside;
        else {
            *arriving = inside;
            *medium_behind = medium_open(par);
        }
        medium_behind->lights = arriving->lights;
    } else {
        Medium outside = solid_medium(extinction3(arg + 4, g->color), arriving);
        ratio = g->front ? arg[7] / arg[3] : arg[3] / arg[7];
        *arriving = g->front ? outside : inside;
        *medium_behind = g->front ? inside : outside;
    }

    float c1 = dot3(g->n, g->v), R = 1.0f;
    float c2 = 1.0f - ratio * ratio * (1.0f - c1 * c1);

    if (c2 >= 1e-6f) {
        c2 = sqrt_(c2);
        float r1 = (c1 - ratio * c2) / (c1 + ratio * c2);
        float i1 = 1.0f / MAX_(c1, 1e-9f), i2 = ratio / c2;
        float r2 = (i1 - i2) / (i1 + i2);
        R = 0.5f * (r1 * r1 + r2 * r2);
        float T = (1.0f - R) * ratio * ratio;
        float3 d = refracted(ratio, c1, c2, g->n, g->v);
        if (dot3(d, g->ng) >= 0.0f) d = refracted(ratio, c1, c2, g->ng, g->v);  // a steep texture reversed it
        lobes->refract = F3(T, T, T);
        lobes->refract_dir = unit3(d);
    }

    lobes->mirror = F3(R, R, R);
    lobes->mirror_dir = mirror_direction(g);
}
#endif
