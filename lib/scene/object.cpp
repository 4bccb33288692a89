// SPDX-License-Identifier: BSD-3-Clause
// Questions to a scene that has been read: places, modifiers by name, aliases.
#include "scene/object.h"
#include <algorithm>
#include "base/error.h"

namespace scene {

bool Scene::may_have_light() const {
    return std::any_of(objects.begin(), objects.end(), [](const Object& o) {
        return o.type == Type::light || o.type == Type::glow || o.type == Type::illum || o.type == Type::spotlight ||
               o.type == Type::instance || o.type == Type::mesh;
    });
}

std::string Scene::place(const Object& o) const { return files[o.file] + ":" + std::to_string(o.line); }

std::optional<int32_t> Scene::find_modifier(const std::string& name, int32_t user) const {
    if (name == "void") return VOID;
    const auto found = definitions.find(name);
    if (found == definitions.end()) return {};
    const auto& list = found->second;
    const auto after = std::lower_bound(list.begin(), list.end(), user);  // the last one before the user
    if (after == list.begin()) return {};
    return after[-1];
}

int32_t Scene::lookup_modifier(const std::string& name, int32_t user) const {
    if (const auto found = find_modifier(name, user)) return *found;
    base::fail(place(objects[user]), "modifier \"" + name + "\" is not defined");
}

// Targets are always older than their aliases, so this ends.
Scene::Resolved Scene::resolve(int32_t index) const {
    if (index == VOID) return {VOID, VOID};
    const int32_t modifier = objects[index].modifier;
    while (objects[index].type == Type::alias) index = objects[index].alias_of;
    return {index, modifier};
}

Scene::Resolved Scene::material(int32_t index) const {
    while (index != VOID) {
        const Resolved r = resolve(index);
        if (is_material(objects[r.object].type)) return r;
        index = r.modifier;
    }
    return {VOID, VOID};
}

}  // namespace scene
