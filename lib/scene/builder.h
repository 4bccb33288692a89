// SPDX-License-Identifier: BSD-3-Clause
// Primitives into the tables of a Scene: modifiers looked up, arguments counted, surfaces put into canonical form.
#pragma once
#include <string>
#include "scene/primitive.h"

namespace scene {

class SceneBuilder {
public:
    SceneBuilder(Scene& scene, const Limits& limits);
    int32_t add(Primitive& p);               // p may be changed; index of the object, VOID if it was left out
    uint32_t file(const std::string& name);  // index into scene.files
    // So many primitives are to come, in so many bytes of a binary file: room for all, asked for once.
    void make_room(uint64_t primitives, uint64_t bytes);
    Type type(int32_t object) const { return scene_.objects[object].type; }
    std::string place(const Primitive& p) const { return scene_.files[p.file] + ":" + std::to_string(p.line); }

private:
    int32_t modifier(const Primitive& p);
    void check_memory(const Primitive& p);
    uint32_t add_name(const Primitive& p);
    Scene& scene_;
    uint64_t limit_, extra_ = 0;  // bytes; extra: what strings and definitions hold outside the tables
    uint32_t name_at_ = 0;        // of the last one
    std::string last_name_;       // of a modifier, and its object
    int32_t last_modifier_ = VOID;
};

// Canonical form of a surface (see read_scene); false: unusable, `fact` says why.  Throws for what RADIANCE calls
// fatal.  The builder knows its place.
bool normalize_surface(Primitive& p, const SceneBuilder& builder, std::string& fact);

}  // namespace scene
