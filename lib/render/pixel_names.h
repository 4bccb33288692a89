// SPDX-License-Identifier: BSD-3-Clause
// Names of the surfaces, materials and light sources of the tables.
#pragma once
#include <string>
#include "flatten/flat_scene.h"
#include "scene/object.h"

namespace render {

class Names {
public:
    using Name = flatten::FlatScene::Name;
    // tables: of the scene, with Options::names.
    Names(const flatten::FlatScene& tables, const scene::Scene& scene) : tables_(tables), scene_(scene) {}
    // Inside a mesh or instance: of what it holds, or its own where that has none.
    Name surface(uint32_t prim, uint32_t inst) const;
    const scene::Object* object(uint32_t prim, uint32_t inst) const;  // a mesh or instance as a whole; null: none
    Name name(const scene::Object* o) const;
    Name modifier(uint32_t record) const;
    Name material(uint32_t prim, uint32_t inst) const;
    std::string source(uint32_t source) const;  // of a virtual one, with its mirrors
    std::string distant(uint32_t number) const;

private:
    const scene::Object* object(uint32_t index) const;

    const flatten::FlatScene& tables_;
    const scene::Scene& scene_;
};

}  // namespace render
