// SPDX-License-Identifier: BSD-3-Clause
// The surfaces that the eye sees along a ray, for regions.  traced.cpp answers by the geometry and the
// traversal that render; none.cpp stands in where the tracer's libraries are not built.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/find_file.h"
#include "region/region.h"

namespace visibility {

// Null if there are no files.  Throws Error for a scene that cannot be read.
std::unique_ptr<region::SceneView> open_scene(const std::vector<std::string>& files, const base::ReadOptions& options);

}  // namespace visibility
