// SPDX-License-Identifier: BSD-3-Clause
// Meshes and instances of a scene: which files they hold, where they stand, their geometry once per file.
// Octrees within octrees become one level: transforms are multiplied (inner first, spec scene 3).  One tree serves all
// places of a file; a modifier of the instance itself is kept with the place, so that it needs no geometry of its own.
#pragma once
#include <map>
#include <memory>
#include <tuple>
#include <vector>
#include "scene/assets.h"
#include "trace/flatten.h"

namespace trace {

class Instances {
public:
    explicit Instances(Flattener& top);
    void prepare(Flattener& f);  // before f.flatten_modifiers(): what the meshes of its scene use
    void place();                // after it: reads all files, their modifiers join the tables
    void flatten_geometry();     // trees, then the records of the instances

private:
    // What replaces the modifiers inside, and the coordinates its functions see.
    struct Replacement {
        uint32_t mod;
        bool passes;
        base::Xform frame;
    };
    struct Tree {
        const scene::Scene* scene = nullptr;
        const scene::Mesh* mesh = nullptr;
        Flattener* names = nullptr;      // of the modifiers; null: replaced by the instances'
        std::vector<int32_t> materials;  // .obj: objects of names->scene
        Box box;
        base::Vec3 centre;
    };
    struct Place {
        uint32_t tree;
        base::Xform to_world, frame;
        uint32_t mod, forced, object;
    };
    using Materials = std::vector<int32_t>;
    using Key = std::tuple<const void*, const void*, Materials>;

    void place_all(const scene::Scene& scene, Flattener* names, const base::Xform& to_world,
                   const Replacement* replaced, uint32_t object);
    void add(uint32_t tree, const base::Xform& to_world, const Replacement* replaced, uint32_t object);
    uint32_t tree_of(const scene::Scene* scene, const scene::Mesh* mesh, Flattener* names, Materials materials);
    Flattener& names_of(const scene::Scene& scene, const scene::Mesh* mesh = nullptr);
    Materials obj_materials(const Flattener& f, const scene::Mesh& mesh, const scene::Object& o) const;
    void flatten_mesh(const Tree& tree);
    void write_shapes(size_t first);
    void write_records(size_t first);

    Flattener& top_;
    FlatScene& out_;
    scene::Assets assets_;
    std::map<const scene::Scene*, std::unique_ptr<Flattener>> names_;
    std::vector<Tree> trees_;  // without tree 0
    std::map<Key, uint32_t> index_;
    std::vector<Place> places_;
};

}  // namespace trace
