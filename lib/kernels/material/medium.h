// SPDX-License-Identifier: BSD-3-Clause
// The medium of a ray, and its change at a mist's surface (spec: RADIANCE shading 3.9).
#ifndef LUX_MEDIUM_H
#define LUX_MEDIUM_H

STRUCT(Medium) {
    float3 k;       // extinction per unit length
    float3 albedo;  // scattered fraction of it
    float ecc;      // eccentricity of Henyey and Greenstein's phase function
    uint lights;    // sets of scattered light sources, one bit each (light_sets_at)
};

// The global medium (-me -ma -mg), unless a surface defines another.
FN Medium medium_open(PARAMS(const Params) par) {
    Medium medium;
    medium.k = f3_of(par->extinction);
    medium.albedo = f3_of(par->albedo);
    medium.ecc = par->eccentricity;
    medium.lights = 0u;
    return medium;
}

FN Medium path_medium(TABLES(const Paths) paths, uint path) {
    Medium medium;
    Row_medium around = medium_of(read4_(paths->medium, path));
    Row_albedo albedo = albedo_of(read4_(paths->albedo, path));
    medium.k = around.k;
    medium.lights = around.lights;
    medium.albedo = albedo.rgb;
    medium.ecc = albedo.ecc;
    return medium;
}

FN void set_path_medium(TABLES(const Paths) paths, uint path, PRIVATE(const Medium) medium) {
    write4_(paths->medium, path, medium_words(medium->k, medium->lights));
    write4_(paths->albedo, path, albedo_words(medium->albedo, medium->ecc));
}

// State of a shadow ray's medium: without the eccentricity, with the antimatter state.
FN Medium shadow_medium(TABLES(const Paths) paths, uint path) {
    Medium medium;
    Row_shadow_albedo albedo = shadow_albedo_of(read4_(paths->shadow_albedo, path));
    medium.k = xyz4(read4_(paths->shadow_medium, path));
    medium.lights = albedo.lights;
    medium.albedo = albedo.rgb;
    medium.ecc = 0.0f;
    return medium;
}

FN void set_shadow_medium(TABLES(const Paths) paths, uint path, PRIVATE(const Medium) medium, uint clip) {
    write4_(paths->shadow_medium, path, shadow_medium_words(medium->k, clip));
    write4_(paths->shadow_albedo, path, shadow_albedo_words(medium->albedo, medium->lights));
}

// A mist inherits what it does not state: the albedo and the list of sources around it.
FN void mist_enter(TABLES(const SceneTables) s, PRIVATE(const Surface) g, PRIVATE(Medium) medium) {
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    GLOBAL const float* arg = s->f + m->args;
    medium->k = add3(medium->k, mul3(f3_at(arg), g->color));
    if ((m->flags & MF_ALBEDO) != 0u) medium->albedo = f3_at(arg + 3);
    if ((m->flags & MF_ECCENTRICITY) != 0u) medium->ecc = arg[6];
    medium->lights |= m->lights;
}

// Leaving a mist removes what it stated, down to the global medium: an outer mist's values are lost, too.
FN void mist_leave(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g,
                   PRIVATE(Medium) medium) {
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    GLOBAL const float* arg = s->f + m->args;
    Medium open = medium_open(par);
    float3 k = sub3(medium->k, mul3(f3_at(arg), g->color));
    medium->k = F3(MAX_(k.x, open.k.x), MAX_(k.y, open.k.y), MAX_(k.z, open.k.z));
    if ((m->flags & MF_ALBEDO) != 0u) medium->albedo = open.albedo;
    if ((m->flags & MF_ECCENTRICITY) != 0u) medium->ecc = open.ecc;
    medium->lights &= ~m->lights;
}

// *here: the medium of the segment that ends at a mist's surface, corrected if the ray leaves a mist that it never
// entered, which only the mist's list shows; *medium_behind: the medium of the next segment.
FN void mist_crossing(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g,
                      PRIVATE(Medium) here, PRIVATE(Medium) medium_behind) {
    uint lights = s->modifiers[g->mod].lights;
    if (!g->front && (here->lights & lights) != lights) mist_enter(s, g, here);
    *medium_behind = *here;
    if (g->front) mist_enter(s, g, medium_behind);
    else mist_leave(s, par, g, medium_behind);
}

#define ENDLESS_MEDIUM 1e10f  // length through which no medium transmits light

// Transmittance of a length of medium of extinction k (Beer's law).
FN float3 attenuation(float3 k, float length) {
    if (max3(k) <= 0.0f) return F3(1.0f, 1.0f, 1.0f);
    return F3(k_exp(-k.x * length), k_exp(-k.y * length), k_exp(-k.z * length));
}

// Constant radiance of deeper bounces (-av) scattered into a segment of transmittance T.
FN float3 medium_glow(PARAMS(const Params) par, PRIVATE(const Medium) medium, float3 T) {
    float3 av = f3_of(par->av), one = F3(1.0f, 1.0f, 1.0f);
    return mul3(mul3(medium->albedo, av), sub3(one, T));
}

// Transmittance for a shadow ray, from which scattering removes no light (spec shading 3.9).
FN float3 shadow_attenuation(PRIVATE(const Medium) medium, float length) {
    float3 rest = sub3(F3(1.0f, 1.0f, 1.0f), medium->albedo);
    rest = F3(MAX_(rest.x, 0.0f), MAX_(rest.y, 0.0f), MAX_(rest.z, 0.0f));
    return attenuation(mul3(medium->k, rest), length);
}
#endif
