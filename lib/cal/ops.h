// SPDX-License-Identifier: BSD-3-Clause
// The device's words as the host compiler sees them: operation numbers, variable indices, noise functions in double.
#pragma once
#include "kernels/dialect/compat_host.h"

namespace cal {
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
namespace device {
#include "kernels/math/vec.h"
#include "kernels/math/math.h"
#include "kernels/bvh/intersect.h"
#include "kernels/cal/cal_vm.h"
}  // namespace device
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
}  // namespace cal
