// SPDX-License-Identifier: BSD-3-Clause
// From a scene to the flat tables of the kernels.
#pragma once
#include <memory>
#include <optional>
#include "flatten/flat_scene.h"
#include "scene/object.h"

namespace flatten {

struct BandColours;  // flatten/band_colours.h

using scene::Object, scene::Type;
using Reals = scene::Span<double>;

// Options on which the tables depend; letters as in ptrace's options.
struct Options {
    int dr = 2;                    // levels of virtual sources
    bool bv = true;                // back faces are visible
    bool any_reflectance = false;  // also materials that give back twice the light that they get (reflectance.h)
    std::optional<Viewpoint> eye;  // which may move the origin of the tables (centre_of)
    Trees known;                   // of a scene flattened before: taken where the surfaces are the same
    bool compact_tree = false;     // also the tree for GPUs
    bool names = false;            // keep the names of surfaces and modifiers (FlatScene::modifier_names)
    std::shared_ptr<const BandColours> bands;  // in place of R, G and B; null: these
    bvh::Tell tell_tree;                       // for people who wait: which share of a tree is built
};

// Throws Error naming file:line for what cannot be rendered.
FlatScene flatten(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files);

}  // namespace flatten
