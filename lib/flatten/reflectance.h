// SPDX-License-Identifier: BSD-3-Clause
// Materials that give back more light than they get: mostly a percentage, or 0 to 255, where the language wants 0 to 1.
#pragma once
#include "scene/object.h"

namespace flatten {

// Warns of a reflectance or transmittance above 1 or below 0 and of a roughness below 0.  Throws Error where the
// constant diffuse, specular and transmitted parts of a band sum to 2 or more, unless `any` lets it pass.
// patterned: a pattern above the material multiplies its colours, which are not held against 1 then.
void check_reflectance(const scene::Scene& scene, const scene::Object& material, bool patterned, bool any);

}  // namespace flatten
