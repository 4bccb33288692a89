// SPDX-License-Identifier: BSD-3-Clause
// The fingerprint of a rendering (film/fingerprint.h): a hash of everything that decides its frames' pixels besides
// seed and frame number.  The scene counts as the flat tables that are uploaded, so that names of files, dates,
// comments and the way a value was written do not matter, but every number that a device sees does; function and data
// files, BSDFs and fonts are in the tables.  Devices and threads do not count, for they give the same bits; a
// device that does not is named behind it (Renderer::fingerprint).
#pragma once
#include <string>
#include "base/hash.h"
#include "flatten/flat_scene.h"
#include "render/focus.h"
#include "render/options.h"
#include "view/view.h"

namespace render {

// The version of the estimator.  Raise it with every change that moves bits of frames (tests/parity/bits_test fails
// then), so that frames from before and after are not taken for parts of one picture.
constexpr int estimator = 21;

// The part of the geometry and the materials, of a scene that still has its triangles.
base::Hash hash_of_geometry(const flatten::FlatScene& scene);

std::string fingerprint(base::Hash geometry, const flatten::FlatScene& scene, const view::View& view, int nx, int ny,
                        const RenderOptions& options, const Focus& focus);

}  // namespace render
