// SPDX-License-Identifier: BSD-3-Clause
// See host_rays.h; flags in CMakeLists.txt.  Nothing here may be shared with other files: the linker could take it from
// here for machines without AVX2.
#include "flatten/host_rays.h"
namespace kernels {
#include "kernels/all.h"
}  // namespace kernels

const flatten::HostRays flatten::host_rays_avx2 = {kernels::trace_closest, kernels::trace_any};
