// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that may mirror the sun, because their material reflects without roughness: the flat ones by their distinct
// normals.
#pragma once
#include <vector>
#include "base/vec.h"
#include "flatten/flat_scene.h"

namespace sampling {

constexpr double same_plane_rad = 2e-4;  // normals closer than this count as one; the sun's radius is 4.6e-3

struct Ball {
    base::Vec3 centre;
    double radius;
};
constexpr size_t MOST_PLANES = 4096, MOST_BALLS = 64;
struct SmoothSurfaces {
    std::vector<base::Vec3> planes;  // unit normals, of either sign, the largest surfaces first, MOST_PLANES at most
    bool curved = false;             // there are spheres, cones, meshes with normals of their own, textures or solids
    std::vector<Ball> balls;         // spheres outside of instances, MOST_BALLS at most
    bool none() const { return planes.empty() && !curved; }
};
// The scene must still have its triangles.
SmoothSurfaces smooth_surfaces(const flatten::FlatScene& scene);

}  // namespace sampling
