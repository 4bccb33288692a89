// SPDX-License-Identifier: BSD-3-Clause
// flatten(): modifiers, instances, geometry, sources, in this order, into one pair of arenas.
#include "trace/flat_scene.h"

#include "trace/flatten.h"
#include "trace/instances.h"

namespace trace {
using namespace kernels;

bool see_through(const FlatScene& scene, uint32_t prim, uint32_t inst) {
    uint32_t mod = scene.prims[PRIM_WORDS * size_t(prim) + PRIM_MOD];
    if (inst != FlatScene::NO_OBJECT) {
        const uint32_t replaced = bits(scene.shapes[SHAPE_FLOATS * size_t(inst) + INST_MOD]);
        if (replaced != NONE) mod = replaced;
    }
    for (; mod != NONE; mod = scene.u[scene.mods_at + MOD_WORDS * mod + MOD_NEXT]) {
        const uint32_t type = scene.u[scene.mods_at + MOD_WORDS * mod + MOD_TYPE];
        if (type >= M_FIRST_MATERIAL) return material_has(type, MT_CLEAR) != 0u;
    }
    return false;
}

FlatScene flatten(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files) {
    FlatScene out;
    Flattener f(scene, options, files, out);
    Instances instances(f);
    instances.prepare(f);
    f.flatten_modifiers();
    instances.place();
    // .cal code stands first in both arenas: its addresses are absolute
    out.u = std::move(f.code.words);
    out.f = std::move(f.code.floats);
    const uint32_t args_at = uint32_t(out.f.size());
    out.f.insert(out.f.end(), f.args.begin(), f.args.end());
    for (size_t i = 0; i < f.mods.size(); i += MOD_WORDS) f.mods[i + MOD_ARGS] += args_at;
    out.mods_at = uint32_t(out.u.size());
    out.u.insert(out.u.end(), f.mods.begin(), f.mods.end());
    instances.flatten_geometry();
    f.flatten_sources();
    return out;
}

}  // namespace trace
