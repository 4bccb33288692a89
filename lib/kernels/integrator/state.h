// SPDX-License-Identifier: BSD-3-Clause
// State of the paths in flight, and the flags of their history.
// A path's class is "diffuse" once it has left a surface into the hemisphere (paper section 3; spec shading 0.2).
#ifndef LUX_PATH_STATE_H
#define LUX_PATH_STATE_H

// The fields of a path: FIELD(type, name, when, members).  The struct Paths, the allocations of both devices and the
// arguments of the OpenCL kernels are generated from this list.  Wide types first, because the fields are consecutive
// in memory.
//   when: PATH_ALWAYS; PATH_MEDIA: media or antimatter in the scene; PATH_REUSE: path reuse; PATH_HOURS: many hours
//   members: ROW(name, vector, type, word) gives names to the four words of a float4, three of a vector and one of a
// type of its own.  NAME_of() takes them out of the float4 as a Row_NAME, NAME_WORD() one of them; NAME_words() puts
// them in.
// clang-format off
#define PATH_STATE(FIELD)                                                                                          \
    FIELD(float4, org, PATH_ALWAYS, ROW(org, point, uint, clip))  /* of the ray; antimatter there (clip.h) */      \
    FIELD(float4, dir, PATH_ALWAYS, ROW(dir, way, float, length))  /* of the ray */                                \
    FIELD(float4, throughput, PATH_ALWAYS, ROW(throughput, rgb, float, weight))  /* RADIANCE's ray weight (-lw) */ \
    FIELD(float4, rad, PATH_ALWAYS, ROW(rad, rgb, float, path_length))  /* radiance so far; length from the eye */ \
    FIELD(uint4, info, PATH_ALWAYS, )  /* PathInfo */                                                              \
    FIELD(float4, hit, PATH_ALWAYS, )  /* path_hit() */                                                            \
    FIELD(float4, shadow_org, PATH_ALWAYS, ROW(shadow_org, point, uint, source))                                   \
    FIELD(float4, shadow_dir, PATH_ALWAYS, ROW(shadow_dir, way, float, distance))                                  \
    FIELD(float4, shadow_rad, PATH_ALWAYS, ROW(shadow_rad, rgb, float, path_length))  /* light if unoccluded */    \
    FIELD(float4, medium, PATH_MEDIA, ROW(medium, k, uint, lights))  /* around: extinction, sets of lights */      \
    FIELD(float4, albedo, PATH_MEDIA, ROW(albedo, rgb, float, ecc))  /* its albedo and eccentricity */             \
    FIELD(float4, shadow_medium, PATH_MEDIA, ROW(shadow_medium, k, uint, clip))  /* the shadow ray's */            \
    FIELD(float4, shadow_albedo, PATH_MEDIA, ROW(shadow_albedo, rgb, uint, lights))                                \
    FIELD(float4, prefix_p, PATH_REUSE, ROW(prefix_p, point, uint, spare))  /* prefix vertex: of its next ray */   \
    FIELD(float4, prefix_n, PATH_REUSE, ROW(prefix_n, normal, float, own))  /* own ray's weight, or NO_PREFIX */   \
    FIELD(float4, prefix_ng, PATH_REUSE, ROW(prefix_ng, normal, uint, spare))  /* geometric */                     \
    FIELD(float4, prefix_throughput, PATH_REUSE, ROW(prefix_throughput, rgb, float, survival)) /* without that */  \
    FIELD(float4, suffix_p, PATH_REUSE, ROW(suffix_p, place, float, kind))  /* point, direction; SUFFIX_POINT .. */\
    FIELD(float4, suffix_n, PATH_REUSE, ROW(suffix_n, normal, float, rounding))  /* on the ray's side */           \
    FIELD(float4, suffix_rad, PATH_REUSE, ROW(suffix_rad, rgb, float, path_length))  /* outgoing radiance */       \
    FIELD(float4, shadow_suffix, PATH_REUSE, ROW(shadow_suffix, rgb, float, there))  /* shadow ray's light for it */ \
    FIELD(Transmittances, transmittance, PATH_REUSE, ROW(transmittance, rgb, float, prob))  /* of connections */   \
    FIELD(ConnectionWords, pdf, PATH_REUSE, )  /* with which the prefix vertices would have sampled it */          \
    FIELD(ConnectionWords, contribution, PATH_REUSE, )  /* to them, without the panes */                           \
    FIELD(Mixture, mixture, PATH_REUSE, )  /* of the prefix vertex */                                              \
    FIELD(uint, connections, PATH_REUSE, )  /* visibility of the connections to the suffix vertex */             \
    FIELD(float4, sky_way, PATH_HOURS, ROW(sky_way, dir, uint, kind))  /* where it has left the scene; SKY_ */    \
    FIELD(float4, sky_share, PATH_HOURS, ROW(sky_share, rgb, uint, spare))  /* light per radiance of the sky there */
