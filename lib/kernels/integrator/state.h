// SPDX-License-Identifier: BSD-3-Clause
// State of the paths in flight, and the flags of their history.
// A path's class is "diffuse" once it has left a surface into the hemisphere (paper section 3; spec shading 0.2).
#ifndef LUX_PATH_STATE_H
#define LUX_PATH_STATE_H
#include "kernels/sampling/mixture_fields.h"

// The fields of a path: FIELD(type, name, when), four words a path.  The struct Paths, the allocations of both devices
// and the arguments of the OpenCL kernels are generated from this list.  Wide types first, because the fields are
// consecutive in memory.
//   when: PATH_ALWAYS; PATH_MEDIA: media or antimatter in the scene; PATH_REUSE: path reuse
// clang-format off
#define PATH_STATE(FIELD)                                                                                            \
    FIELD(float4, org, PATH_ALWAYS)              /* the ray's origin; w: antimatter state there (bits; clip.h) */    \
    FIELD(float4, dir, PATH_ALWAYS)              /* its direction; w: its length */                                  \
    FIELD(float4, throughput, PATH_ALWAYS)       /* throughput, rgb; w: RADIANCE's ray weight (-lw) */               \
    FIELD(float4, rad, PATH_ALWAYS)              /* radiance so far, rgb; w: path length from the eye */             \
    FIELD(uint4, info, PATH_ALWAYS)              /* PC_ flags; sampler: key, index | dim << 8; instance hit */       \
    FIELD(float4, hit, PATH_ALWAYS)              /* t, primitive (bits), u, v */                                     \
    FIELD(float4, shadow_org, PATH_ALWAYS)       /* the shadow ray's origin; w: its source (bits) */                 \
    FIELD(float4, shadow_dir, PATH_ALWAYS)       /* its direction; w: distance of the source */                      \
    FIELD(float4, shadow_rad, PATH_ALWAYS)       /* its light if unoccluded, rgb; w: path length so far */           \
    FIELD(float4, medium, PATH_MEDIA)            /* the medium around, extinction rgb; w: sets of lights (bits) */   \
    FIELD(float4, albedo, PATH_MEDIA)            /* its albedo, rgb; w: eccentricity */                              \
    FIELD(float4, shadow_medium, PATH_MEDIA)     /* the shadow ray's, extinction rgb; w: antimatter (bits) */        \
    FIELD(float4, shadow_albedo, PATH_MEDIA)     /* its albedo, rgb; w: sets of lights (bits) */                     \
    FIELD(float4, prefix_p, PATH_REUSE)          /* prefix vertex: origin of its next ray */                         \
    FIELD(float4, prefix_n, PATH_REUSE)          /* shading normal; w: weight of its own ray, or NO_PREFIX */        \
    FIELD(float4, prefix_ng, PATH_REUSE)         /* geometric normal */                                              \
    FIELD(float4, prefix_throughput, PATH_REUSE) /* throughput without that, rgb; w: survival probability */         \
    FIELD(float4, suffix_p, PATH_REUSE)          /* suffix vertex: point or direction; w: SUFFIX_..*/                \
    FIELD(float4, suffix_n, PATH_REUSE)          /* normal on the ray's side; w: its rounding */                      \
    FIELD(float4, suffix_rad, PATH_REUSE)        /* outgoing radiance, rgb; w: path length as in rad */              \
    FIELD(float4, shadow_suffix, PATH_REUSE)     /* light of the shadow ray for it, rgb; w: 1, 0: none */            \
    FIELD(Transmittances, transmittance, PATH_REUSE) /* along the connections to the suffix vertex (connect.h) */    \
    FIELD(ConnectionWords, pdf, PATH_REUSE)      /* with which the prefix vertices would have sampled it */          \
    FIELD(ConnectionWords, contribution, PATH_REUSE) /* contributions to them, without the panes */                  \
    FIELD(Mixture, mixture, PATH_REUSE)          /* of the prefix vertex */                                          \
    FIELD(uint, connections, PATH_REUSE)         /* visibility of the connections to the suffix vertex */
// clang-format on

#define NO_PREFIX -1.0f   // in place of a weight: there is no prefix vertex
#define SUFFIX_NONE 0.0f  // kinds of suffix_p
#define SUFFIX_POINT 1.0f
#define SUFFIX_DIRECTION 2.0f

// For the connections between a suffix vertex and the prefix vertices of its group: a word each, or a transmittance
// each.
STRUCT(ConnectionWords) { float of[REUSE_GROUP]; };
STRUCT(Transmittances) { float4 of[REUSE_GROUP]; };

#define PATH_POINTER(type, name, when) GLOBAL type* name;
STRUCT(Paths){PATH_STATE(PATH_POINTER)};

#define PATH_ALWAYS 0u
#define PATH_MEDIA 1u
#define PATH_REUSE 2u
FN int has_media(PARAMS(const Params) par) { return HAS(SOLIDS) && par->medium.w > 0.0f; }
FN int has_antimatter(PARAMS(const Params) par) { return HAS(SOLIDS) && (par->flags & PF_ANTIMATTER) != 0u; }
FN int aims_shadows(PARAMS(const Params) par) { return HAS(SOLIDS) && par->shadow_mode == SHADOW_AIMED; }
FN int path_media_used(PARAMS(const Params) par) { return has_media(par) || has_antimatter(par); }
FN uint path_needs(PARAMS(const Params) par) {
    return (path_media_used(par) ? PATH_MEDIA : 0u) | (par->reuse_path_count != 0u ? PATH_REUSE : 0u);
}

// Flags in info.x
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

FN Sampler path_sampler(uint4 info) {
    Sampler rnd;
    rnd.key = info.y;
    rnd.index = info.z & 255u;
    rnd.dim = info.z >> 8;
    rnd.until = 0u;
    return rnd;
}

FN uint path_sampler_word(PRIVATE(const Sampler) rnd) { return rnd->index | (rnd->dim << 8); }

// In place of the primitive that a path has hit: it begins on a sensor.
#define ON_SENSOR 0xfffffffeu
FN int begins_on_sensor(PARAMS(const Params) par, uint flags) {
    return (par->flags & PF_SENSORS) != 0u && path_steps(flags) == 0u;
}

// q: first words of `hit`.
FN Hit path_hit(float4 q, uint4 info) {
    Hit hit;
    hit.t = q.x;
    hit.prim = as_uint_(q.y);
    hit.u = q.z;
    hit.v = q.w;
    hit.inst = info.w;
    return hit;
}

FN void set_path_hit(TABLES(const Paths) paths, uint path, PRIVATE(const Hit) hit) {
    float4 q;
    q.x = hit->t;
    q.y = as_float_(hit->prim);
    q.z = hit->u;
    q.w = hit->v;
    paths->hit[path] = q;
    paths->info[path].w = hit->inst;
}

// Paths of one kind have hit the same type of material (0: none) and take the same branches: where it pays, they are
// shaded together.  By number; several types may share one.
#define PATH_KINDS 64u
FN uint path_kind(TABLES(const SceneTables) s, TABLES(const Paths) paths, uint path) {
    uint prim = as_uint_(paths->hit[path].y);
    return prim >= ON_SENSOR ? 0u : 1u + s->prims[PRIM_WORDS * prim + PRIM_MOD] % (PATH_KINDS - 1u);
}
#endif
