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
    Type type(int32_t object) const { return scene_.objects[object].type; }
    std::string place(const Primitive& p) const { return scene_.files[p.file] + ":" + std::to_string(p.line); }

private:
    int32_t modifier(const Primitive& p);
    void check_memory(const Primitive& p);
    Scene& scene_;
    uint64_t limit_, extra_ = 0;  // bytes; extra: what strings hold outside their own size
    std::string last_name_;
    int32_t last_modifier_ = VOID;
};

// Canonical form of a surface (see read_scene); false: unusable, `fact` says why.  Throws for what RADIANCE calls
// fatal.
bool normalize_surface(Primitive& p, const std::string& place, std::string& fact);

}  // namespace scene
