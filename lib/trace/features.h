// SPDX-License-Identifier: BSD-3-Clause
// What of kernels/features.h a scene and a pass have, FEATURE_* bits.
#pragma once
#include "flatten/flat_scene.h"
#include "kernels/host.h"

namespace trace {

uint32_t features_of_scene(const flatten::FlatScene& scene);
// Those of a pass beside those known: both.
uint32_t with_features_of_pass(uint32_t known, const kernels::Params& par);
// Do kernels of their own walk the chains of modifiers?  These are a program of its own.
inline bool chains_apart(uint32_t features) {
    return (features & FEATURE_PATTERNS) != 0 && (features & FEATURE_CHAINS) == 0;
}

}  // namespace trace
