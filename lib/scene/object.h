// SPDX-License-Identifier: BSD-3-Clause
// A RADIANCE scene as the list of primitives it is made of: order kept, transforms applied, commands expanded.
// Arguments live in pools, so that a million polygons cost little more than their numbers.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>
#include "base/find_file.h"
#include "base/span.h"
#include "base/xform.h"
#include "kernels/material/materials.h"

namespace scene {

// Shared by scenes and function files, so it lives in base (cal must not know scenes).
using base::find_file;
using base::inverse;
using base::parse_xform;
using base::ReadOptions;
using base::Skies;
using base::Xform;

// Every primitive type of the language; names as in the files (type_name, type_from_name).
#define TYPE_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) type,
// clang-format off
enum class Type : uint8_t {
    // surfaces
    source, sphere, bubble, polygon, cone, cup, cylinder, tube, ring, mesh, instance,
    MATERIALS(TYPE_OF_ROW, TYPE_OF_ROW)
    // textures, patterns, mixtures
    texfunc, texdata, colorfunc, brightfunc, colordata, brightdata, colorpict, colortext, brighttext,
    spectrum, specfile, specdata, specfunc, specpict, mixfunc, mixdata, mixpict, mixtext,
    // the other form
    alias,
    count
};
// clang-format on
#undef TYPE_OF_ROW
const char* type_name(Type t);
bool type_from_name(std::string_view name, Type& t);
inline bool is_surface(Type t) { return t <= Type::instance; }
inline bool is_mixture(Type t) { return t >= Type::mixfunc && t <= Type::mixtext; }
inline bool is_material(Type t) { return t > Type::instance && t < Type::texfunc; }

template <class T>
using Span = base::Span<T>;

constexpr int32_t VOID = -1;

struct Object {
    Type type;
    uint16_t string_count = 0;
    int32_t modifier = VOID;      // index of an object in the same list; VOID.  Aliases stay objects: see resolve()
    uint32_t name = 0;            // into name_pool
    uint32_t file = 0, line = 0;  // into files; line of the primitive's first word
    uint32_t string_at = 0;
    uint32_t real_count = 0;
    int32_t alias_of = VOID;  // aliases only: the object their reference meant when they were read
    uint64_t real_at = 0;
};
static_assert(sizeof(Object) == 40, "a million polygons should stay cheap");

struct Scene {
    std::vector<Object> objects;
    std::vector<std::string> files, string_pool;
    std::vector<char> name_pool;       // each name ends with a NUL
    std::vector<std::string> history;  // what the headers of its octrees say
    std::vector<double> real_pool;
    std::unordered_map<std::string, std::vector<int32_t>>
        definitions;  // objects that are not surfaces, by name, in order
    Span<std::string> strings(const Object& o) const { return {string_pool.data() + o.string_at, o.string_count}; }
    Span<double> reals(const Object& o) const { return {real_pool.data() + o.real_at, o.real_count}; }
    std::string name(const Object& o) const { return &name_pool[o.name]; }
    std::string place(const Object& o) const;  // "office.rad:14"
    bool may_have_light() const;               // some material emits, or an octree or mesh could have one that does
    // As lookup_modifier(); nothing if undefined.
    std::optional<int32_t> find_modifier(const std::string& name, int32_t user) const;
    // The modifier object meant by a string argument of `user` (the last definition before it); VOID for "void";
    // throws Error (place of user) if undefined.
    int32_t lookup_modifier(const std::string& name, int32_t user) const;
    // Follows aliases: type and arguments come from the result, the modifier chain goes on at `modifier`.  Of a chain
    // of aliases the first one met acts; an alias that inherits holds its target's modifier already.
    struct Resolved {
        int32_t object;
        int32_t modifier;
    };
    Resolved resolve(int32_t modifier_index) const;
    // Walks resolve() from a modifier to the first material; VOID if there is none (mixtures are not entered).
    Resolved material(int32_t modifier_index) const;
};

// Limits of a reader; a scene beyond them is an input error, not a crash.
struct Limits {
    uint64_t bytes = 0;          // of all tables together; 0 = four fifths of this machine's memory
    int depth = 64;              // commands and files inside files
    uint64_t copies = 10000000;  // of one xform command's arrays; a generator writes a million pieces or this
};

// Reads scene files in order ("-" = stdin, "!..." = a command as in a scene file, several lines = scene text); xform,
// genbox (and the other generators) run inside, never as programs. .oct and .rtm/.obj are recognised by
// content/ending.  Throws Error with file:line. Surfaces come out in canonical form: radii positive, cones with equal
// radii are cylinders, rings have r0 < r1, a polygon's repeated last vertex is gone; unusable ones (no area, no axis)
// are dropped with a warning.
Scene read_scene(const std::vector<std::string>& files, const ReadOptions& options, const Limits& limits = {});
// Scene text that is not a file's; name: for messages.
Scene read_scene_text(const std::string& text, const std::string& name);
// The same files behind those of a scene that has been read; after an Error it is of no use.
void read_more(Scene& scene, const std::vector<std::string>& files, const ReadOptions& options,
               const Limits& limits = {});

}  // namespace scene
