// SPDX-License-Identifier: BSD-3-Clause
// The geometry of a FlatScene as the BVH builder wants it.
#pragma once
#include "trace/bvh_build.h"
#include "trace/flat_scene.h"

namespace trace {

inline BuildInput build_input(const FlatScene& s) {
    BuildInput in;
    in.vertices = s.vertices.data();
    in.vertex_count = s.vertices.size() / 3;
    in.triangles = s.triangles.data();
    in.tri_prim = s.tri_prim.data();
    in.triangle_count = s.triangles.size() / 3;
    in.shapes = s.shapes.data();
    in.shape_prim = s.shape_prim.data();
    in.shape_count = s.shapes.size() / 16;
    in.polygon_uv = s.polygon_uv.data();
    return in;
}

}  // namespace trace
