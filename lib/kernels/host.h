// SPDX-License-Identifier: BSD-3-Clause
// Layouts and constants of the device code for ordinary host files (no traversal, no shading): namespace kernels.
#pragma once
#include <cstdint>
#include <cstring>
#include <math.h>
namespace kernels {
#include "kernels/compat_host.h"
#include "kernels/vec.h"
#include "kernels/math.h"
#include "kernels/intersect.h"
#include "kernels/tables.h"
#include "kernels/sampler.h"
#include "kernels/share.h"
#include "kernels/path/state.h"
}  // namespace kernels
