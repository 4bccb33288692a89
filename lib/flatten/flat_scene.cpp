// SPDX-License-Identifier: BSD-3-Clause
// Queries of the finished tables.
#include "flatten/flat_scene.h"

#include "base/memory.h"
#include "flatten/pack.h"
#include "kernels/dialect/host.h"

namespace flatten {

const uint32_t* FlatScene::record(uint32_t mod) const { return &u[mods_at + MOD_WORDS * size_t(mod)]; }

void FlatScene::make_room(size_t more_vertices, size_t more_triangles, size_t more_prims) {
    base::make_room(vertices, 3 * more_vertices);
    base::make_room(triangles, 3 * more_triangles);
    base::make_room(tri_prim, more_triangles);
    base::make_room(prims, PRIM_WORDS * more_prims);
    base::make_room(prim_object, more_prims);
}

void FlatScene::keep_tables_only() {
    triangles = std::vector<uint32_t>(), tri_prim = std::vector<uint32_t>();  // "= {}" would keep the memory
    shape_prim = std::vector<uint32_t>();
    if (modifier_names.empty()) prim_object = std::vector<uint32_t>();
    vertices = std::vector<float>(), panes = std::vector<Pane>();
}

uint32_t material_record(const FlatScene& scene, uint32_t mod) {
    while (mod != NONE && scene.record(mod)[MOD_TYPE] < M_FIRST_MATERIAL) mod = scene.record(mod)[MOD_NEXT];
    return mod;
}

bool see_through(const FlatScene& scene, uint32_t prim, uint32_t inst) {
    uint32_t mod = scene.prims[PRIM_WORDS * size_t(prim) + PRIM_MOD];
    if (inst != FlatScene::NO_OBJECT) {
        const uint32_t replaced = bits(scene.shapes[SHAPE_FLOATS * size_t(inst) + INST_MOD]);
        if (replaced != NONE) mod = replaced;
    }
    mod = material_record(scene, mod);
    return mod != NONE && material_has(scene.record(mod)[MOD_TYPE], MT_CLEAR) != 0u;
}

}  // namespace flatten
