// SPDX-License-Identifier: BSD-3-Clause
// See features.h.
#include "device/features.h"

#include "flatten/pack.h"

namespace device {
namespace {

using namespace kernels;
using flatten::FlatScene;

// Returns true if a chain of modifiers is its material alone.
bool is_material_alone(const FlatScene& scene, uint32_t mod) {
    if (mod == NONE) return true;
    const uint32_t* record = scene.record(mod);
    return record[MOD_TYPE] >= M_FIRST_MATERIAL && record[MOD_NEXT] == NONE && record[MOD_BRANCH1] == NONE;
}

bool all_materials_alone(const FlatScene& scene) {
    for (size_t i = PRIM_MOD; i < scene.prims.size(); i += PRIM_WORDS)
        if (!is_material_alone(scene, scene.prims[i])) return false;
    for (size_t i = 0; i < scene.instance_object.size(); i++)
        if (!is_material_alone(scene, flatten::bits(scene.shapes[SHAPE_FLOATS * (scene.instances_at + i) + INST_MOD])))
            return false;
    for (size_t i = 0; i < scene.source_count; i++)
        if (!is_material_alone(scene, flatten::bits(scene.f[scene.sources_at + SOURCE_FLOATS * i + SRC_MOD])))
            return false;
    return true;
}

}  // namespace

uint32_t features_of_scene(const FlatScene& scene) {
    return (all_materials_alone(scene) ? 0 : FEATURE_PATTERNS) | (scene.functions ? FEATURE_FUNCTIONS : 0) |
           (scene.trees.size() > 1 ? FEATURE_INSTANCES : 0);
}

uint32_t features_of_pass(const Params& par) {
    return path_media_used(&par) || aims_shadows(&par) ? FEATURE_SOLIDS : 0;
}

}  // namespace device
