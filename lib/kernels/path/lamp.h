// SPDX-License-Identifier: BSD-3-Clause
// Light of lamps with patterns, as luminaires have them for their distribution.  Where chains are walked apart
// (features.h), shading leaves the shadow ray without the lamp's radiance, and a kernel of its own adds that before the
// ray is followed.  It takes no random numbers, for no mixture chooses what an active source is made of
// (flatten/modifiers.cpp).
#ifndef LUX_PATH_LAMP_H
#define LUX_PATH_LAMP_H

FN int is_lamp_apart(SHARED(const SceneTables) s, UNIFORM(const Params) par, GLOBAL const float* src) {
    return CHAINS_APART && HAS(LAMPS) && !is_bare(s, par, as_uint_(src[SRC_MOD]));
}

// Keeps where the lamp is lit, what the surface makes of its light, and by what the radiance is multiplied.
FN void lamp_keep(SHARED(const Paths) paths, uint slot, PRIVATE(const LightSample) light, float3 response,
                  float inv_p) {
    write4_(paths->lamp_dir, slot, pack4(light->dir, light->dist));
    write4_(paths->lamp_p, slot, pack4(light->point, inv_p));
    write4_(paths->lamp_n, slot, pack4(light->normal, 0.0f));
    write4_(paths->lamp_response, slot, pack4(response, 0.0f));
}

// Gives the shadow ray of a slot its radiance.  0: it brings none that counts.
FN int path_lamp_shines(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot) {
    float4 dir = read4_(paths->lamp_dir, slot), p = read4_(paths->lamp_p, slot), rad = read4_(paths->shadow_rad, slot);
    GLOBAL const float* src = source_record(s, par, as_uint_(paths->shadow_org[slot].w));
    Sampler none = sampler_start(0u, 0u, 0u, 0u, 0u);
    LightSample light;
    light.dir = xyz4(dir);
    light.dist = dir.w;
    light.point = xyz4(p);
    light.normal = xyz4(read4_(paths->lamp_n, slot));

    float3 radiance = sampled_radiance(s, par, src, &light, rad.w, &none);
    if (!(luminance3(mul3(xyz4(read4_(paths->lamp_response, slot)), radiance)) > 0.0f)) return 0;
    radiance = scale3(radiance, p.w);
    write4_(paths->shadow_rad, slot, pack4(mul3(xyz4(rad), radiance), rad.w));
    if (par->shared_slots == 0u) return 1;
    float4 far = read4_(paths->shadow_far, slot);
    write4_(paths->shadow_far, slot, pack4(mul3(xyz4(far), radiance), far.w));
    return 1;
}
#endif
