// SPDX-License-Identifier: BSD-3-Clause
// Finds materials that reflect and transmit more light than they receive: mostly a percentage, or 0 to 255, in place of
// 0 to 1.
#pragma once
#include "scene/object.h"

namespace flatten {

// Warns of a reflectance or transmittance above 1 or below 0 and of a roughness below 0.  Throws Error if the constant
// diffuse, specular and transmitted parts of a band sum to 2 or more, unless `any`.  patterned: a pattern above the
// material multiplies its colours, which may then exceed 1.
void check_reflectance(const scene::Scene& scene, const scene::Object& material, bool patterned, bool any);

}  // namespace flatten
