// SPDX-License-Identifier: BSD-3-Clause
// Functions of one instruction-set build of the kernels, for the CPU device.  The tables cross as void*: each build has
// its own (identical) types in its own namespace.
#pragma once
#include <cstdint>

namespace device {

struct CpuKernels {
    const char* name;
    // Runs paths [first, first + count) of a pass.  film: 3 floats for each of them, or, with path reuse, the whole
    // pass's (kernels/integrator/path_reuse.h).  scratch: scratch_bytes(count).
    void (*run)(const void* scene_tables, const void* params, uint32_t first, uint32_t count, void* scratch,
                float* film);
    // Rays in the layout of device::SplatRay.
    void (*splat)(const void* scene_tables, const void* params, const void* rays, uint32_t first, uint32_t count,
                  void* scratch, float* rgb);
    // Rays and ends in the layouts of device::PilotRay and PilotEnd.
    void (*pilot)(const void* scene_tables, const void* params, const void* rays, uint32_t first, uint32_t count,
                  void* scratch, void* ends);
    uint64_t (*scratch_bytes)(uint32_t count);
};
extern const CpuKernels cpu_baseline, cpu_avx2;
#if defined(LUXPIPE_LANES8) || defined(LUXPIPE_LANES16)
extern const CpuKernels cpu_lanes8, cpu_lanes16;  // with AVX2 and AVX-512: 8 and 16 paths side by side
#endif

}  // namespace device
