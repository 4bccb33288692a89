// SPDX-License-Identifier: BSD-3-Clause
// See features.h.
#include "trace/features.h"

#include "flatten/pack.h"

namespace trace {
namespace {

using namespace kernels;
using flatten::FlatScene;

// Is a chain of modifiers its material alone?
bool is_material_alone(const FlatScene& scene, uint32_t mod) {
    if (mod == NONE) return true;
    const uint32_t* record = scene.record(mod);
    return record[MOD_TYPE] >= M_FIRST_MATERIAL && record[MOD_NEXT] == NONE && record[MOD_BRANCH1] == NONE;
}

bool all_lamps_alone(const FlatScene& scene) {
    for (size_t i = 0; i < scene.source_count; i++)
        if (!is_material_alone(scene, flatten::bits(scene.f[scene.sources_at + SOURCE_FLOATS * i + SRC_MOD])))
            return false;
    return true;
}

bool all_materials_alone(const FlatScene& scene) {
    for (size_t i = PRIM_MOD; i < scene.prims.size(); i += PRIM_WORDS)
        if (!is_material_alone(scene, scene.prims[i])) return false;
    for (size_t i = 0; i < scene.instance_object.size(); i++)
        if (!is_material_alone(scene, flatten::bits(scene.shapes[SHAPE_FLOATS * (scene.instances_at + i) + INST_MOD])))
            return false;
    return all_lamps_alone(scene);
}

}  // namespace

uint32_t features_of_scene(const FlatScene& scene) {
    return (all_materials_alone(scene) ? 0 : FEATURE_PATTERNS) | (all_lamps_alone(scene) ? 0 : FEATURE_LAMPS) |
           (scene.functions ? FEATURE_FUNCTIONS : 0) | (scene.trees.size() > 1 ? FEATURE_INSTANCES : 0);
}

// Each kernel walks the chains that it meets where shading runs .cal programs anyway, and where it would need more than
// is kept for it: of the white surface of -i the textures before its material; the patterns of lamps that light media,
// or to which mirrors and prisms send shadow rays.
uint32_t with_features_of_pass(uint32_t known, const Params& par) {
    uint32_t has = known | (path_media_used(&par) || aims_shadows(&par) ? FEATURE_SOLIDS : 0) |
                   (has_guide(&par) ? FEATURE_GUIDE : 0);
    const bool lamps_elsewhere = (has & FEATURE_LAMPS) != 0 && (has & FEATURE_SOLIDS) != 0;
    const bool white = (par.flags & PF_IRRADIANCE) != 0;
    if ((has & FEATURE_PATTERNS) != 0 && ((has & FEATURE_FUNCTIONS) != 0 || white || lamps_elsewhere))
        has |= FEATURE_CHAINS;
    return has;
}

}  // namespace trace
