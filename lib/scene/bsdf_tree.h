// SPDX-License-Identifier: BSD-3-Clause
// Tensor trees of BSDF files, as genBSDF writes them: nested braces around 2^dims branches or a grid of values.
#pragma once
#include <string>
#include "scene/bsdf_xml.h"

namespace scene {

// Throws Error (place) for text that is not a tree of so many dimensions.
BsdfTree read_bsdf_tree(const char* text, int dims, const std::string& place);

}  // namespace scene
