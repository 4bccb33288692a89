// SPDX-License-Identifier: BSD-3-Clause
// Body of the cpu_kernels_*.cpp files: the shared kernels, compiled for one instruction set (LUX_ISA, a namespace of
// its own for what is not static), run over tiles.
#include "device/cpu_kernels.h"
#include "device/hour_shares.h"
#include "device/wavefront.h"

namespace kernels {
#include "kernels/all.h"
}

namespace LUX_ISA {
using namespace kernels;
#include "device/packet_rays.h"
#include "device/packets.h"
#include "device/packet_look.h"
#include "device/cpu_tile.h"
#include "device/cpu_connections.h"
#include "device/cpu_backend.h"
#include "device/cpu_hours.h"
#ifdef LANE_CALL
#include "device/cpu_lanes.h"
#endif

template <class STAGES>
static void run(const SceneTables& s, const Params& par, uint32_t first, uint32_t count, char* scratch, float* film) {
    Tile t = carve(s, par, first, count, scratch);
    TileBackend<STAGES> backend{t};
    device::run_paths(backend, par.reuse_path_count != 0);
    store(t, film);
}

template <class STAGES>
static void run_hours(const SceneTables& s, const Params& par, uint32_t first, uint32_t count, char* scratch,
                      float* film, device::HourPaths& out) {
    Tile t = carve(s, par, first, count, scratch);
    HoursBackend<STAGES> backend(t);
    device::run_paths(backend, false);
    if (par.reuse_path_count != 0) keep_shares(backend, out);
    store(t, film);
    backend.found.sort(2 * count, out);
    keep_skies(t, out);
}

static void splat(const SceneTables& s, const Params& par, const device::SplatRay* rays, uint32_t first, uint32_t count,
                  char* scratch, float* rgb) {
    const Tile t = carve(s, par, first, count, scratch);
    for (uint32_t i = 0; i < count; i++) {
        const device::SplatRay& ray = rays[first + i];
        t.paths.shadow_org[i] = shadow_org_words(F3(ray.org[0], ray.org[1], ray.org[2]), ray.source);
        t.paths.shadow_dir[i] = shadow_dir_words(F3(ray.dir[0], ray.dir[1], ray.dir[2]), ray.dist);
        t.paths.shadow_rad[i] = shadow_rad_words(F3(ray.weight, ray.weight, ray.weight), 0.0f);
        path_splat(&s, &t.par, &t.paths, i);
        path_shadow(&s, &t.par, &t.paths, i, SHADOW_TO_TRACE);
    }
    store(t, rgb + 3 * size_t(first));
}

template <class STAGES>
static void pilot(const SceneTables& s, const Params& par, const device::PilotRay* rays, uint32_t first, uint32_t count,
                  char* scratch, device::PilotEnd* ends) {
    Tile t = carve(s, par, first, count, scratch);
    TileBackend<STAGES> backend{t};
    backend.begin_pilots(rays + first);
    device::follow_paths(backend);
    for (uint32_t i = 0; i < count; i++) {
        device::PilotEnd& end = ends[first + i];
        put3(xyz4(t.paths.rad[i]), end.gathered);
        put3(xyz4(t.paths.throughput[i]), end.throughput);
        put3(xyz4(t.paths.org[i]), end.p);
        put3(xyz4(t.paths.dir[i]), end.n);
        end.bounce = dir_length(t.paths.dir[i]) == PILOT_AT_BOUNCE;
    }
}
}  // namespace LUX_ISA

namespace device {
#define LUX_PASTE_(a, b) a##b
#define LUX_PASTE(a, b) LUX_PASTE_(a, b)
#define LUX_KERNELS(name, STAGES) \
    {                             \
        name, LUX_ISA::run<LUX_ISA::STAGES>, LUX_ISA::run_hours<LUX_ISA::STAGES>, LUX_ISA::splat,     \
            LUX_ISA::pilot<LUX_ISA::STAGES>, LUX_ISA::scratch_bytes, LUX_ISA::STAGES::layout \
    }
#ifdef LUX_ISA_NAME
extern const CpuKernels LUX_PASTE(cpu_, LUX_ISA);
const CpuKernels LUX_PASTE(cpu_, LUX_ISA) = LUX_KERNELS(LUX_ISA_NAME, OneByOne);
#endif
#ifdef LANE_CALL
extern const CpuKernels LUX_LANES_OF_ISA;
const CpuKernels LUX_LANES_OF_ISA = LUX_KERNELS(LUX_LANES_NAME, InLanes);
#endif
}  // namespace device
