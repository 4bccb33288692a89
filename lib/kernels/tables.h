// SPDX-License-Identifier: BSD-3-Clause
// Layout of the flat scene: what lib/flatten writes and the kernels read.
// u = word arena, f = float arena of SceneTables; "at" means an index into one of them.  Positions are relative to the
// scene's centre (Params.centre gives it back), so that single precision stays fine far from the origin.
#ifndef LUX_TABLES_H
#define LUX_TABLES_H
#include "kernels/material/materials.h"

// ---- primitives: PRIM_WORDS words each in SceneTables.prims
#define PRIM_WORDS 8u
#define PRIM_KIND 0u    // PRIM_FLAT.. | flags
#define PRIM_MOD 1u     // modifier index, NONE if void
#define PRIM_SOURCE 2u  // active source index, NONE
#define PRIM_NORMAL 3u  // flat: 3 floats, unit; curved: shape index in word 3
#define PRIM_VERTEX 6u  // PRIM_SMOOTH: index into u of three words, the corners' CORNER_FLOATS in f: normal, Lu, Lv
#define CORNER_FLOATS 5u
#define PRIM_OFFSET 7u  // flat: n.p of its plane (float)
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
#define NONE 0xffffffffu

// ---- instances: records of SHAPE_FLOATS floats in SceneTables.shapes, after all shapes; Hit.inst is the number of one
#define INST_SHAPE 0u   // its SHAPE_INSTANCE (word): the matrix to the tree's coordinates
#define INST_FRAME 1u   // 12: matrix to the coordinates that functions of the modifiers see
#define INST_MOD 13u    // modifier in place of all those inside (word), NONE = their own
#define INST_SCALE 14u  // a world length in the coordinates of INST_FRAME

// ---- modifiers: MOD_WORDS words each at u[Params.mods_at]
#define MOD_WORDS 8u
#define MOD_TYPE 0u
#define MOD_NEXT 1u     // next modifier up the chain, NONE
#define MOD_PROGRAM 2u  // .cal program entry, NONE
#define MOD_ARGS 3u     // index into f of the real arguments
#define MOD_BRANCH1 4u  // mixtures: foreground; illum, mirror: alternate
#define MOD_BRANCH2 5u  // mixtures: background
#define MOD_FLAGS 6u
#define MOD_EXTRA 7u  // BSDF tables; sets of sources that a mist names, one bit each
// types
#define M_PATTERN1 1u  // program gives brightness
#define M_PATTERN3 2u  // program gives RGB
#define M_TEXTURE 3u   // program gives a displacement
#define M_MIXTURE 4u   // program gives the foreground's share
// materials: M_* of the rows of materials.h
#define M_FIRST_MATERIAL 16u
#define NUMBER_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) M_##number,
#define NOTHING_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits)
enum { M_BEFORE_MATERIALS = M_FIRST_MATERIAL - 1u, MATERIALS(NUMBER_OF_ROW, NOTHING_OF_ROW) M_END };
// flags
#define MF_SEEN_THROUGH 1u       // a type that -i sees through
#define MF_HAS_ALTERNATE 2u      // MOD_BRANCH1 is an alternate material (NONE = void)
#define MF_ABSDF 4u              // the straight part of the BSDF is a ray of its own
#define MF_ALTERNATE_PASSES 32u  // the alternate is void or a transparent type
#define MF_METAL 8u              // the specular colour is the surface's
#define MF_TRANS 16u
#define MF_VALUES 64u          // MOD_PROGRAM gives values of the material (cal::MaterialProgram)
#define MF_PATTERNS_ONLY 256u  // a mixture whose branches hold no material
#define MIX_DEPTH 8            // mixtures of patterns one inside the other (flatten/modifiers.cpp refuses more)
#define MF_TWO_EXITS 128u      // prism2
#define MF_CLIPPED_SHIFT 9u    // 4 bits: listed by antimatter 0..3
#define MF_ALBEDO 8192u        // a mist that states its albedo
#define MF_ECCENTRICITY 16384u
#define MF_LOOKS 32768u     // it or one of its modifiers depends on the viewing direction or distance
#define MF_TOTAL 65536u     // likewise, on the whole path length from the eye
#define MF_PLACE 131072u    // likewise, on the point; of distant surfaces, on the ray's origin
#define MF_LOBES_SHIFT 18u  // number of outputs of the lobe program (MOD_EXTRA)

