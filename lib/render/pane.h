// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of a flat surface, found by rays: of a window in a mesh, whose triangles say nothing of it.
#pragma once
#include <optional>
#include <vector>
#include "flatten/host_tracer.h"

namespace render {

// Four corners about a point that a ray met, with level and rising edges, as far as the surface goes on from there in
// these four directions: in one plane, with the same material.  step: the narrowest gap that ends it.
std::vector<base::Vec3> rectangle_around(const flatten::FlatScene& tables, const flatten::HostTracer& tracer,
                                         const flatten::HostTracer::Found& found, double step);

}  // namespace render
