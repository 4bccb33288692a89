// SPDX-License-Identifier: BSD-3-Clause
// Meshes and instances of a scene: which files they hold, where they stand, their geometry once per file.
// Octrees within octrees become one level: transforms are multiplied (inner first, spec scene 3).  One tree serves all
// places of a file; a modifier of the instance itself is kept with the place, so that it needs no geometry of its own.
#pragma once
#include <map>
#include <memory>
#include <tuple>
#include <vector>
#include "base/xform.h"
#include "flatten/modifiers.h"
#include "flatten/surfaces.h"
#include "scene/assets.h"

namespace flatten {

class Instances {
public:
    Instances(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files,
              ModifierTables& tables);

    // Materials that the meshes of a scene use and its surfaces need not name: for flatten_modifiers().
    std::vector<int32_t> mesh_materials(const scene::Scene& scene);

    // Reads all files; their modifiers join the tables.  top: of the scene itself.
    void place(const Modifiers& top, Lights& lights);

    // For flatten_geometry(): the reach of all places, the trees, and the records of the places.
    void add_boxes(std::vector<Box>& boxes) const;
    size_t tree_count() const { return trees_.size(); }  // tree 0 not counted
    void write_tree(size_t tree, Draft& out) const;
    void write_records(Draft& out) const;

private:
    // The modifier that replaces those inside, and the coordinates that its functions see.
    struct Replacement {
        uint32_t mod;
        bool passes, clear;
        base::Xform frame;
    };
    // Part of the scene, or of an octree in it.
    struct Level {
        const scene::Scene& scene;
        const Modifiers* modifiers;  // null: replaced
        base::Xform to_world;
        const Replacement* replaced;  // null: not
        uint32_t object;              // of the scene, to which all of this belongs; NONE in the scene itself
    };
    struct Tree {
        const scene::Scene* scene = nullptr;
        const scene::Mesh* mesh = nullptr;
        const Modifiers* modifiers = nullptr;  // null: replaced by the instances'
        std::vector<int32_t> materials;        // .obj: objects of modifiers->scene
        Box box;
        size_t surfaces = 0;  // of a sample
        base::Vec3 centre;
    };
    struct Place {
        uint32_t tree;
        base::Xform to_world, frame;
        uint32_t mod, forced, object;
        bool clear;
    };
    using Materials = std::vector<int32_t>;
    using Key = std::tuple<const void*, const void*, Materials>;

    const std::vector<uint32_t>& placed_in(const scene::Scene& scene);  // its meshes and instances
    void place_all(const Level& level, Lights& lights);
    void place_one(const scene::Object& o, const Level& level, const base::Xform& to_world, const Replacement* replaced,
                   uint32_t owner, Lights& lights);
    void add(uint32_t tree, const base::Xform& to_world, const Replacement* replaced, uint32_t object);
    uint32_t tree_of(const scene::Scene* scene, const scene::Mesh* mesh, const Modifiers* modifiers,
                     Materials materials);
    const Modifiers& modifiers_of(const scene::Scene& scene, const scene::Mesh* mesh = nullptr);
    Materials obj_materials(const scene::Scene& scene, const scene::Mesh& mesh, const scene::Object& o) const;

    const scene::Scene& top_;
    const Options& options_;
    const scene::ReadOptions& files_;
    ModifierTables& tables_;
    scene::Assets assets_;
    std::map<const scene::Scene*, std::unique_ptr<const Modifiers>> modifiers_;
    std::map<const scene::Scene*, std::vector<uint32_t>> placed_in_;
    std::vector<Tree> trees_;  // without tree 0
    std::map<Key, uint32_t> index_;
    std::vector<Place> places_;
};

}  // namespace flatten