// clang-format on

#define float_word_(w) (w)
#define float_of_float_(f) (f)
#define uint_word_(w) as_uint_(w)
#define float_of_uint_(u) as_float_(u)
#define ROW(name, vector, type, word)                                     \
    STRUCT(Row_##name) {                                                  \
        float3 vector;                                                    \
        type word;                                                        \
    };                                                                    \
    FN Row_##name name##_of(float4 words) {                               \
        Row_##name row;                                                   \
        row.vector = xyz4(words);                                         \
        row.word = type##_word_(words.w);                                 \
        return row;                                                       \
    }                                                                     \
    FN type name##_##word(float4 words) { return type##_word_(words.w); } \
    FN float4 name##_words(float3 vector, type word) { return pack4(vector, float_of_##type##_(word)); }
#define PATH_MEMBERS(type, name, when, members) members
PATH_STATE(PATH_MEMBERS)

#define NO_PREFIX -1.0f   // in place of a weight: there is no prefix vertex
#define SUFFIX_NONE 0.0f  // kinds of suffix_p
#define SUFFIX_POINT 1.0f
#define SUFFIX_DIRECTION 2.0f

// Kinds of sky_way: what the sky lights there, and flags of the eye's rays.
#define SKY_NONE 0u
#define SKY_PATH 1u    // the path
#define SKY_SUFFIX 2u  // its suffix vertex
#define SKY_STRAIGHT 4u
#define SKY_MIRRORED 8u  // or refracted
#define SKY_GATHERS 16u  // no sky: the normal of the suffix vertex, where its light is gathered (PF_GATHERS)

// For the connections between a suffix vertex and the prefix vertices of its group: a word each, or a transmittance
// each.
STRUCT(ConnectionWords) { float of[REUSE_GROUP]; };
STRUCT(Transmittances) { float4 of[REUSE_GROUP]; };

#define PATH_POINTER(type, name, when, members) GLOBAL type* name;
STRUCT(Paths){PATH_STATE(PATH_POINTER)};

#define PATH_ALWAYS 0u
#define PATH_MEDIA 1u
#define PATH_REUSE 2u
#define PATH_HOURS 4u
FN int has_media(PARAMS(const Params) par) { return HAS(SOLIDS) && par->may_absorb != 0u; }
FN int has_antimatter(PARAMS(const Params) par) { return HAS(SOLIDS) && (par->flags & PF_ANTIMATTER) != 0u; }
FN int aims_shadows(PARAMS(const Params) par) { return HAS(SOLIDS) && par->shadow_mode == SHADOW_AIMED; }
FN int path_media_used(PARAMS(const Params) par) { return has_media(par) || has_antimatter(par); }
FN uint path_needs(PARAMS(const Params) par) {
    return (path_media_used(par) ? PATH_MEDIA : 0u) | (par->reuse_path_count != 0u ? PATH_REUSE : 0u) |
           ((par->flags & PF_HOURS) != 0u ? PATH_HOURS : 0u);
}

