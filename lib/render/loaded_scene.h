// SPDX-License-Identifier: BSD-3-Clause
// A scene as all stages of rendering take it: its tables, which nothing changes any more.
#pragma once
#include <memory>
#include "base/hash.h"
#include "flatten/flat_scene.h"
#include "render/options.h"
#include "sampling/smooth_planes.h"
#include "scene/object.h"

namespace render {

struct LoadedScene {
    std::shared_ptr<const flatten::FlatScene> tables;
    base::Hash geometry;              // of the fingerprint
    sampling::SmoothSurfaces smooth;  // that may mirror its sun, if it has one
};

// Flattens a scene and finds where its diffuse directions are to be aimed.  Throws Error (unsupported input with
// file:line).
LoadedScene load_scene(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files);

}  // namespace render
