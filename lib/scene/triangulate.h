// SPDX-License-Identifier: BSD-3-Clause
// A simple polygon cut into triangles of its own corners (n - 2 of them), with the same orientation.
#pragma once
#include <array>
#include <cstdint>
#include <vector>
#include "base/vec.h"

namespace scene {

std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<base::Vec3>& corners);

}  // namespace scene