// PathInfo.flags
#define PC_DIFFUSE 1u         // a diffuse bounce lies behind
#define PC_ROUGH 2u           // a rough specular bounce lies behind
#define PC_BENT 4u            // a reflection or refraction lies behind: not the eye's straight ray
#define PC_RECORDS_SUFFIX 8u  // it has a prefix vertex and no suffix vertex yet (suffix.h)
#define PC_SUFFIX 16u         // its light is outgoing radiance of its suffix vertex
#define PC_LEVEL_SHIFT 6u     // reflection level, 7 bits, saturating
#define PC_MOST_LEVELS 127u
#define PC_AB_SHIFT 13u  // diffuse depth, 8 bits, saturating
#define PC_MOST_BOUNCES 255u
#define PC_STEP_SHIFT 21u    // surfaces hit, 11 bits
#define PC_STEP_LIMIT 2000u  // a path ends there: a closed room of reflectance .995 loses 5e-5 of its light

FN uint path_level(uint flags) { return (flags >> PC_LEVEL_SHIFT) & PC_MOST_LEVELS; }
FN uint path_bounces(uint flags) { return (flags >> PC_AB_SHIFT) & PC_MOST_BOUNCES; }
FN uint path_steps(uint flags) { return flags >> PC_STEP_SHIFT; }
FN uint count_level(uint flags) { return path_level(flags) < PC_MOST_LEVELS ? flags + (1u << PC_LEVEL_SHIFT) : flags; }
FN uint count_bounce(uint flags) { return path_bounces(flags) < PC_MOST_BOUNCES ? flags + (1u << PC_AB_SHIFT) : flags; }

// Returns 1 after a diffuse or rough bounce; else the ray is the eye's, perhaps by way of mirrors and panes.
FN int path_sampled(uint flags) { return (flags & (PC_DIFFUSE | PC_ROUGH)) != 0u; }

// The words of `info`.
STRUCT(PathInfo) {
    uint flags;  // PC_
    uint key;    // of the sampler
    uint place;  // its index, and its dimension << 8
    uint inst;   // instance hit
};

FN PathInfo info_of(uint4 words) {
    PathInfo info;
    info.flags = words.x;
    info.key = words.y;
    info.place = words.z;
    info.inst = words.w;
    return info;
}

FN uint info_flags(uint4 words) { return words.x; }

FN uint4 info_words(uint flags, PRIVATE(const Sampler) rnd, uint inst) {
    uint4 words;
    words.x = flags;
    words.y = rnd->key;
    words.z = rnd->index | (rnd->dim << 8);
    words.w = inst;
    return words;
}

FN Sampler path_sampler(PathInfo info) {
    Sampler rnd;
    rnd.key = info.key;
    rnd.index = info.place & 255u;
    rnd.dim = info.place >> 8;
    rnd.until = 0u;
    return rnd;
}

// In place of the primitive that a path has hit: it begins on a sensor.  Pilots that begin at a bounce do not.
#define ON_SENSOR 0xfffffffeu
FN int begins_on_sensor(PARAMS(const Params) par, uint flags) {
    return (par->flags & PF_SENSORS) != 0u && path_steps(flags) == 0u && path_bounces(flags) == 0u;
}

// words: of `hit`.
FN Hit path_hit(float4 words, PathInfo info) {
    Hit hit;
    hit.t = words.x;
    hit.prim = as_uint_(words.y);
    hit.u = words.z;
    hit.v = words.w;
    hit.inst = info.inst;
    return hit;
}

FN uint path_hit_prim(TABLES(const Paths) paths, uint path) { return as_uint_(paths->hit[path].y); }

FN void set_path_hit(TABLES(const Paths) paths, uint path, PRIVATE(const Hit) hit) {
    float4 words;
    words.x = hit->t;
    words.y = as_float_(hit->prim);
    words.z = hit->u;
    words.w = hit->v;
    paths->hit[path] = words;
    paths->info[path].w = hit->inst;
}

// Paths of one kind have hit the same type of material (0: none) and take the same branches: where it pays, they are
// shaded together.  By number; several types may share one.
#define PATH_KINDS 64u
FN uint path_kind(TABLES(const SceneTables) s, TABLES(const Paths) paths, uint path) {
    uint prim = path_hit_prim(paths, path);
    return prim >= ON_SENSOR ? 0u : 1u + s->prims[prim].mod % (PATH_KINDS - 1u);
}
#endif
