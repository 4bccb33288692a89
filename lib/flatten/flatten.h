// SPDX-License-Identifier: BSD-3-Clause
// From a scene to the flat tables of the kernels.
#pragma once
#include "flatten/flat_scene.h"
#include "scene/object.h"

namespace flatten {

// What the tables depend on besides the scene; letters as in ptrace's options.
struct Options {
    int dr = 2;           // levels of virtual sources
    bool bv = true;       // back faces are visible
    bool portals = true;  // guide diffuse samples to windows (off: tests that it does not move the mean)
};

// Throws Error naming file:line for what cannot be rendered.
FlatScene flatten(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files);

}  // namespace flatten
