// SPDX-License-Identifier: BSD-3-Clause
// Kinds and flags in the records (records.h), and the parameters of a pass.
// u = word arena, f = float arena of SceneTables; "at" means an index into one of them.
#ifndef LUX_TABLES_H
#define LUX_TABLES_H
#include "kernels/material/materials.h"
#include "kernels/records.h"

// ---- Prim.kind: one of these, and flags
#define PRIM_FLAT 1u
#define PRIM_SPHERE 2u
#define PRIM_CONE 3u
#define PRIM_SMOOTH 4u  // mesh triangle with normals and/or uv
#define PRIM_KIND_MASK 15u
#define PRIM_INWARD 16u                 // bubble, cup, tube
#define PRIM_TEXTURE_FLAT 32u           // polygon or ring ("flat flag")
#define PRIM_CORNER_NORMALS 64u         // PRIM_SMOOTH: all three corners have normals
#define PRIM_EXTENT_SHIFT 24u           // 8 bits: exponent of the length to which its rounding is relative
#define SURFACE_ROUNDING 5.9604645e-7f  // rounding over that length and the coordinates: 10 * 2^-24 (offset_ray.h)
#define PRIM_CLEAR 128u                 // its modifier is of a transparent type, as RADIANCE has them (coincide.h)

// ---- Modifier.type
#define M_PATTERN1 1u  // program gives brightness
#define M_PATTERN3 2u  // program gives RGB
#define M_TEXTURE 3u   // program gives a displacement
#define M_MIXTURE 4u   // program gives the foreground's share
// materials: M_* of the rows of materials.h
#define M_FIRST_MATERIAL 16u
#define NUMBER_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) M_##number,
#define NOTHING_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits)
enum { M_BEFORE_MATERIALS = M_FIRST_MATERIAL - 1u, MATERIALS(NUMBER_OF_ROW, NOTHING_OF_ROW) M_END };
// Modifier.flags
#define MF_SEEN_THROUGH 1u       // a type that -i sees through
#define MF_HAS_ALTERNATE 2u      // branch1 is an alternate material (NONE = void)
#define MF_ABSDF 4u              // the straight part of the BSDF is a ray of its own
#define MF_ALTERNATE_PASSES 32u  // the alternate is void or a transparent type
#define MF_METAL 8u              // the specular colour is the surface's
#define MF_TRANS 16u
#define MF_VALUES 64u          // its program gives values of the material (cal::MaterialProgram)
#define MF_PATTERNS_ONLY 256u  // a mixture whose branches hold no material
#define MIX_DEPTH 8            // mixtures of patterns one inside the other (flatten/modifiers.cpp refuses more)
#define MF_TWO_EXITS 128u      // prism2
#define MF_CLIPPED_SHIFT 9u    // 4 bits: listed by antimatter 0..3
#define MF_ALBEDO 8192u        // a mist that states its albedo
#define MF_ECCENTRICITY 16384u
#define MF_LOOKS 32768u     // it or one of its modifiers depends on the viewing direction or distance
#define MF_TOTAL 65536u     // likewise, on the whole path length from the eye
#define MF_PLACE 131072u    // likewise, on the point; of distant surfaces, on the ray's origin
#define MF_LOBES_SHIFT 18u  // number of outputs of the lobe program

// ---- what the kernels ask of a type of material: MT_* of materials.h by number
#define TRAITS_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) \
    MATERIAL_TRAITS(region, back, traits),
CONSTANT uint material_traits[] = {MATERIALS(TRAITS_OF_ROW, NOTHING_OF_ROW)};
FN uint material_has(uint type, uint trait) { return material_traits[type - M_FIRST_MATERIAL] & trait; }

// ---- SceneTables.drawn: what frame 0 holds by area, so that samples must not see it
#define DRAWN_STRAIGHT 1u  // along the eye's straight rays
#define DRAWN_IMAGES 2u    // mirrored or refracted, in SceneTables.sun_images

// Number of a shadow ray's source: one of the suns of many hours, radiance 1 (integrator/hours.h).
#define SUN_OF_HOUR 0x80000000u

