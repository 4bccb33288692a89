// SPDX-License-Identifier: BSD-3-Clause
// Everything toward which diffuse directions are sampled besides the cosine lobe, found by rays through the finished
// geometry.
#pragma once
#include "sampling/highlights.h"
#include "sampling/portals.h"

namespace sampling {

// Appends the records of highlights and portals to the scene's tables.
inline void find_targets(flatten::FlatScene& scene, const std::vector<Target>& windows, const base::WorkBudget& work) {
    find_highlights(scene, work);
    find_portals(scene, windows);
}

}  // namespace sampling
