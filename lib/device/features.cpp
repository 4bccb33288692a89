// SPDX-License-Identifier: BSD-3-Clause
// See features.h.
#include "device/features.h"

#include <algorithm>

namespace device {
namespace {

using namespace kernels;
using flatten::FlatScene;

// Returns true if a chain of modifiers is its material alone.
bool is_material_alone(const FlatScene& scene, uint32_t mod) {
    if (mod == NONE) return true;
    const Modifier& m = scene.modifiers[mod];
    return m.type >= M_FIRST_MATERIAL && m.next == NONE && m.branch1 == NONE && m.rs_mod == NONE && m.ts_mod == NONE &&
           m.td_mod == NONE;
}

bool all_materials_alone(const FlatScene& scene) {
    const auto alone = [&](const auto& records) {
        return std::all_of(records.begin(), records.end(),
                           [&](const auto& record) { return is_material_alone(scene, record.mod); });
    };
    return alone(scene.prims) && alone(scene.instances) && alone(scene.sources);
}

}  // namespace

uint32_t features_of_scene(const FlatScene& scene) {
    return (all_materials_alone(scene) ? 0 : FEATURE_PATTERNS) | (scene.functions ? FEATURE_FUNCTIONS : 0) |
           (scene.trees.size() > 1 ? FEATURE_INSTANCES : 0);
}

uint32_t features_of_pass(const kernels::Params& par) {
    return path_media_used(&par) || aims_shadows(&par) ? FEATURE_SOLIDS : 0;
}

}  // namespace device