// Parameters of a pass besides the tables; one block, uploaded per pass.
STRUCT(Params) {
    // view
    Packed3 view_org, view_d, view_h, view_u;  // eye; direction, right and up, unit
    uint view_type;                            // letter of -vt
    float view_scale_x, view_scale_y;          // horizontal and vertical scale by type
    float view_shift, view_lift;               // -vs -vl
    float view_fore, view_aft;                 // -vo -va
    float focal_distance, lens_diameter;       // -pd
    float pixel_jitter;                        // -pj
    Packed3 centre;                            // world position of the tables' origin
    Packed3 av;
    Packed3 ray_org, ray_dir;    // MODE_RAY
    Packed3 extinction, albedo;  // of the global medium: -me -ma
    float eccentricity;          // -mg
    uint may_absorb;             // 1 if any segment of the scene may lie in a medium
    // sizes and modes
    uint nx, ny, mode, frame;                  // frame = sample index of global index 0
    uint seed_lo, seed_hi, path_count, first;  // first = global index of path 0
    RECORD_TABLES(TABLE_COUNT)                 // sources_count ...; no light nodes: each source is evaluated
    uint window_count, shadow_mode;            // windows: of all portals; others follow
    int ab, lr;
    uint bv, flags;
    float st, ss, dj, lw;
    float ds;
    uint skip_direct_below;
    float least_lobe_prob;            // least probability of a lobe (integrator/sample_bsdf.h); 0: none
    float portal_rest;                // light from other directions than portals (portals.h)
    float highlight_share;            // mixture weight of highlights, where there are any (highlights.h)
    uint samples_per_pass;            // paths of a pixel side by side: samples frame .. frame + samples_per_pass - 1
    float portal_least, portal_most;  // mixture weight of portals, where there are any
    uint spp, focus_at;             // samples of a pixel in a frame; above 1: of the pixels in `focus` from focus_at on
    uint reuse_path_count;          // of a sample whose paths share their suffix vertices (path_reuse.h); 0: none does
    uint reuse_rounds, reuse_turn;  // of many hours (path_reuse.h); of this round
    uint suns_step, suns_step_eye;  // of the suns of many hours a vertex asks each n-th, n a power of two (hours.h)
    uint hours_sky_at;              // the sky of the hours is in distant, from this one on
    uint redraw;  // not 0: other random numbers than usual, except for the point in the pixel and on the lens
    VIEW_TABLES(TABLE_COUNT)
    float portal_light[MOST_PORTALS];  // per unit of its view
    uint portal_pick[MOST_PORTALS];    // their records
};

// Sizes of all records on a device, which the host compares with its own (device/layout.h).  Without gaps between
// members, records of one size have one layout.
#define RECORD(type) *sizes++ = (uint)sizeof(UNIFORM type);
FN void record_sizes(GLOBAL uint* UNIFORM sizes) { RECORDS }
#undef RECORD

// modes: what a pass computes
#define MODE_DIRECT 0u  // frame 0: paths without a diffuse bounce
#define MODE_FRAMES 1u  // frames k >= 1: diffuse class; both classes where frame > skip_direct_below
#define MODE_RAY 2u     // all classes along one given ray (tests, -I)
#define MODE_SPLAT 3u   // straight rays to splatted emitters
#define MODE_PILOT 4u   // given rays, followed up to their first diffuse bounce (integrator/pilot.h)
#define MODE_IMAGE 5u   // given places of the picture, followed along specular paths to the sun (integrator/image.h)
// dir.w of a path in MODE_PILOT and MODE_IMAGE:
#define PILOT_FROM_EYE -2.0f   // its ray is given as the place (org.x, org.y) in the picture, 0 .. 1
#define PILOT_AT_BOUNCE -1.0f  // it has reached a bounce: org is the point, dir the normal there
// shadow_mode: surfaces between a point and a source
#define SHADOW_OPAQUE 0u    // none transmits light
#define SHADOW_STRAIGHT 1u  // glass and the like: light continues straight
#define SHADOW_AIMED 2u     // dielectrics and virtual sources: surface by surface, direction may change
// flags
#define PF_IRRADIANCE 1u
#define PF_DV 2u  // light sources visible
#define PF_ANTIMATTER 4u
#define PF_SKY_PLACES 8u       // distant surfaces look different from place to place
#define PF_EYE_ON_SURFACE 16u  // rays of the eye may begin on a surface, which they must not hit
#define PF_SENSORS 64u         // paths begin on the points, as on white diffuse surfaces; else as rays from them
#define PF_HOURS 128u          // paths for many hours (integrator/hours.h)
#define PF_ASKS 256u           // a pixel of `focus` asks suns of its own
#define PF_GATHERS 512u        // paths for many hours end at suffix vertices, which are sensors of a pass of their own
#define PF_DIRECTIONS 32u      // MODE_IMAGE: in place of light, the direction in which a bent path leaves the scene
#endif
