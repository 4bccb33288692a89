// SPDX-License-Identifier: BSD-3-Clause
// Regions in space as sensors: points at a spacing on their flat faces, which are polygon3d, disc3d, and the polygons
// and rings of the scene that "surface" and "modifier" name.  No view takes part.
#pragma once
#include <vector>
#include "image/points.h"
#include "region/region.h"

namespace region {

// Points of region k, `height` before the faces, directed along their normals: in rows along the longest edge, centred,
// a face at a time; faces of one plane are one.  Normals are those of the corners' order, but horizontal faces look up;
// with a height below 0 points lie behind the faces and look that way.  Of a surface or modifier that is a body, as a
// desk made as a box, the upper faces alone count, and a warning says so.  A point is in polygon3d, disc3d or a surface
// if it lies before or behind it. Throws Error (place: the region's or the shape's) for shapes that need a view, and
// for a region without points.
std::vector<image::Point> sensors_of(const Regions& regions, size_t k, double spacing, double height,
                                     const SceneView* scene);

// A ring as a polygon of many sides; inner 0: a disc.
std::vector<Vec3> ring_corners(Vec3 centre, Vec3 normal, double inner, double outer);

}  // namespace region
