// SPDX-License-Identifier: BSD-3-Clause
// The rows of kernels/material/materials.h as the host asks for them, and what depends on a material's arguments.
#pragma once
#include "scene/object.h"

namespace scene {

enum class Passes { no, yes, ask };

struct Material {
    uint32_t number;  // M_* of the kernels
    uint32_t flags;   // MF_* that distinguish rows of the same number
    uint32_t traits;  // MT_*
    Passes light, eye;
    size_t filled;  // absent arguments up to this many are `fill`
    float fill;
};
const Material& material_row(Type type);  // of a material

// A light; what region queries look through
inline bool is_emissive(Type type) { return is_material(type) && (material_row(type).traits & MT_EMISSIVE) != 0; }
inline bool is_clear(Type type) { return is_material(type) && (material_row(type).traits & MT_CLEAR) != 0; }

// Does a shadow ray pass this material (spec shading 4.5)?  bv: backs are visible, else it may pass from behind.
bool light_passes(const Scene& scene, const Object& material, bool bv);

// A transparent type in RADIANCE's eyes: -i looks through it.  Functions count by their text: "0" is nothing, all else
// may be something.
bool eye_passes(const Scene& scene, const Object& material);

// Does a mirror give way to this alternate?  It does to transparent types, and not to BSDF, which is a proxy.
bool mirror_gives_way(const Scene& scene, const Object& material);

}  // namespace scene
