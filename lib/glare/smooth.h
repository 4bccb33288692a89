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

// Dark valid pixels that join the groups of `runs` (in picture order) within `radius` pixels, columns from the left and
// from the bottom; one entry per pixel and group.  Time is proportional to pixels times radius.
std::vector<Joining> smooth(const std::vector<Run>& runs, const Geometry& geometry, float radius);

}  // namespace glare
