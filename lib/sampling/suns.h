// SPDX-License-Identifier: BSD-3-Clause
// Distant and small active sources.
#pragma once
#include <vector>
#include "base/vec.h"
#include "flatten/flat_scene.h"

namespace sampling {

// Unit directions toward them.
std::vector<base::Vec3> suns_of(const flatten::FlatScene& scene);

}  // namespace sampling
