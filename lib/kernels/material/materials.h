// SPDX-License-Identifier: BSD-3-Clause
// Every material of the scene language, one row each: all that the reader, the flattening, region queries and the
// kernels know of its type.  Facts that depend on its arguments are in scene/materials.cpp, its scattering is in
// mat_*.h.  Only macros, for C++ and OpenCL C: each user defines ROW and SAME as it needs them.  To add a material:
// CONTRIBUTING.md (docs/decisions/0015-one-table-of-materials.md has the reasons).
//
//   number    M_number: Modifier.type.  ROW takes the next number, SAME repeats the number of the ROW above it.
//             New rows go to the end, because the numbers are part of a stream's fingerprint
//   type      name in scene files, and scene::Type
//   strings   least number of string arguments (for functions: before their transform)
//   reals     number of real arguments: only(5), any(3,4), from(9)
//   absent    arguments that may be left out: fill(largest number, default value)
//   func.     of its .cal functions: values once a hit, values for each direction of light (cal/pattern.h)
//   light     do shadow rays pass?  yes, no, or ask: depends on the arguments
//   eye       do rays pass with -i, and do sampled rays take it as a mirror's alternate?  The same words
//   region    do region queries see through it?  yes, no
//   back      behaviour from behind, with -bv- and with -bv+:
//               dark   the eye passes, light is stopped; with -bv+ the back as it is
//               turns  the eye passes, light is stopped; with -bv+ the normal turns to the viewer
//               open   both pass; with -bv+ the back as it is
//               thin   both pass; with -bv+ the normal turns to the viewer
//               none   it has no back: -bv has no effect
//   traits    MT_* below, and the MF_* (tables.h) that distinguish rows of the same number
#ifndef LUX_MATERIALS_H
#define LUX_MATERIALS_H

#define MT_EMISSIVE 0x01000000u  // a light
#define MT_BENDS 0x02000000u     // light may leave in another direction: shadow rays are aimed
#define MT_MEDIUM 0x04000000u    // the medium behind it may absorb and scatter
#define MT_CLEAR 0x08000000u     // region
#define MT_TURNS 0x10000000u     // back
#define MT_OPEN_BACK 0x20000000u
#define MT_NO_BACK 0x40000000u
#define MT_EVEN 0x80000000u   // its diffuse light is the same for all viewers (integrator/suffix.h)
#define MT_FLAGS 0x00ffffffu  // the MF_* among the traits

#define REGION_no 0u
#define REGION_yes MT_CLEAR
#define BACK_dark 0u
#define BACK_turns MT_TURNS
#define BACK_open MT_OPEN_BACK
#define BACK_thin (MT_TURNS | MT_OPEN_BACK)
#define BACK_none MT_NO_BACK
// Word of traits of a row
#define MATERIAL_TRAITS(region, back, traits) (REGION_##region | BACK_##back | (traits))

// clang-format off
#define MATERIALS(ROW, SAME) \
  /*   number         type        strings, reals   absent        func. light,eye,region back  traits */                \
  ROW (PLASTIC,       plastic,    0,  only(5),      none,         0, 0, no,  no,  no,  turns, MT_EVEN)                 \
  ROW (METAL,         metal,      0,  only(5),      none,         0, 0, no,  no,  no,  turns, MT_EVEN)                 \
  ROW (TRANS,         trans,      0,  only(7),      none,         0, 0, ask, yes, no,  thin,  MT_EVEN)                 \
  ROW (GLASS,         glass,      0,  any(3,4),     fill(4,1.52), 0, 0, yes, yes, yes, thin,  0)                       \
  ROW (LIGHT,         light,      0,  only(3),      fill(8,0),    0, 0, no,  no,  no,  dark,  MT_EMISSIVE)             \
  ROW (GLOW,          glow,       0,  only(4),      fill(8,0),    0, 0, no,  no,  no,  dark,  MT_EMISSIVE)             \
  ROW (SPOTLIGHT,     spotlight,  0,  only(7),      fill(8,0),    0, 0, no,  no,  no,  dark,  MT_EMISSIVE)             \
  ROW (ILLUM,         illum,      0,  only(3),      fill(8,0),    0, 0, yes, no,  no,  dark,  MT_EMISSIVE)             \
  ROW (MIRROR,        mirror,     0,  only(3),      none,         0, 0, yes, no,  no,  dark,  0)                       \
  ROW (DIELECTRIC,    dielectric, 0,  only(5),      none,         0, 0, yes, yes, yes, none,  MT_BENDS | MT_MEDIUM)    \
  ROW (INTERFACE,     interface,  0,  only(8),      none,         0, 0, yes, yes, yes, none,  MT_BENDS | MT_MEDIUM)    \
  ROW (ANISO_PLASTIC, plastic2,   4,  only(6),      none,         3, 0, no,  no,  no,  turns, MT_EVEN)                 \
  ROW (ANISO_METAL,   metal2,     4,  only(6),      none,         3, 0, no,  no,  no,  turns, MT_EVEN)                 \
  ROW (ANISO_TRANS,   trans2,     4,  only(8),      none,         3, 0, no,  yes, no,  turns, MT_EVEN)                 \
  ROW (ASHIK,         ashik2,     4,  only(8),      none,         3, 0, no,  no,  no,  turns, 0)                       \
  ROW (BRDF,          plasfunc,   2,  from(4),      none,         0, 1, no,  no,  no,  turns, 0)                       \
  SAME(BRDF,          metfunc,    2,  from(4),      none,         0, 1, no,  no,  no,  turns, MF_METAL)                \
  SAME(BRDF,          transfunc,  2,  from(6),      none,         0, 1, no,  no,  no,  turns, MF_TRANS)                \
  SAME(BRDF,          plasdata,   4,  from(4),      none,         0, 1, no,  no,  no,  turns, 0)                       \
  SAME(BRDF,          metdata,    4,  from(4),      none,         0, 1, no,  no,  no,  turns, MF_METAL)                \
  SAME(BRDF,          transdata,  4,  from(6),      none,         0, 1, no,  no,  no,  turns, MF_TRANS)                \
  ROW (BRTD,          BRTDfunc,   10, from(9),      none,         6, 3, yes, ask, no,  none,  0)                       \
  ROW (WGMD,          WGMDfunc,   13, from(9),      none,         9, 0, ask, ask, no,  open,  0)                       \
  ROW (BSDF,          BSDF,       6,  any(0,3,6,9), fill(9,0),    4, 0, ask, ask, no,  open,  0)                       \
  SAME(BSDF,          aBSDF,      5,  any(0,3,6,9), fill(9,0),    3, 0, yes, yes, no,  open,  MF_ABSDF)                \
  ROW (MIST,          mist,       0,  any(0,3,6,7), fill(7,0),    0, 0, yes, yes, yes, dark,  MT_MEDIUM)               \
  ROW (ANTIMATTER,    antimatter, 1,  from(0),      none,         0, 0, yes, yes, yes, dark,  0)                       \
  ROW (PRISM,         prism1,     5,  from(0),      none,         4, 0, yes, no,  yes, none,  MT_BENDS)                \
  SAME(PRISM,         prism2,     9,  from(0),      none,         8, 0, yes, no,  yes, none,  MT_BENDS | MF_TWO_EXITS)
// clang-format on
#endif
