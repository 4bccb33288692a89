// SPDX-License-Identifier: BSD-3-Clause
// All geometry of a scene: its own tree, the trees that its instances share, and the records of these.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "flatten/instances.h"
#include "flatten/pack.h"

namespace flatten {
namespace {
using base::Xform;

// The matrix of a row-vector transform as three rows of four, with t as the fourth column.
void put_matrix(float* q, const Xform& x, Vec3 t) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) q[4 * i + j] = float(x.m[j][i]);
        q[4 * i + 3] = float(t[i]);
    }
}

// Makes a tree of the geometry that `fill` appends.
template <class Fill>
void add_tree(Draft& out, const Fill& fill) {
    FlatScene::Tree t;
    t.first_vertex = out.vertices.size() / 3;
    t.first_triangle = out.triangles.size() / 3;
    t.first_shape = out.shapes.size();
    fill();
    t.vertex_count = out.vertices.size() / 3 - t.first_vertex;
    t.triangle_count = out.triangles.size() / 3 - t.first_triangle;
    t.shape_count = out.shapes.size() - t.first_shape;
    out.trees.push_back(t);
}
}  // namespace

void flatten_geometry(const Modifiers& modifiers, const Instances& instances, const Viewpoint* eye,
                      const base::WorkBudget& work, Draft& out, Lights& lights) {
    Box all;
    out.boxes = surface_boxes(modifiers.scene, all);
    instances.add_boxes(out.boxes);
    out.centre = centre_of(out.boxes, eye);
    out.radius = radius_of(out.boxes);

    add_tree(out, [&] { flatten_surfaces(modifiers.scene, &modifiers, out.centre, work, out, &lights); });
    for (size_t tree = 1; tree <= instances.tree_count(); tree++)
        add_tree(out, [&] { instances.write_tree(tree, out); });
    instances.write_records(out);
}

// An instance counts as some of what it holds.
void Instances::add_boxes(std::vector<Box>& boxes) const {
    constexpr size_t most = 8;
    const size_t step = most * places_.size() / MOST_BOXES + 1;
    for (size_t i = 0; i < places_.size(); i++) {
        const Place& p = places_[i];
        const Box& b = trees_[p.tree - 1].box;
        Box box;
        for (int k = 0; k < 8; k++) {
            const Vec3 inside = {k & 1 ? b.hi.x : b.lo.x, k & 2 ? b.hi.y : b.lo.y, k & 4 ? b.hi.z : b.lo.z};
            const Vec3 corner = base::point(p.to_world, inside);
            if (!within_reach(corner))
                base::fail(top_.place(top_.objects[p.object]), "a coordinate of its instance is beyond 1e18");
            grow(box, corner);
        }
        if (i % step == 0) boxes.insert(boxes.end(), std::min(trees_[p.tree - 1].surfaces, most), box);
    }
}

void Instances::write_tree(size_t tree, Draft& out) const {
    const Tree& t = trees_[tree - 1];
    if (t.mesh) flatten_mesh(*t.mesh, t.modifiers, t.materials, t.centre, out);
    else flatten_surfaces(*t.scene, t.modifiers, t.centre, *files_.work, out, nullptr);
}

void Instances::write_records(Draft& out) const {
    for (const Place& p : places_) {
        const Xform frame = base::inverse(p.frame);
        Instance& instance = out.instances.emplace_back();
        put_matrix(instance.to_tree, base::inverse(p.to_world),
                   base::point(p.to_world, trees_[p.tree - 1].centre) - out.centre);
        instance.tree = p.tree;
        instance.forced = p.forced;
        instance.clear = p.clear;
        if ((p.forced & RAY_TRANSPARENT) != 0) out.shadows_need(SHADOW_STRAIGHT);
        put_matrix(instance.frame, frame, base::point(frame, out.centre));  // the origin of the tables
        instance.mod = p.mod;
        instance.scale = float(std::fabs(frame.scale));
        out.instance_object.push_back(p.object);
    }
}

}  // namespace flatten
