// SPDX-License-Identifier: BSD-3-Clause
// State of the paths in flight, one path each, and the flags that say what a path has been through.
// A path's class is "diffuse" once it has left a surface into the hemisphere (paper section 3; spec shading 0.2).
#ifndef LUX_PATH_STATE_H
#define LUX_PATH_STATE_H

// The one list of what a path is made of: FIELD(type, name, when) for each field, four words a path.  The struct Paths,
// what both devices allocate and the arguments of the OpenCL kernels come from it.  Wide types first, for they are laid
// one after another.
//   when: PATH_ALWAYS, or what makes it needed: PATH_MEDIA media or antimatter in the scene, PATH_REUSE
//   that paths share their suffix vertices
// clang-format off
#define PATH_STATE(FIELD)                                                                                            \
    FIELD(float4, org, PATH_ALWAYS)              /* the ray's origin; w: what is cut away there (bits; clip.h) */    \
    FIELD(float4, dir, PATH_ALWAYS)              /* its direction; w: how far it looks */                            \
    FIELD(float4, throughput, PATH_ALWAYS)       /* throughput, rgb; w: RADIANCE's ray weight (-lw) */               \
    FIELD(float4, rad, PATH_ALWAYS)              /* radiance gathered, rgb; w: path length from the eye */           \
    FIELD(uint4, info, PATH_ALWAYS)              /* PC_ flags; sampler: key, index | dim << 8; instance hit */       \
    FIELD(float4, hit, PATH_ALWAYS)              /* t, primitive (bits), u, v */                                     \
    FIELD(float4, shadow_org, PATH_ALWAYS)       /* the shadow ray's origin; w: its source (bits) */                 \
    FIELD(float4, shadow_dir, PATH_ALWAYS)       /* its direction; w: distance of the source */                      \
    FIELD(float4, shadow_rad, PATH_ALWAYS)       /* what it brings if unblocked, rgb; w: path length so far */       \
    FIELD(float4, medium, PATH_MEDIA)            /* the medium around, extinction rgb; w: sets of lights (bits) */   \
    FIELD(float4, albedo, PATH_MEDIA)            /* its albedo, rgb; w: eccentricity */                              \
    FIELD(float4, shadow_medium, PATH_MEDIA)     /* the shadow ray's, extinction rgb; w: cut away there (bits) */    \
    FIELD(float4, shadow_albedo, PATH_MEDIA)     /* its albedo, rgb; w: sets of lights (bits) */                     \
    FIELD(float4, prefix_p, PATH_REUSE)          /* prefix vertex: its next ray begins; w: portals' light */         \
    FIELD(float4, prefix_n, PATH_REUSE)          /* shading normal; w: factor of its own ray, or NO_PREFIX */        \
    FIELD(float4, prefix_ng, PATH_REUSE)         /* the geometry's; w: highlights met there (bits) */                \
    FIELD(float4, prefix_throughput, PATH_REUSE) /* throughput without that, rgb; w: probability to connect it */    \
    FIELD(float4, suffix_p, PATH_REUSE)          /* suffix vertex: point or direction; w: SUFFIX_..*/                \
    FIELD(float4, suffix_n, PATH_REUSE)          /* normal on the ray's side; w: error scale */                      \
    FIELD(float4, suffix_rad, PATH_REUSE)        /* radiance that it sends out, rgb; w: path length as in rad */     \
    FIELD(float4, shadow_suffix, PATH_REUSE)     /* what the shadow ray brings to it, rgb; w: 1, 0: nothing */       \
    FIELD(Transmittances, transmittance, PATH_REUSE) /* along the connections to the suffix vertex (connect.h) */    \
    FIELD(ConnectionWords, pdf, PATH_REUSE)      /* with which the prefix vertices would have found it */            \
    FIELD(ConnectionWords, contribution, PATH_REUSE) /* what it is worth to them, but for panes */                   \
    FIELD(uint, connections, PATH_REUSE)         /* what is known of them */
// clang-format on

#define NO_PREFIX -1.0f   // a factor that there is not
#define SUFFIX_NONE 0.0f  // what suffix_p is
#define SUFFIX_POINT 1.0f
#define SUFFIX_DIRECTION 2.0f

// Of the connections between a suffix vertex and the prefix vertices of its group, a word or what panes let through
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

// flags in info.x
#define PC_DIFFUSE 1u          // some ancestor was a hemisphere sample
#define PC_ROUGH 2u            // some ancestor was a rough-specular sample
#define PC_BENT 4u             // some reflection or refraction lies behind: not the eye's straight ray
#define PC_RECORDS_SUFFIX 64u  // it has a prefix vertex, and no suffix vertex yet (suffix.h)
#define PC_SUFFIX 128u         // what it gathers is what its suffix vertex sends out
#define PC_LEVEL_SHIFT 8u      // reflection level, 8 bits
#define PC_AB_SHIFT 16u        // diffuse depth, 8 bits
#define PC_STEP_SHIFT 24u      // surfaces met, 8 bits, saturating
#define PC_STEP_LIMIT 250u

// Has a diffuse or rough surface sent the path on?  Else it is the eye's ray, or one that mirrors and panes have
// turned.
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

// q: words of `hit`.
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

// Paths of one kind have met the same material, or nothing (0), and take the same branches: they are shaded side by
// side where that pays.  By number; many materials may share one.
#define PATH_KINDS 64u
FN uint path_kind(TABLES(const SceneTables) s, TABLES(const Paths) paths, uint path) {
    uint prim = as_uint_(paths->hit[path].y);
    return prim == NO_HIT ? 0u : 1u + s->prims[PRIM_WORDS * prim + PRIM_MOD] % (PATH_KINDS - 1u);
}
#endif
