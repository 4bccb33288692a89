// SPDX-License-Identifier: BSD-3-Clause
// In words: the objects that rays of a view end at.
#pragma once
#include <string>
#include <vector>
#include "region/region.h"

namespace visibility {

struct WeightedRay {
    base::Vec3 origin, dir;
    double tmax, weight;  // tmax 0: no limit
};
// "sky (skyglow) through pane (glass), 80 %; frame (alu), 20 %": objects with their modifiers, by their share of the
// weight; modifiers alone where no object has a large one.
std::string seen_along(const region::SceneView& scene, const std::vector<WeightedRay>& rays);

}  // namespace visibility
