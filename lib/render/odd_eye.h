// SPDX-License-Identifier: BSD-3-Clause
// An eye where none can be meant: under the ground, in a solid, in a room or beside a scene of other units.
#pragma once
#include <string>
#include "flatten/flat_scene.h"

namespace render {

// Asked of the surfaces along the axes of the world, and downward and upward; empty where nothing is odd.
std::string odd_about_eye(const flatten::FlatScene& tables, base::Vec3 eye);

}  // namespace render
