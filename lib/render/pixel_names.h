// SPDX-License-Identifier: BSD-3-Clause
// Names of the surfaces, materials and light sources of the tables.
#pragma once
#include <string>
#include "flatten/flat_scene.h"
#include "scene/object.h"

namespace render {

class Names {
public:
    // tables: of the scene, with Options::names.
    Names(const flatten::FlatScene& tables, const scene::Scene& scene) : tables_(tables), scene_(scene) {}
    const scene::Object* surface(uint32_t prim, uint32_t inst) const;  // a mesh or instance as a whole; null: none
    std::string name(const scene::Object* o) const { return o ? scene_.name(*o) : ""; }
    std::string place(const scene::Object* o) const { return o ? scene_.place(*o) : ""; }
    std::string modifier(uint32_t record) const;
    std::string source(uint32_t source) const;  // of a virtual one, with its mirrors
    std::string distant(uint32_t number) const;

private:
    const scene::Object* object(uint32_t index) const;

    const flatten::FlatScene& tables_;
    const scene::Scene& scene_;
};

}  // namespace render
