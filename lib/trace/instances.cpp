// SPDX-License-Identifier: BSD-3-Clause
// Instances: from primitives to trees and places.
#include "trace/instances.h"

#include <cmath>

#include "base/error.h"
#include "scene/materials.h"

namespace trace {
namespace {
using namespace kernels;
using base::Vec3;
using base::Xform;
using scene::Type;

constexpr uint64_t PLACE = 10;  // steps of base::Work: a place takes 128 bytes and a share of the tree above it

bool is_obj(const scene::Mesh& mesh) { return !mesh.material_names.empty(); }

// The matrix of a row-vector transform, shifted: local = p m - shift, as three rows of four.
void put_matrix(float* q, const Xform& x, Vec3 from, Vec3 shift) {
    const Vec3 t = base::point(x, from) - shift;  // where the origin of the tables comes to lie
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) q[4 * i + j] = float(x.m[j][i]);
        q[4 * i + 3] = float(t[i]);
    }
}
}  // namespace

Instances::Instances(Flattener& top) : top_(top), out_(top.out), assets_(top.files) {}

Instances::Materials Instances::obj_materials(const Flattener& f, const scene::Mesh& mesh,
                                              const scene::Object& o) const {
    Materials m;
    for (const std::string& name : mesh.material_names)
        m.push_back(f.scene.lookup_modifier(name, int32_t(&o - f.scene.objects.data())));
    return m;
}

void Instances::prepare(Flattener& f) {
    for (const scene::Object& o : f.scene.objects) {
        if (o.type != Type::mesh || o.modifier >= 0) continue;
        const scene::Mesh& mesh = assets_.mesh(f.scene, o);
        if (!is_obj(mesh)) continue;
        const Materials m = obj_materials(f, mesh, o);
        f.also_used.insert(f.also_used.end(), m.begin(), m.end());
    }
}

Flattener& Instances::names_of(const scene::Scene& scene, const scene::Mesh* mesh) {
    std::unique_ptr<Flattener>& names = names_[&scene];
    if (names) return *names;
    names = std::make_unique<Flattener>(scene, top_.options, top_.files, out_);
    prepare(*names);
    if (mesh) {
        std::vector<bool> used(scene.objects.size());
        for (const scene::Mesh::Triangle& t : mesh->triangles)
            if (t.material >= 0) used[size_t(t.material)] = true;
        for (size_t i = 0; i < used.size(); i++)
            if (used[i]) names->also_used.push_back(int32_t(i));
    }
    names->exchange_tables(top_);
    names->flatten_modifiers();
    names->exchange_tables(top_);
    top_.aimed = top_.aimed || names->aimed;
    return *names;
}

uint32_t Instances::tree_of(const scene::Scene* scene, const scene::Mesh* mesh, Flattener* names, Materials materials) {
    const void* geometry = mesh ? static_cast<const void*>(mesh) : scene;
    const auto [found, fresh] = index_.emplace(Key(geometry, names, materials), NONE);
    if (!fresh) return found->second;
    Tree t;
    t.scene = scene;
    t.mesh = mesh;
    t.names = names;
    t.materials = std::move(materials);
    if (mesh) {
        for (const Vec3& p : mesh->positions) grow(t.box, p);
    } else {
        t.box = surface_bounds(*scene);
    }
    if (t.box.lo.x > t.box.hi.x) return NONE;  // only instances of others
    t.centre = centre_of(t.box);
    trees_.push_back(std::move(t));
    found->second = uint32_t(trees_.size());
    return found->second;
}

void Instances::add(uint32_t tree, const Xform& to_world, const Replacement* replaced, uint32_t object) {
    if (tree == NONE) return;
    Place p{tree, to_world, to_world, NONE, 0, object};
    if (replaced) {
        p.frame = replaced->frame;
        p.mod = replaced->mod;
        p.forced = replaced->passes ? RAY_TRANSPARENT : RAY_OPAQUE;
        if (replaced->passes) out_.shadow_mode = SHADOW_STRAIGHT;
    }
    places_.push_back(p);
}

void Instances::place() { place_all(top_.scene, &top_, Xform(), nullptr, NONE); }

