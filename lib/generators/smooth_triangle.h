// SPDX-License-Identifier: BSD-3-Clause
// A triangle of scene text with a normal at each corner: the texture tmesh.cal interpolates them.
#pragma once
#include <array>
#include <string>
#include "base/vec.h"

namespace generators {

void write_smooth_triangle(std::string& out, const std::string& material, const std::string& name,
                           const std::array<base::Vec3, 3>& v, const std::array<base::Vec3, 3>& normal);

}  // namespace generators
