// SPDX-License-Identifier: BSD-3-Clause
// Functions of the kernels, evaluated on the host over tables that are still being filled.
#pragma once
#include <cstdint>
#include "base/vec.h"
#include "flatten/flat_scene.h"

namespace flatten {

// Mean luminance of a light source, patterns included, over its points and the directions of its emission.
double mean_luminance(const FlatScene& scene, const kernels::Source& source);

// Luminance of a distant surface in a direction, patterns included.
double distant_luminance(const FlatScene& scene, const kernels::Distant& distant, base::Vec3 dir);

// Has the BSDF of a modifier record an orientation at point p (relative to scene.centre) of a surface of normal n?  Not
// if its up vector is 0 or along n.
bool has_orientation(const FlatScene& scene, uint32_t mod, base::Vec3 p, base::Vec3 n);

// Runs a .cal program of the scene's arenas for one point; false on a run-time error.  vars: CAL_VARS, out:
// CAL_OUTPUTS.
bool run_program(const FlatScene& scene, uint32_t entry, const float* vars, float* out);
struct RayVars {
    float values[64];
};
// The variables a program sees at point p (relative to scene.centre) for a ray of direction d on a surface of normal n.
RayVars ray_vars(const FlatScene& scene, base::Vec3 p, base::Vec3 d, base::Vec3 n);

}  // namespace flatten
