// SPDX-License-Identifier: BSD-3-Clause
// The trees over the geometry of a scene.
#pragma once
#include "flatten/flat_scene.h"
#include "flatten/flatten.h"

namespace flatten {

// Geometry as the builders take it; it stays with the scene.
std::vector<bvh::Input> build_inputs(const FlatScene& s);
// Builds the trees of finished geometry, or takes those of a known scene of the same surfaces (options.known).
// work: is looked up from while a tree is built.
Trees build_trees(const FlatScene& s, const Options& options, const base::WorkBudget& work);

}  // namespace flatten
