// SPDX-License-Identifier: BSD-3-Clause
// Features (kernels/features.h) of a scene and a pass, FEATURE_* bits.
#pragma once
#include "flatten/flat_scene.h"
#include "kernels/dialect/host.h"

namespace device {

uint32_t features_of_scene(const flatten::FlatScene& scene);
uint32_t features_of_pass(const kernels::Params& par);

}  // namespace device
