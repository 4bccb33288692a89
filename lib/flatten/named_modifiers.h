// SPDX-License-Identifier: BSD-3-Clause
// Modifiers that other modifiers name in their arguments, and the modifiers that are used at all.
#pragma once
#include <cstdint>
#include <vector>
#include "scene/object.h"

namespace flatten {

constexpr int wgmd_names[3] = {0, 4, 8};  // strings of WGMDfunc that name modifiers

// Returns true for an illum or mirror with an alternate material.
bool has_alternate(const scene::Scene& scene, const scene::Object& o);
// Modifiers that the string arguments of an object name, besides its chain.
std::vector<int32_t> named_modifiers(const scene::Scene& scene, uint32_t object);
// By object: used by a surface among objects begin to end - 1, or by also_used.
std::vector<uint8_t> needed_modifiers(const scene::Scene& scene, size_t begin, size_t end,
                                      const std::vector<int32_t>& also_used);

}  // namespace flatten
