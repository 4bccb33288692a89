// SPDX-License-Identifier: BSD-3-Clause
// Position index (view/position_index.h) of a direction in a picture.
#pragma once
#include "glare/geometry.h"

namespace glare {

inline EyeAngles eye_angles(const Geometry& g, Vec3 d) { return g.rays().eye_angles(d, false); }
inline double position_index(const Geometry& g, Vec3 d, PositionModel model) {
    return g.rays().position_index(d, model);
}

}  // namespace glare
