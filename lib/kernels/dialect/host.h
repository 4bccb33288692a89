// SPDX-License-Identifier: BSD-3-Clause
// Layouts and constants of the device code for ordinary host files (no traversal, no shading): namespace kernels.
#pragma once
#include <cstdint>
#include <cstring>
#include <math.h>
namespace kernels {
#include "kernels/dialect/compat_host.h"
#include "kernels/math/vec.h"
#include "kernels/math/math.h"
#include "kernels/bvh/intersect.h"
#include "kernels/tables.h"
#include "kernels/sampling/sampler.h"
#include "kernels/integrator/path_reuse.h"
#include "kernels/integrator/state.h"
}  // namespace kernels
