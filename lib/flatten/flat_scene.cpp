// SPDX-License-Identifier: BSD-3-Clause
// Queries of the finished tables.
#include "flatten/flat_scene.h"

#include "base/memory.h"
#include "kernels/dialect/host.h"

namespace flatten {

void Draft::make_room(size_t more_vertices, size_t more_triangles, size_t more_prims) {
    base::make_room(vertices, 3 * more_vertices);
    base::make_room(triangles, 3 * more_triangles);
    base::make_room(tri_prim, more_triangles);
    base::make_room(prims, more_prims);
    base::make_room(prim_object, more_prims);
}

FlatScene Draft::finished() && {
    FlatScene out = std::move(static_cast<FlatScene&>(*this));
    out.geometry = std::make_shared<const Geometry>(std::move(static_cast<Geometry&>(*this)));
    return out;
}

void FlatScene::keep_tables_only() {
    geometry = nullptr;
    if (modifier_names.empty()) prim_object = std::vector<uint32_t>();  // "= {}" would keep the memory
}

uint32_t material_record(const FlatScene& scene, uint32_t mod) {
    while (mod != NONE && scene.modifiers[mod].type < M_FIRST_MATERIAL) mod = scene.modifiers[mod].next;
    return mod;
}

uint32_t material_of(const FlatScene& scene, uint32_t prim, uint32_t inst) {
    uint32_t mod = scene.prims[prim].mod;
    if (inst != FlatScene::NO_OBJECT) {
        const uint32_t replaced = scene.instances[inst].mod;
        if (replaced != NONE) mod = replaced;
    }
    return material_record(scene, mod);
}

bool see_through(const FlatScene& scene, uint32_t prim, uint32_t inst) {
    const uint32_t mod = material_of(scene, prim, inst);
    return mod != NONE && material_has(scene.modifiers[mod].type, MT_CLEAR) != 0u;
}

}  // namespace flatten
