// SPDX-License-Identifier: BSD-3-Clause
// The OpenCL program: the device's words, the shared code, the entries.
#include "kernels/dialect/compat_opencl.h"
#include "kernels/all.h"
#include "kernels/self_test.h"
#include "kernels/entry.cl"
