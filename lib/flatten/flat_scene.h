// SPDX-License-Identifier: BSD-3-Clause
// The scene as flat tables (kernels/tables.h), ready to upload to any device, and what the host still needs of it.
#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include "base/vec.h"
#include "bvh/build.h"
#include "kernels/dialect/host.h"

namespace kernels {}

namespace flatten {

using namespace kernels;  // the device's records, in all files of this folder
using base::Vec3;

// The trees over a scene's geometry, and the hash of what they were built from.
struct Trees {
    std::string inputs;
    std::shared_ptr<const bvh::Tree> wide;     // eight-wide: for all who trace rays on this machine
    std::shared_ptr<const bvh::Tree> compact;  // for GPUs (Options::compact_tree)
};

struct Box {
    base::Vec3 lo{1e30, 1e30, 1e30}, hi{-1e30, -1e30, -1e30};
};

// From where paths begin: an eye, or points, half of which lie within `size` of `at`.
struct Viewpoint {
    base::Vec3 at;
    std::optional<double> size;  // none: an eye
    Viewpoint(base::Vec3 eye) : at(eye) {}
    Viewpoint(base::Vec3 middle, double points) : at(middle), size(points) {}
};

// Origin of tables, because single precision spoils positions far from it: the middle of most surfaces.  If the eye
// is far from it beside the size of the surfaces around the eye, a place near the eye; if points are so far from it
// that they would be moved by more than RADIANCE's 1e-6, a place among them.  from: null: nowhere.
base::Vec3 centre_of(const std::vector<Box>& boxes, const Viewpoint* from);
// Half the size of most of the scene.
double radius_of(const std::vector<Box>& boxes);

// Tables for the host alone, which searches them for sources and targets.
struct Geometry {
    std::vector<float> vertices;       // 3 each, relative to FlatScene::centre (tree 0)
    std::vector<uint32_t> triangles;   // 3 vertex indices each, from the tree's first
    std::vector<uint32_t> tri_prim;    // primitive of each triangle; bit 31 = transparent class
    std::vector<uint32_t> shape_prim;  // primitive of each shape; bit 31 as above

    // Transparent polygons (world coordinates): candidates for portals.
    struct Pane {
        base::Vec3 corner, edge, normal;
        double area;
        std::vector<base::Vec3> points;
    };
    std::vector<Pane> panes;
};

struct FlatScene : kernels::FlatTables {
    // Geometry of all trees: 0 is the scene, the others are what its instances hold, in coordinates of their own.
    struct Tree {
        size_t first_vertex = 0, vertex_count = 0, first_triangle = 0, triangle_count = 0, first_shape = 0,
               shape_count = 0;
    };
    std::vector<Tree> trees;
    std::shared_ptr<const Geometry> geometry;
    base::Vec3 centre;       // world position of the tables' origin
    std::vector<Box> boxes;  // of surfaces, a sample of them if they are many, in the world
    double radius = 0;       // radius_of() them

    uint32_t window_count = 0;  // of all portals; patches of sun and glossy reflectors follow
    uint32_t shadow_mode = 0;   // SHADOW_* of tables.h
    void shadows_need(uint32_t mode) { shadow_mode = std::max(shadow_mode, mode); }
    bool antimatter = false;
    uint32_t hours_sky_at = 0;  // of many hours: their sky is in `distant`, from this one on
    bool sky_places = false;    // what is far away looks different from place to place
    bool absorbs = false;       // some segment may lie in an absorbing medium
    bool functions = false;     // some material's lobes are .cal functions or tables

    std::vector<uint32_t> prim_object;  // scene object of each primitive; inside instances: see inner_names
    static constexpr uint32_t NO_OBJECT = 0xffffffffu;
    std::vector<uint32_t> instance_object;  // the mesh or instance of the scene to which each instance belongs
    // Scene objects of the active sources that are not virtual, which come first, and of all distant surfaces.
    std::vector<uint32_t> source_object, distant_object;
    // With Options::names: of each record, and of what instances hold, which prim_object counts (NO_OBJECT: no name).
    struct Name {
        std::string name, type, place;  // "wall", "plastic", "office.rad:14"
    };
    std::vector<Name> modifier_names, inner_names;

    Trees built;  // over the geometry, which does not change any more
    // Gives back the memory of what no kernel reads, except names.
    void keep_tables_only();
};

// A scene whose geometry is still growing.
struct Draft : FlatScene, Geometry {
    bool names = false;  // Options::names
    void make_room(size_t more_vertices, size_t more_triangles, size_t more_prims);
    FlatScene finished() &&;
};

// The material of a chain, from record `mod` on; NONE (kernels/tables.h) for none and for mixtures of materials.
uint32_t material_record(const FlatScene& scene, uint32_t mod);

// That of what a ray met (prim and inst of kernels/bvh/intersect.h).
uint32_t material_of(const FlatScene& scene, uint32_t prim, uint32_t inst);

// Does the eye go on through what a ray met?  MT_CLEAR of its material.
bool see_through(const FlatScene& scene, uint32_t prim, uint32_t inst);

}  // namespace flatten
