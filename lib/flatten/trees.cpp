// SPDX-License-Identifier: BSD-3-Clause
// See trees.h.
#include "flatten/trees.h"

#include "base/hash.h"
#include "flatten/pack.h"

namespace flatten {

std::vector<bvh::Input> build_inputs(const FlatScene& s) {
    std::vector<bvh::Input> trees;
    for (const FlatScene::Tree& t : s.trees) {
        bvh::Input in;
        in.vertices = s.geometry->vertices.data() + 3 * t.first_vertex;
        in.vertex_count = t.vertex_count;
        in.triangles = s.geometry->triangles.data() + 3 * t.first_triangle;
        in.tri_prim = s.geometry->tri_prim.data() + t.first_triangle;
        in.triangle_count = t.triangle_count;
        in.shapes = s.shapes.data();
        in.shape_prim = s.geometry->shape_prim.data();
        in.first_shape = t.first_shape;
        in.shape_count = t.shape_count;
        in.polygon_uv = s.polygon_uv.data();
        trees.push_back(in);
    }
    if (trees.empty()) return trees;
    trees[0].instances = s.instances.data();
    trees[0].instance_count = s.instances.size();
    return trees;
}

namespace {
std::string hash_of_inputs(const FlatScene& s) {
    base::Hash hash;
    for (const FlatScene::Tree& t : s.trees)
        hash.add({t.first_vertex, t.vertex_count, t.first_triangle, t.triangle_count, t.first_shape, t.shape_count});
    hash.add_all(s.geometry->vertices), hash.add_all(s.geometry->triangles), hash.add_all(s.geometry->tri_prim);
    hash.add_all(s.shapes), hash.add_all(s.geometry->shape_prim), hash.add_all(s.polygon_uv);
    for (const Instance& instance : s.instances) {
        for (const float value : instance.to_tree) hash.add({bits(value)});
        hash.add({instance.tree, instance.forced});
    }
    return hash.text();
}

}  // namespace

Trees build_trees(const FlatScene& s, const Options& options, const base::WorkBudget& work) {
    Trees out;
    out.inputs = hash_of_inputs(s);
    if (options.known.inputs == out.inputs) out = options.known;
    const std::vector<bvh::Input> in = build_inputs(s);
    const bvh::Tell tell = [&](double share) {
        work.check();
        if (options.tell_tree) options.tell_tree(share);
    };
    if (!out.wide) out.wide = std::make_shared<const bvh::Tree>(bvh::build8(in.data(), in.size(), tell));
    if (options.compact_tree && !out.compact)
        out.compact = std::make_shared<const bvh::Tree>(bvh::build_compact(in.data(), in.size(), tell));
    return out;
}

}  // namespace flatten
