// SPDX-License-Identifier: BSD-3-Clause
// From meshes and instances to trees and places.
#include "flatten/instances.h"

#include "base/error.h"
#include "base/printable.h"
#include "scene/materials.h"

namespace flatten {
namespace {
using base::Xform;

constexpr uint64_t PLACE = 10;  // steps of base::WorkBudget: a place takes 128 bytes and a part of the tree above it

bool is_obj(const scene::Mesh& mesh) { return !mesh.material_names.empty(); }

void warn_of_bare_faces(const scene::Mesh& mesh) {
    for (const scene::Mesh::Triangle& t : mesh.triangles)
        if (t.material < 0) return base::warn(mesh.path, "faces without a material (usemtl) are left out");
}
}  // namespace

Instances::Instances(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files,
                     ModifierTables& tables)
    : top_(scene), options_(options), files_(files), tables_(tables), assets_(files) {}

Instances::Materials Instances::obj_materials(const scene::Scene& scene, const scene::Mesh& mesh,
                                              const scene::Object& o) const {
    Materials m;
    const auto user = int32_t(&o - scene.objects.data());
    for (size_t k = 0; k < mesh.material_names.size(); ++k) {
        const std::string& name = mesh.material_names[k];
        std::optional<int32_t> found = scene.find_modifier(name, user);
        if (!found) found = scene.find_modifier(name.substr(0, name.find_first_of(" \t")), user);  // as obj2mesh
        if (!found)
            base::fail(mesh.path + ":" + std::to_string(mesh.material_lines[k]),
                       "modifier \"" + base::excerpt(name) + "\" is not defined");
        m.push_back(*found);
    }
    return m;
}

std::vector<int32_t> Instances::mesh_materials(const scene::Scene& scene) {
    std::vector<int32_t> used;
    for (const scene::Object& o : scene.objects) {
        if (o.type != Type::mesh || o.modifier >= 0) continue;
        const scene::Mesh& mesh = assets_.mesh(scene, o);
        if (!is_obj(mesh)) continue;
        const Materials m = obj_materials(scene, mesh, o);
        used.insert(used.end(), m.begin(), m.end());
    }
    return used;
}

const Modifiers& Instances::modifiers_of(const scene::Scene& scene, const scene::Mesh* mesh) {
    std::unique_ptr<const Modifiers>& known = modifiers_[&scene];
    if (known) return *known;
    std::vector<int32_t> also_used = mesh_materials(scene);
    if (mesh) {
        std::vector<bool> used(scene.objects.size());
        for (const scene::Mesh::Triangle& t : mesh->triangles)
            if (t.material >= 0) used[size_t(t.material)] = true;
        for (size_t i = 0; i < used.size(); i++)
            if (used[i]) also_used.push_back(int32_t(i));
    }
    auto fresh = std::make_unique<Modifiers>(scene);
    flatten_modifiers(*fresh, {0, scene.objects.size()}, also_used, options_, files_, tables_);
    return *(known = std::move(fresh));
}

uint32_t Instances::tree_of(const scene::Scene* scene, const scene::Mesh* mesh, const Modifiers* modifiers,
                            Materials materials) {
    const void* geometry = mesh ? static_cast<const void*>(mesh) : scene;
    const auto [found, fresh] = index_.emplace(Key(geometry, modifiers, materials), NONE);
    if (!fresh) return found->second;
    Tree t;
    t.scene = scene;
    t.mesh = mesh;
    t.modifiers = modifiers;
    t.materials = std::move(materials);
    const std::vector<Box> boxes = mesh ? surface_boxes(*mesh, t.box) : surface_boxes(*scene, t.box);
    if (boxes.empty()) return NONE;  // only instances of others
    t.centre = centre_of(boxes, nullptr);
    t.surfaces = boxes.size();
    trees_.push_back(std::move(t));
    found->second = uint32_t(trees_.size());
    return found->second;
}

void Instances::add(uint32_t tree, const Xform& to_world, const Replacement* replaced, uint32_t object) {
    if (tree == NONE) return;
    Place p{tree, to_world, to_world, NONE, 0, object, false};
    if (replaced) {
        p.frame = replaced->frame;
        p.mod = replaced->mod;
        p.forced = replaced->passes ? RAY_TRANSPARENT : RAY_OPAQUE;
        p.clear = replaced->clear;
    }
    places_.push_back(p);
}

void Instances::place(const Modifiers& top, Lights& lights) { place_all({top_, &top, Xform(), nullptr, NONE}, lights); }

// Cached once per scene, so that the places of an octree of a million polygons do not search it again.
const std::vector<uint32_t>& Instances::placed_in(const scene::Scene& scene) {
    const auto [found, fresh] = placed_in_.emplace(&scene, std::vector<uint32_t>());
    if (fresh)
        for (const scene::Object& o : scene.objects)
            if (o.type == Type::mesh || o.type == Type::instance)
                found->second.push_back(uint32_t(&o - scene.objects.data()));
    return found->second;
}

void Instances::place_all(const Level& level, Lights& lights) {
    const scene::Scene& scene = level.scene;
    for (const uint32_t index : placed_in(scene)) {
        const scene::Object& o = scene.objects[index];
        const uint32_t owner = level.object == NONE ? index : level.object;
        if (!files_.work->spend(PLACE)) files_.work->fail(top_.place(top_.objects[owner]));
        const Xform x = base::multiply(scene::Assets::transform(scene, o), level.to_world);
        if (level.replaced || o.modifier < 0) {
            place_one(o, level, x, level.replaced, owner, lights);
            continue;
        }
        if (!level.modifiers->is_met[o.modifier]) continue;  // rays pass all of it
        const Replacement own{level.modifiers->record[o.modifier], level.modifiers->passes[o.modifier] != 0,
                              level.modifiers->is_clear(o.modifier), level.to_world};
        const uint32_t m = level.modifiers->material[o.modifier];
        if (level.object == NONE && m != NONE && scene::is_emissive(scene.objects[m].type))
            lights.emitters.push_back({owner, NONE});  // refused if it is an active source
        place_one(o, level, x, &own, owner, lights);
    }
}

void Instances::place_one(const scene::Object& o, const Level& level, const Xform& x, const Replacement* replaced,
                          uint32_t owner, Lights& lights) {
    if (o.type == Type::instance) {
        const scene::Scene& inner = assets_.octree(level.scene, o);
        const Modifiers* modifiers = replaced ? nullptr : &modifiers_of(inner);
        add(tree_of(&inner, nullptr, modifiers, {}), x, replaced, owner);
        place_all({inner, modifiers, x, replaced, owner}, lights);
        return;
    }
    const scene::Mesh& mesh = assets_.mesh(level.scene, o);
    if (!replaced) warn_of_bare_faces(mesh);
    if (replaced) add(tree_of(nullptr, &mesh, nullptr, {}), x, replaced, owner);
    else if (is_obj(mesh))
        add(tree_of(nullptr, &mesh, level.modifiers, obj_materials(level.scene, mesh, o)), x, replaced, owner);
    else if (!mesh.materials.objects.empty())
        add(tree_of(nullptr, &mesh, &modifiers_of(mesh.materials, &mesh), {}), x, replaced, owner);
}

}  // namespace flatten
