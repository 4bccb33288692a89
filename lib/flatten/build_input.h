// SPDX-License-Identifier: BSD-3-Clause
// The geometry of a FlatScene as the BVH builder needs it.
#pragma once
#include <vector>
#include "bvh/build.h"
#include "flatten/flat_scene.h"

namespace flatten {

inline std::vector<bvh::Input> build_inputs(const FlatScene& s) {
    std::vector<bvh::Input> trees;
    for (const FlatScene::Tree& t : s.trees) {
        bvh::Input in;
        in.vertices = s.vertices.data() + 3 * t.first_vertex;
        in.vertex_count = t.vertex_count;
        in.triangles = s.triangles.data() + 3 * t.first_triangle;
        in.tri_prim = s.tri_prim.data() + t.first_triangle;
        in.triangle_count = t.triangle_count;
        in.shapes = s.shapes.data();
        in.shape_prim = s.shape_prim.data();
        in.first_shape = t.first_shape;
        in.shape_count = t.shape_count;
        in.polygon_uv = s.polygon_uv.data();
        trees.push_back(in);
    }
    return trees;
}

}  // namespace flatten
