// SPDX-License-Identifier: BSD-3-Clause
// What many scenes have not.  A device that compiles the kernels for its scene (OpenCL on GPUs) says by LUX_HAS which
// of these there are; the text of the others is then left out, for which each work item of a GPU would keep registers,
// whether it comes there or not (docs/decisions/0031-kernels-of-a-scene.md).  All other builds have all of them.
// device/features.h finds those of a scene.
#ifndef LUX_FEATURES_H
#define LUX_FEATURES_H

#define FEATURE_PATTERNS 1u   // surfaces or active sources with patterns, textures, mixtures, alternates
#define FEATURE_FUNCTIONS 2u  // materials with .cal functions or tables of their own
#define FEATURE_SOLIDS 4u     // what lies between surfaces: dielectrics, media, antimatter; shadow rays that are aimed
#define FEATURE_INSTANCES 8u
#define FEATURE_SKY 16u  // paths that have met nothing are shaded among the others; else by a kernel of their own

#ifndef LUX_HAS
#define LUX_HAS 0xffffffffu
#endif
#define HAS(feature) ((LUX_HAS & FEATURE_##feature) != 0u)
#define ONLY(feature, bits) (HAS(feature) ? (bits) : 0u)
#endif