// ---- what the kernels ask of a type of material: MT_* of materials.h by number
#define TRAITS_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) \
    MATERIAL_TRAITS(region, back, traits),
CONSTANT uint material_traits[] = {MATERIALS(TRAITS_OF_ROW, NOTHING_OF_ROW)};
FN uint material_has(uint type, uint trait) { return material_traits[type - M_FIRST_MATERIAL] & trait; }

// ---- active sources: SOURCE_FLOATS floats each at f[Params.sources_at] (words by as_uint_)
#define SOURCE_FLOATS 32u
#define SRC_KIND 0u         // SK_*
#define SRC_PRIM 1u         // prim (word); NONE for distant
#define SRC_MOD 2u          // modifier (word)
#define SRC_CENTRE 3u       // 3: centre, or unit direction to a distant source
#define SRC_U 6u            // 3: half vector
#define SRC_V 9u            // 3: half vector (sphere: U.x = radius)
#define SRC_NORMAL 12u      // 3
#define SRC_AREA 15u        // m2, or sr for distant sources
#define SRC_CAP 16u         // distant: 1 - cos of the half angle
#define SRC_POWER 17u       // luminance-like radiance for choosing
#define SRC_MAXRAD 18u      // glow: > 0 limit; else 0
#define SRC_SPOT 19u        // 3: aim of a spotlight, unit
#define SRC_SPOT_COS 22u    // cosine of its half cone, NO_SPOT for other sources
#define SRC_SPOT_FOCUS 23u  // its focal length
#define NO_SPOT -2.0f
#define IS_SPOT(src) ((src)[SRC_SPOT_COS] > -1.5f)
#define SRC_RADIUS 24u   // bounding radius around the centre (rings, spheres)
#define SRC_TRIS 25u     // general polygons: index into f of its fan of triangles (word)
#define SRC_NTRIS 26u    // and their number (word)
#define SRC_CLASS 27u    // M_LIGHT, M_GLOW, M_SPOTLIGHT, M_ILLUM (word)
#define SRC_VIRTUAL 28u  // virtual sources: relay record in u (word), NONE for real ones
#define SRC_SHEARED 30u  // 1 = a sphere or a distant source seen through a prism: SRC_U, V, NORMAL are its axes
#define SRC_COVERED 31u  // 1 = another surface lies in its plane and may hide a part of it

// a triangle of the fan: a corner, then
#define FAN_FLOATS 12u
#define FAN_EDGE1 3u  // 3
#define FAN_EDGE2 6u  // 3
#define FAN_UPTO 9u   // share of the source's area up to this triangle, with it
#define FAN_FROM 10u  // and without it

// ---- relay record of a virtual source, in u (spec shading 4.6)
#define RELAY_PRIM 0u
#define RELAY_SOURCE 1u        // the source behind it, real or virtual
#define RELAY_EXIT 2u          // of a prism: 0, 1
#define RELAY_APERTURES 3u     // how many apertures
#define RELAY_APERTURES_AT 4u  // index into f of the first
// aperture: a rectangle around a relay, at its apparent place from the point lit, the nearest first
#define APERTURE_FLOATS 13u
#define APERTURE_CENTRE 0u       // 3
#define APERTURE_NORMAL 3u       // 3
#define APERTURE_U 6u            // 3: axis over its half length
#define APERTURE_V 9u            // 3
#define APERTURE_BOTH_SIDES 12u  // a prism's: no back
#define SK_DISTANT 0u
#define SK_PARALLELOGRAM 1u
#define SK_POLYGON 2u  // triangle fan with areas
#define SK_RING 3u
#define SK_SPHERE 4u
#define SK_CYLINDER 5u

