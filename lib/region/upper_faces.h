// SPDX-License-Identifier: BSD-3-Clause
// Which faces of a body have sensors: a desk that is a box has them on its top.
#pragma once
#include <vector>
#include "base/vec.h"

namespace region {

// Polygons by their corners.  Where some lie flat and some stand upright, the upright ones are left out, and those flat
// ones from which upright ones reach to another one above; else all are returned.
std::vector<std::vector<base::Vec3>> upper_faces(const std::vector<std::vector<base::Vec3>>& faces);

// Newell's normal, twice the area long (Tampieri, Newell's method, Graphics Gems III, 1992).
base::Vec3 area_of(const std::vector<base::Vec3>& corners);

}  // namespace region
