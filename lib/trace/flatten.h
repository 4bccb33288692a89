// SPDX-License-Identifier: BSD-3-Clause
// The parts of flatten(): modifiers, geometry, instances, sources.  Each fills its tables of one FlatScene.
#pragma once
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include "cal/compile.h"
#include "cal/pattern.h"
#include "kernels/host.h"
#include "trace/flat_scene.h"

namespace trace {

struct Flattener {
    const scene::Scene& scene;
    const RenderOptions& options;
    const scene::ReadOptions& files;
    FlatScene& out;
    cal::Library library;
    cal::Code code;  // becomes the start of out.u and out.f

    std::vector<int32_t> also_used;  // modifiers that no surface names: materials of .obj meshes

    // By object index (modifiers):
    std::vector<uint32_t> mod_of;       // mod record, NONE if unused
    std::vector<uint8_t> has_material;  // the chain from here ends in one (or in a mixture)
    std::vector<uint8_t> passes;        // a shadow ray may pass
    std::vector<uint32_t>
        material_of;             // object index of the chain's material (NONE: mixture or none), aliases resolved
    std::vector<uint32_t> mods;  // MOD_WORDS each
    std::vector<float> args;     // real arguments, appended to f

    // Exchanges what the scenes of one flattening fill together: an instance's octree has its own Flattener.
    void exchange_tables(Flattener& other) {
        std::swap(code, other.code);
        std::swap(mods, other.mods);
        std::swap(args, other.args);
    }

    struct MistRef {
        uint32_t mod, object;
    };
    std::vector<MistRef> mists;                  // mists that may name sources, filled in when these are known
    std::map<std::string, uint32_t> bsdf_files;  // tables by path

    bool aimed = false;  // shadow rays may bend or be relayed: SHADOW_AIMED

    // Emitting surfaces, collected by geometry for sources.
    struct Emitter {
        uint32_t object, prim;
    };
    std::vector<Emitter> emitters;
    // Flat mirrors and prisms, relative to the centre; exits: 0 mirror, 1 prism1, 2 prism2.
    // kernels/tables.h
    struct Gate {
        base::Vec3 centre, normal, u, v;
        bool both_sides;
    };
    struct Relay {
        uint32_t prim;
        base::Vec3 normal, centre;
        int exits;  // of a prism; 0: a mirror
        uint32_t modifier, object;
        double reflectance;
        Gate gate;
    };
    std::vector<Relay> relays;

    Flattener(const scene::Scene& s, const RenderOptions& o, const scene::ReadOptions& f, FlatScene& t)
        : scene(s), options(o), files(f), out(t), library(f) {}

    void flatten_modifiers();
    // The material of a chain, from record `mod` on; NONE for none and for mixtures of materials.
    uint32_t material_record(uint32_t mod) const;
    // Tables of a BSDF file, found along RAYPATH: index for MOD_EXTRA (flatten_bsdf.cpp).
    uint32_t bsdf_file(const std::string& name, const std::string& place);
    void flatten_sources();
    uint32_t distant_seen(uint32_t mod) const;
    void weigh_patterns(std::vector<float>& records) const;  // the power of sources whose pattern changes it
    // The sources that mists name, to scatter; records as in flatten_sources, the real ones first, each with its
    // object. Source i is of that name; of several the latest is meant.
    void link_mists(const std::vector<float>& records, const std::vector<uint32_t>& source_objects);
    bool source_is_called(const std::vector<float>& records, const std::vector<uint32_t>& source_objects, uint32_t i,
                          std::string_view name) const;
    bool source_is_later(const std::vector<float>& records, const std::vector<uint32_t>& source_objects, uint32_t i,
                         uint32_t j) const;
    uint32_t relay_object(uint32_t prim) const;
    // Copies of the sources mirrored in the relays, up to -dr levels (virtual_sources.cpp); arguments as in
    // flatten_sources.
    void add_virtual_sources(std::vector<float>& records, std::vector<float>& fans,
                             std::vector<std::pair<size_t, size_t>>& fan_patches);
};

// The surfaces of one scene, its meshes and instances left out, into the geometry tables (flatten_geometry.cpp).
enum class Owner {
    scene,     // may shine, reflect suns, be a window
    instance,  // inside an instance, with the modifiers of f
    replaced,  // inside one with a modifier of its own, which replaces all
};
void flatten_surfaces(Flattener& f, const scene::Scene& scene, base::Vec3 centre, Owner owner);

struct Box {
    base::Vec3 lo{1e30, 1e30, 1e30}, hi{-1e30, -1e30, -1e30};
};
void grow(Box& box, base::Vec3 p);
// Coordinates are floats in the end, and are squared: beyond this nothing can be said of a surface.
constexpr double farthest = 1e18;
inline bool within_reach(base::Vec3 p) {
    return std::fabs(p.x) < farthest && std::fabs(p.y) < farthest && std::fabs(p.z) < farthest;  // false for NaN
}
Box surface_bounds(const scene::Scene& scene);
// Origin of tables: single precision would spoil positions far from it.
base::Vec3 centre_of(const Box& box);

inline uint32_t bits(float f) {
    uint32_t u;
    std::memcpy(&u, &f, 4);
    return u;
}
inline float from_bits(uint32_t u) {
    float f;
    std::memcpy(&f, &u, 4);
    return f;
}

}  // namespace trace
