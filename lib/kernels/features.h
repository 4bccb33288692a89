// SPDX-License-Identifier: BSD-3-Clause
// Optional features of scenes.  A device that compiles the kernels for its scene (OpenCL on GPUs) defines LUX_HAS with
// the features present; the code of the others is left out, because each work item of a GPU would reserve registers for
// it (docs/decisions/0031-kernels-of-a-scene.md).  All other builds have all features.  device/features.h finds those
// of a scene.
#ifndef LUX_FEATURES_H
#define LUX_FEATURES_H

#define FEATURE_PATTERNS 1u   // surfaces or active sources with patterns, textures, mixtures, alternates
#define FEATURE_FUNCTIONS 2u  // materials with .cal functions or tables of their own
#define FEATURE_SOLIDS 4u     // media, dielectrics, antimatter; aimed shadow rays
#define FEATURE_INSTANCES 8u
#define FEATURE_SKY 16u  // paths without a hit are shaded among the others; else by a kernel of their own

#ifndef LUX_HAS
#define LUX_HAS 0xffffffffu
#endif
#define HAS(feature) ((LUX_HAS & FEATURE_##feature) != 0u)
#define ONLY(feature, bits) (HAS(feature) ? (bits) : 0u)
#endif
