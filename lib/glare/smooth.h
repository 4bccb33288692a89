// SPDX-License-Identifier: BSD-3-Clause
// evalglare's smoothing (-s): a dark pixel joins every group that holds more than a fifth of the solid angle around it.
#pragma once
#include <cstdint>
#include <vector>
#include "glare/connected_components.h"

namespace glare {

struct Joining {
    uint32_t pixel, group;
};

// The dark valid pixels that join the groups of `runs` (in picture order) within `radius` pixels, columns from the left
// and from the bottom; entries of one pixel by group.  In time proportional to pixels times radius.
std::vector<Joining> smooth(const std::vector<Run>& runs, const Geometry& geometry, float radius);

}  // namespace glare