// Tree of many sources (light_tree.h): LIGHT_FLOATS floats a node at f[Params.light_tree_at], each node followed by its
// two subtrees
#define LIGHT_TREE_FROM 33u  // least number of sources of a tree
#define LIGHT_FLOATS 16u
#define LIGHT_CENTRE 0u         // 3: of a ball about all its sources, or of the unit directions to distant ones
#define LIGHT_RADIUS 3u         // of the ball
#define LIGHT_AXIS 4u           // 3: unit, about which the normals of its sources lie; 0 if some have none
#define LIGHT_SPREAD 7u         // how far the normals are from the axis
#define LIGHT_POWER 8u          // radiance (SRC_POWER) times area, the sum
#define LIGHT_FAR 9u            // no source reaches points this far from the centre; 0: distant sources
#define LIGHT_APERTURES 10u     // how many apertures are the same for all its sources (word)
#define LIGHT_APERTURES_AT 11u  // index into f of the first (word)
#define LIGHT_PAST 12u          // the node after this one's subtree (word)
#define LIGHT_SOURCE 13u        // a single source (word); NONE: two children
#define LIGHT_SHARE 14u         // probability of the first child, by power

// ---- sets of sources that mists name, in a set those that the same mists name: LIGHT_SET_WORDS words each at
// u[Params.light_sets_at]
#define LIGHT_SET_WORDS 2u
#define LIGHT_SET_FIRST 0u  // index into u of the source indices
#define LIGHT_SET_COUNT 1u

// ---- distant surfaces ("source" primitives), in the order they are tried: DISTANT_WORDS words at u[Params.distant_at]
#define DISTANT_WORDS 8u
#define DISTANT_DIR 0u             // 3 floats
#define DISTANT_CAP 3u             // 1 - cos of the half angle (as such: cos would round a sun); > 2 = everything
#define DISTANT_SEEN 4u            // visible modifier, of an illum its alternate; NONE: the eye sees past it
#define DISTANT_BLACK 0xfffffffeu  // its alternate emits nothing
#define DISTANT_SOURCE 5u          // active source index, NONE

// Portals (windows, patches of sun, glossy reflectors in it), toward which diffuse directions are sampled:
// PORTAL_FLOATS floats at f[Params.portals_at]
#define PORTAL_FLOATS 28u
#define PORTAL_CENTRE 0u    // 3
#define PORTAL_U 3u         // 3: edge
#define PORTAL_V 6u         // 3: the other edge
#define PORTAL_NORMAL 9u    // 3: unit, away from the side that it lights
#define PORTAL_ALONG_U 12u  // 3: dot product with an offset from the centre in its plane gives the fraction of edge u
#define PORTAL_ALONG_V 15u  // 3: of edge v
#define PORTAL_AREA 18u
#define PORTAL_GLOSS2 19u  // a glossy rectangle in the sun: its roughness, squared; else 0
#define PORTAL_SUN 20u     // 3: unit, toward the sun that it mirrors
// of the unit vector toward the mirrored sun, from the side that it lights:
#define PORTAL_MIRRORED_OUT 23u  // along the normal
#define PORTAL_MIRRORED_U 24u    // how much of the edge u it is, and the inverse of that
#define PORTAL_MIRRORED_PER_U 25u
#define PORTAL_MIRRORED_V 26u
#define PORTAL_MIRRORED_PER_V 27u
#define MOST_PORTALS 32u

// Highlights (sunlit rectangles on glossy planes): HIGHLIGHT_FLOATS floats at f[Params.highlights_at]
#define HIGHLIGHT_FLOATS 16u
#define HIGHLIGHT_CORNER 0u   // 3
#define HIGHLIGHT_U 3u        // 3: edge from the corner
#define HIGHLIGHT_V 6u        // 3: the other, perpendicular
#define HIGHLIGHT_NORMAL 9u   // 3: unit, on the sun's side
#define HIGHLIGHT_DIR 12u     // 3: unit, toward the mirrored sun, from above
#define HIGHLIGHT_ALPHA2 15u  // roughness, squared
#define MOST_HIGHLIGHTS 8u

