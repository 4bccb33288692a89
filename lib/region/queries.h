// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of a scene that the shapes "surface NAME" and "modifier NAME" mean.
#pragma once
#include <vector>
#include "region/region.h"

namespace region {

// By shape, then by surface: is it meant?  Empty for shapes that ask nothing.  Throws Error for a name that no surface
// has.
std::vector<std::vector<char>> meant_surfaces(const Regions& regions, const SceneView& scene);

}  // namespace region
