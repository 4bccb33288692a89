// SPDX-License-Identifier: BSD-3-Clause
// The fingerprint of a rendering (film/fingerprint.h): a hash of everything that decides the pixels of its frames
// besides seed and frame number.  The scene enters by the flat tables that are uploaded: names of files, dates,
// comments and spelling of values have no effect, but every number that a device reads has; function and data files,
// BSDFs and fonts are in the tables.  Devices and threads give the same bits and do not enter; a device that gives
// others is named after it (plan_view()).
#pragma once
#include <string>
#include "base/hash.h"
#include "flatten/flat_scene.h"
#include "render/focus.h"
#include "render/options.h"
#include "view/view.h"

namespace render {

// Version of the estimator.  Raise it with every change that moves bits of frames (tests/parity/bits_test fails then),
// so that frames from before and after are never summed.
constexpr int estimator = 32;

// Hash of the geometry and the materials, of a scene that still has its triangles.
base::Hash hash_of_geometry(const flatten::FlatScene& scene);

// view: its options, or which points these are.
std::string fingerprint(base::Hash geometry, const flatten::FlatScene& scene, const std::string& view, int nx, int ny,
                        const RenderOptions& options, const Focus& focus);

}  // namespace render
