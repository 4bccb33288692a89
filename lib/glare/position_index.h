// SPDX-License-Identifier: BSD-3-Clause
// Position index (view/position_index.h) of a direction in a picture, with evalglare's roundings where the geometry has
// them.
#pragma once
#include "glare/geometry.h"
#include "view/position_index.h"

namespace glare {
using view::EyeAngles;
using view::PositionModel;

// With evalglare's slips: its literal for pi makes a right angle a little less than 90 degrees, so that what is level
// but for rounding counts as above.
EyeAngles eye_angles(const Geometry& geometry, Vec3 d, bool picture_up = false);
// With evalglare's slips: the upper limit, 16, where rounding makes the angle not a number.
double position_index(const Geometry& geometry, Vec3 d, PositionModel model);

}  // namespace glare