// names: null where the modifiers are replaced.  object: the primitive of the top scene all this belongs to, NONE
// there.
void Instances::place_all(const scene::Scene& scene, Flattener* names, const Xform& to_world,
                          const Replacement* replaced, uint32_t object) {
    if (object != NONE && !top_.files.work->spend(1 + scene.objects.size() / 64))
        top_.files.work->fail(top_.scene.place(top_.scene.objects[object]));
    for (const scene::Object& o : scene.objects) {
        if (o.type != Type::mesh && o.type != Type::instance) continue;
        const uint32_t owner = object == NONE ? uint32_t(&o - scene.objects.data()) : object;
        if (!top_.files.work->spend(PLACE)) top_.files.work->fail(top_.scene.place(top_.scene.objects[owner]));
        const Xform x = base::multiply(scene::Assets::transform(scene, o), to_world);
        Replacement own{NONE, false, to_world};
        const Replacement* now = replaced;
        if (!now && o.modifier >= 0) {
            if (!names->has_material[o.modifier]) continue;  // all of it lets rays pass
            own.mod = names->mod_of[o.modifier];
            own.passes = names->passes[o.modifier];
            now = &own;
            if (names == &top_) {
                const uint32_t m = top_.material_of[o.modifier];
                if (m != NONE && scene::shines(scene.objects[m].type))
                    top_.emitters.push_back({owner, NONE});  // refused unless it is no active source
            }
        }
        if (o.type == Type::mesh) {
            const scene::Mesh& mesh = assets_.mesh(scene, o);
            if (now) add(tree_of(nullptr, &mesh, nullptr, {}), x, now, owner);
            else if (is_obj(mesh)) add(tree_of(nullptr, &mesh, names, obj_materials(*names, mesh, o)), x, now, owner);
            else if (!mesh.materials.objects.empty())
                add(tree_of(nullptr, &mesh, &names_of(mesh.materials, &mesh), {}), x, now, owner);
        } else {
            const scene::Scene& inner = assets_.octree(scene, o);
            Flattener* inner_names = now ? nullptr : &names_of(inner);
            add(tree_of(&inner, nullptr, inner_names, {}), x, now, owner);
            place_all(inner, inner_names, x, now, owner);
        }
    }
}

void Instances::flatten_geometry() {
    Box box = surface_bounds(top_.scene);
    for (const Place& p : places_) {
        const Box& b = trees_[p.tree - 1].box;
        for (int k = 0; k < 8; k++) {
            const Vec3 inside = {k & 1 ? b.hi.x : b.lo.x, k & 2 ? b.hi.y : b.lo.y, k & 4 ? b.hi.z : b.lo.z};
            const Vec3 corner = base::point(p.to_world, inside);
            const scene::Object& shown = top_.scene.objects[p.object];
            if (!within_reach(corner))
                base::fail(top_.scene.place(shown), "a coordinate of its instance is beyond 1e18");
            grow(box, corner);
        }
    }
    out_.centre = centre_of(box);
    const auto tree = [&](auto&& fill) {
        FlatScene::Tree t;
        t.first_vertex = out_.vertices.size() / 3;
        t.first_triangle = out_.triangles.size() / 3;
        t.first_shape = out_.shapes.size() / SHAPE_FLOATS;
        fill();
        t.vertex_count = out_.vertices.size() / 3 - t.first_vertex;
        t.triangle_count = out_.triangles.size() / 3 - t.first_triangle;
        t.shape_count = out_.shapes.size() / SHAPE_FLOATS - t.first_shape;
        out_.trees.push_back(t);
    };
    size_t first = 0;
    tree([&] {
        flatten_surfaces(top_, top_.scene, out_.centre, Owner::scene);
        first = out_.shapes.size() / SHAPE_FLOATS;
        write_shapes(first);
    });
    for (const Tree& t : trees_)
        tree([&] {
            if (t.mesh) flatten_mesh(t);
            else
                flatten_surfaces(t.names ? *t.names : top_, *t.scene, t.centre,
                                 t.names ? Owner::instance : Owner::replaced);
        });
    write_records(first);
}

// The instances as shapes of tree 0.
void Instances::write_shapes(size_t first) {
    out_.shapes.resize(SHAPE_FLOATS * (first + places_.size()), 0.0f);
    out_.shape_prim.resize(first + places_.size(), 0);
    for (size_t i = 0; i < places_.size(); i++) {
        const Place& p = places_[i];
        float* q = &out_.shapes[SHAPE_FLOATS * (first + i)];
        q[0] = from_bits(SHAPE_INSTANCE);
        put_matrix(q + 1, base::inverse(p.to_world), out_.centre, trees_[p.tree - 1].centre);
        q[13] = from_bits(p.tree);
        q[15] = from_bits(p.forced);
    }
}

void Instances::write_records(size_t first) {
    out_.instances_at = uint32_t(out_.shapes.size() / SHAPE_FLOATS);
    out_.shapes.resize(SHAPE_FLOATS * (out_.instances_at + places_.size()), 0.0f);
    out_.shape_prim.resize(out_.instances_at + places_.size(), 0);
    for (size_t i = 0; i < places_.size(); i++) {
        const Place& p = places_[i];
        const Box& b = trees_[p.tree - 1].box;
        const uint32_t record = out_.instances_at + uint32_t(i);
        out_.shapes[SHAPE_FLOATS * (first + i) + 14] = from_bits(record);
        float* q = &out_.shapes[SHAPE_FLOATS * record];
        const Xform frame = base::inverse(p.frame);
        q[INST_SHAPE] = from_bits(uint32_t(first + i));
        put_matrix(q + INST_FRAME, frame, out_.centre, {});
        q[INST_MOD] = from_bits(p.mod);
        q[INST_SCALE] = float(std::fabs(frame.scale));
        q[INST_REACH] = float(length(b.hi - b.lo) * 0.5 * std::fabs(p.to_world.scale));
        out_.instance_object.push_back(p.object);
    }
}

}  // namespace trace
