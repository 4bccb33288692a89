// SPDX-License-Identifier: BSD-3-Clause
// Faces in one place (kernels/bvh/coincide.h), as the host sees them before the first frame.
#pragma once
#include "flatten/flat_scene.h"
#include "flatten/modifiers.h"

namespace flatten {

// One warning that counts large polygons and rings of different modifiers which cover each other, so that there one of
// them is not seen.
void warn_of_coincident(const Modifiers& modifiers, const FlatScene& scene);

// By object: opaque surfaces that hide behind one in their place which lets shadow rays pass, a mixture or a BSDF.
// Shadow rays look at them one by one, as at that one.  Flat ones, and curved ones of the same numbers.
std::vector<uint8_t> hidden_by_passing(const Modifiers& modifiers);

// Marks sources that something else covers in part (SRC_COVERED), by rays to 16 points of each.
void mark_covered_sources(FlatScene& scene);

}  // namespace flatten
