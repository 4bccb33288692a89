// SPDX-License-Identifier: BSD-3-Clause
// A modifier means the most recent definition of its name; surfaces are never modifiers.
#include "scene/builder.h"
#include <algorithm>
#include <limits>
#include "base/error.h"
#include "base/memory.h"
#include "base/printable.h"
#include "scene/materials.h"

namespace scene {

SceneBuilder::SceneBuilder(Scene& scene, const Limits& limits) : scene_(scene), limit_(limits.bytes) {
    const uint64_t memory = base::machine_memory();
    if (!limit_) limit_ = memory ? memory / 5 * 4 : uint64_t(8) << 30;
}

uint32_t SceneBuilder::file(const std::string& name) {
    for (size_t i = scene_.files.size(); i-- > 0;)
        if (scene_.files[i] == name) return uint32_t(i);
    scene_.files.push_back(name);
    return uint32_t(scene_.files.size() - 1);
}

int32_t SceneBuilder::modifier(const Primitive& p) {
    if (p.modifier_object != Primitive::by_name) return p.modifier_object;
    if (p.modifier == "void") return VOID;
    if (p.modifier == last_name_) return last_modifier_;
    const auto found = scene_.definitions.find(p.modifier);
    if (found == scene_.definitions.end())
        base::fail(place(p), "modifier \"" + base::excerpt(p.modifier) + "\" is not defined");
    last_name_ = p.modifier;
    return last_modifier_ = found->second.back();
}

void SceneBuilder::make_room(uint64_t primitives, uint64_t bytes) {
    constexpr uint64_t least = 8, real = 5;  // bytes of a primitive without name and arguments; of a real
    primitives = std::min(primitives, bytes / least);
    const uint64_t reals = (bytes - least * primitives) / real;
    if (primitives * sizeof(Object) + reals * sizeof(double) > limit_ / 2) return;  // they may be fewer
    base::make_room(scene_.objects, primitives);
    base::make_room(scene_.real_pool, reals);
}

// Vectors double when they grow: count old and new block.
void SceneBuilder::check_memory(const Primitive& p) {
    const uint64_t used = scene_.objects.size() * sizeof(Object) + scene_.name_pool.size() +
                          scene_.string_pool.size() * sizeof(std::string) + scene_.real_pool.size() * sizeof(double) +
                          extra_;
    if (used > limit_ / 2)
        base::fail(place(p), "the scene needs more memory than allowed (" + std::to_string(limit_ >> 20) +
                                 " MB) after " + std::to_string(scene_.objects.size()) + " primitives");
    if (scene_.objects.size() >= size_t(std::numeric_limits<int32_t>::max()) ||
        scene_.string_pool.size() + p.strings.size() >= std::numeric_limits<uint32_t>::max())
        base::fail(place(p), "the scene has more primitives or strings than 32-bit indices reach");
}

// Pieces of one thing often have one name: it is kept once.
uint32_t SceneBuilder::add_name(const Primitive& p) {
    std::vector<char>& pool = scene_.name_pool;
    if (!pool.empty() && p.name == &pool[name_at_]) return name_at_;
    if (pool.size() + p.name.size() >= std::numeric_limits<uint32_t>::max())
        base::fail(place(p), "the names of the scene need more than 4 GB");
    name_at_ = uint32_t(pool.size());
    pool.insert(pool.end(), p.name.c_str(), p.name.c_str() + p.name.size() + 1);
    return name_at_;
}

int32_t SceneBuilder::add(Primitive& p) {
    Scene& s = scene_;
    const size_t index = s.objects.size();
    if ((index & 1023) == 0 || p.reals.size() + p.strings.size() > 1024) check_memory(p);
    Object o;
    const bool inherits = p.type == Type::alias && (p.modifier == "inherit" || p.strings.empty());
    if (!inherits || p.modifier_object != Primitive::by_name) o.modifier = modifier(p);
    if (is_surface(p.type)) {
        std::string fact;
        if (!normalize_surface(p, *this, fact)) {
            const Type material = [&] {
                const int32_t m = s.material(o.modifier).object;
                return m == VOID ? Type::alias : s.objects[m].type;
            }();
            if (is_emissive(material) && material != Type::glow)
                base::fail(place(p), "light source \"" + base::excerpt(p.name) + "\": " + fact);
            base::warn(place(p), fact + ", left out");
            return VOID;
        }
    } else if (p.type == Type::alias) {
        if (p.strings.empty()) {  // in frozen octrees: the modifier itself is what it stands for
            o.alias_of = o.modifier;
            if (o.alias_of == VOID) base::fail(place(p), "alias \"" + base::excerpt(p.name) + "\" refers to nothing");
        } else {
            const auto found = s.definitions.find(p.strings[0]);
            if (found == s.definitions.end())
                base::fail(place(p), "alias \"" + base::excerpt(p.name) + "\" refers to \"" +
                                         base::excerpt(p.strings[0]) + "\", which is not defined");
            o.alias_of = found->second.back();
        }
        if (inherits) o.modifier = s.objects[o.alias_of].modifier;
    }
    o.type = p.type;
    o.file = p.file;
    o.line = p.line;
    o.name = add_name(p);
    if (p.strings.size() > std::numeric_limits<uint16_t>::max() ||
        p.reals.size() > std::numeric_limits<uint32_t>::max())
        base::fail(place(p),
                   std::string(type_name(p.type)) + " \"" + base::excerpt(p.name) + "\" has too many arguments");
    o.string_at = uint32_t(s.string_pool.size());
    o.string_count = uint16_t(p.strings.size());
    for (const std::string& w : p.strings) {
        s.string_pool.push_back(w);
        if (w.size() > 15) extra_ += w.size() + 17;
    }
    o.real_at = s.real_pool.size();
    o.real_count = uint32_t(p.reals.size());
    s.real_pool.insert(s.real_pool.end(), p.reals.begin(), p.reals.end());
    s.objects.push_back(o);
    if (!is_surface(p.type)) {
        s.definitions[p.name].push_back(int32_t(index));
        extra_ += 120 + p.name.size();
        last_name_.clear();
    }
    return int32_t(index);
}

}  // namespace scene
