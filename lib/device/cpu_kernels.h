// SPDX-License-Identifier: BSD-3-Clause
// Functions of one instruction-set build of the kernels, for the CPU device.
#pragma once
#include <cstdint>
#include "kernels/dialect/host.h"
#include "device/given_rays.h"
#include "device/hour_paths.h"

namespace device {

struct CpuKernels {
    const char* name;
    // Runs paths [first, first + count) of a pass.  film: 3 floats for each of them, or, with path reuse, the whole
    // pass's (kernels/integrator/path_reuse.h).  scratch: scratch_bytes(count).
    void (*run)(const kernels::SceneTables& s, const kernels::Params& par, uint32_t first, uint32_t count,
                char* scratch, float* film);
    // The same of paths for many hours; out: of these paths.
    void (*run_hours)(const kernels::SceneTables& s, const kernels::Params& par, uint32_t first, uint32_t count,
                      char* scratch, float* film, HourPaths& out);
    // The same for given rays; rays, rgb and ends of the whole pass.
    void (*splat)(const kernels::SceneTables& s, const kernels::Params& par, const SplatRay* rays, uint32_t first,
                  uint32_t count, char* scratch, float* rgb);
    void (*pilot)(const kernels::SceneTables& s, const kernels::Params& par, const PilotRay* rays, uint32_t first,
                  uint32_t count, char* scratch, PilotEnd* ends);
    uint64_t (*scratch_bytes)(uint32_t count);
    void (*layout)(uint32_t* sizes);  // of RECORDS (kernels/records.h)
};
extern const CpuKernels cpu_baseline, cpu_avx2;
#if defined(LUXPIPE_LANES8) || defined(LUXPIPE_LANES16)
extern const CpuKernels cpu_lanes8, cpu_lanes16;  // with AVX2 and AVX-512: 8 and 16 paths side by side
#endif

}  // namespace device