// ---- of a view, in SceneTables.view: first a word for each active source, how frame 0 holds it by area, so that
// samples must not see it
#define DRAWN_STRAIGHT 1u  // along the eye's straight rays
#define DRAWN_IMAGES 2u    // mirrored or refracted, in the images that follow
// images of the sun (render/sun_images.h), discs of camera directions: IMAGE_WORDS floats each from Params.images_at on
#define IMAGE_WORDS 4u
#define IMAGE_DIR 0u  // 3: unit
#define IMAGE_CAP 3u  // 1 - cos of the half angle
#define MOST_IMAGES 128u
// points of ptrace -points, one for each pixel, from Params.points_at on: POINT_WORDS floats each
#define POINT_WORDS 6u
#define POINT_ORG 0u  // 3: of a sensor, above the surface on which it may lie
#define POINT_DIR 3u  // 3: unit; of a sensor, against its normal; 0: the pixel has no point
// pixels with several samples in each frame, from Params.focus_at on: a pass makes `spp` samples for an entry
#define FOCUS_WORDS 3u
#define FOCUS_PIXEL 0u
#define FOCUS_ALL 1u   // samples that its pixel has in each frame
#define FOCUS_FROM 2u  // those of this entry: FOCUS_FROM .. FOCUS_FROM + spp - 1

// Parameters of a pass besides the tables; one block, uploaded per pass.
STRUCT(Params) {
    // view
    float4 view_org, view_d, view_h, view_u;  // xyz; w: view_d type letter as float, view_h focal distance
    float4 view_size;                         // horizontal and vertical scale by type, shift, lift
    float4 view_clip;                         // fore, aft, pj, pd (aperture)
    float4 centre;                            // world position of the tables' origin
    float4 av;
    float4 ray_org, ray_dir;  // MODE_RAY
    float4 albedo;            // of the medium: -ma rgb, w = -mg
    float4 medium;            // global extinction rgb; w = 1 if any segment of the scene may absorb
    // sizes and modes
    uint nx, ny, mode, frame;                  // frame = sample index of global index 0
    uint seed_lo, seed_hi, path_count, first;  // first = global index of path 0
    uint mods_at, sources_at, source_count, distant_at;
    uint distant_count, portals_at, portal_count, shadow_mode;
    int ab, lr;
    uint bv, flags;
    float st, ss, dj, lw;
    float ds;
    uint light_sets_at;
    uint skip_direct_below, light_tree_at;
    float least_lobe_prob;  // least probability of a lobe (integrator/sample_bsdf.h); 0: none
    float portal_rest;      // light from other directions than portals (portals.h)
    uint highlights_at, highlight_count;
    float highlight_share;            // mixture weight of highlights, where there are any (highlights.h)
    uint samples_per_pass;            // paths of a pixel side by side: samples frame .. frame + samples_per_pass - 1
    uint light_nodes;                 // nodes of the light tree; 0: each source is evaluated
    float portal_least, portal_most;  // mixture weight of portals, where there are any
    uint window_count;                // of all portals; patches of sun and glossy reflectors follow
    uint spp, focus_at;     // samples of a frame of a pixel; above 1: those of the entries of the view from there on
    uint reuse_path_count;  // of a sample whose paths share their suffix vertices (path_reuse.h); 0: none does
    uint redraw;            // not 0: other random numbers than usual, except for the point in the pixel and on the lens
    uint drawn_count;       // sources with a word in the view table
    uint images_at, image_count;
    uint points_at, point_count;       // of pictures of points; else 0
    float portal_light[MOST_PORTALS];  // per unit of its view
    uint portal_pick[MOST_PORTALS];    // their records
};

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
#define PF_DIRECTIONS 32u      // MODE_IMAGE: in place of light, the direction in which a bent path leaves the scene
#endif
