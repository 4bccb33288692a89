// SPDX-License-Identifier: BSD-3-Clause
// Coinciding faces (kernels/bvh/coincide.h), found on the host before the first frame.
#pragma once
#include "flatten/flat_scene.h"
#include "flatten/modifiers.h"

namespace flatten {

// Warns once, with a count, of large polygons and rings of different modifiers that coincide, so that one of them is
// invisible.
void warn_of_coincident(const Modifiers& modifiers, const FlatScene& scene);

// By object: opaque surfaces behind a coinciding surface that shadow rays may pass, a mixture or a BSDF.  Shadow rays
// treat them like that surface.  Flat surfaces, and curved ones of equal numbers.
std::vector<uint8_t> hidden_by_passing(const Modifiers& modifiers, base::Vec3 centre);

// Marks sources that another surface covers in part (Source.covered), by rays to 16 points of each.
void mark_covered_sources(FlatScene& scene);

}  // namespace flatten
