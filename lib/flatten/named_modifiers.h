// SPDX-License-Identifier: BSD-3-Clause
// Which modifiers a scene's modifiers name in their arguments, and which of all are needed.
#pragma once
#include <cstdint>
#include <vector>
#include "scene/object.h"

namespace flatten {

constexpr int wgmd_names[3] = {0, 4, 8};  // strings of WGMDfunc that name modifiers

// An illum or mirror with another material in its place?
bool has_alternate(const scene::Scene& scene, const scene::Object& o);
// The modifiers that the string arguments of an object name, where the chain does not lead to them.
std::vector<int32_t> named_modifiers(const scene::Scene& scene, uint32_t object);
// By object: do surfaces, or also_used, lead to it?
std::vector<uint8_t> needed_modifiers(const scene::Scene& scene, const std::vector<int32_t>& also_used);

}  // namespace flatten
