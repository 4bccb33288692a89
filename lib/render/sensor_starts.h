// SPDX-License-Identifier: BSD-3-Clause
// Where the paths of sensors begin: on the right side of a surface on which a sensor lies, else where it lies.
#pragma once
#include <vector>
#include "flatten/flat_scene.h"
#include "image/points.h"

namespace render {

// Single precision knows a surface within its rounding only (kernels/bvh/offset_ray.h).  A sensor nearer than that
// moves along the surface's normal as far as a ray that leaves the surface; onto the side to which it looks where it
// lies on the surface, else onto its own.  On a surface are those within rounding, and those that rtrace -I takes past
// it, where a sensor begins 1e-4 along its direction.  Points and starts are in the world.
std::vector<base::Vec3> sensor_starts(const std::vector<image::Point>& sensors, const flatten::FlatScene& scene);

}  // namespace render
