// SPDX-License-Identifier: BSD-3-Clause
// Body of the cpu_kernels_*.cpp files: the shared kernels in a namespace of their own (LUX_ISA), run over a tile.
// A tile keeps its path state in the cache and goes through the same queues as the OpenCL kernels.
#include <cstdint>
#include <cstring>
#include <math.h>

#include "device/cpu_kernels.h"
#include "device/pilot_rays.h"

namespace LUX_ISA {
#include "kernels/dialect/compat_host.h"
#include "kernels/all.h"
#include "device/packet_rays.h"
#include "device/packets.h"
#include "device/packet_look.h"

struct Tile {
    Paths paths;
    uint32_t *now, *next, *shadow;
    int* result;  // of shading
};
#define PATH_BYTES(type, name, when) +sizeof(type)
static uint64_t scratch_bytes(uint32_t count) { return uint64_t(count) * (4 * 4 PATH_STATE(PATH_BYTES)) + 64; }
#define PATH_TAKE(type, name, when) t.paths.name = (type*)take(sizeof(type));
static Tile carve(void* scratch, uint32_t count) {
    char* p = reinterpret_cast<char*>((reinterpret_cast<uintptr_t>(scratch) + 63) & ~uintptr_t(63));
    const auto take = [&](size_t size) {
        char* q = p;
        p += size * count;
        return q;
    };
    Tile t;
    PATH_STATE(PATH_TAKE)
    t.now = (uint32_t*)take(4);
    t.next = (uint32_t*)take(4);
    t.shadow = (uint32_t*)take(4);
    t.result = (int*)take(4);
    return t;
}
static void put3(float3 v, float* out) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}
static void store(const Params& par, const Tile& t, uint32_t count, float* film) {
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t place = film_place(&par, i);
        if (place != NONE) put3(xyz4(t.paths.rad[i]), film + 3 * size_t(place));
    }
}
static void extend(const SceneTables& s, const Params& par, Tile& t, uint32_t n) {
    for (uint32_t i = 0; i < n; i++) path_extend(&s, &par, &t.paths, t.now[i]);
}
// The members of the groups of a square.
template <class STAGE>
static void of_groups(STAGE&& stage) {
    for (uint32_t group = 0; group < REUSE_GROUPS; group++)
        for (uint32_t which = 0; which < REUSE_GROUP; which++) stage(REUSE_FIRST(group), which);
}
// Each stage of the n paths of a queue, one path at a time.
struct OneByOne {
    static void generate(const SceneTables& s, const Params& par, Tile& t, uint32_t n) {
        for (uint32_t i = 0; i < n; i++) t.result[i] = path_generate(&s, &par, &t.paths, i);
    }
    static void shade(const SceneTables& s, const Params& par, Tile& t, uint32_t n) {
        for (uint32_t i = 0; i < n; i++) t.result[i] = path_shade(&s, &par, &t.paths, t.now[i]);
    }
    // t.result: what is known of the shadow rays
    static void shadow(const SceneTables& s, const Params& par, Tile& t, uint32_t n) {
        for (uint32_t i = 0; i < n; i++) path_shadow(&s, &par, &t.paths, t.shadow[i], t.result[i]);
    }
    // of a square, as what follows
    static void suffix_roulette(Tile& t) {
        of_groups([&](uint32_t first, uint32_t which) { path_suffix_roulette(&t.paths, first, which); });
    }
    static void transmittance(const SceneTables& s, const Params& par, Tile& t, const uint32_t* which, uint32_t n) {
        for (uint32_t i = 0; i < n; i++)
            connection_transmittance(&s, &par, &t.paths, which[i] / REUSE_GROUP, which[i] % REUSE_GROUP);
    }
    static void connect(const SceneTables& s, const Params& par, Tile& t) {
        of_groups([&](uint32_t first, uint32_t which) { path_connect(&s, &par, &t.paths, first, which); });
    }
    static void normalise_mis(Tile& t, uint32_t n) {
        for (uint32_t i = 0; i < n; i++) path_normalise_mis(&t.paths, t.now[i]);
    }
    static void gather(Tile& t) {
        of_groups([&](uint32_t first, uint32_t which) { path_gather(&t.paths, first, which); });
    }
};
#ifdef LANE_CALL
#include "device/cpu_lanes.h"
#endif
// The same in packets, where rays that follow one another in the queue lie side by side.
static void extend_together(const SceneTables& s, Tile& t, uint32_t n) {
    Packet p;
    for (uint32_t i = 0; i < n; i += p.count) {
        p.count = n - i < PACKET ? n - i : PACKET;
        for (uint32_t k = 0; k < p.count; k++) packet_put(p, k, path_ray(&t.paths, t.now[i + k]));
        packet_trace(s, p, RAY_ALL);
        for (uint32_t k = 0; k < p.count; k++) {
            Hit hit = p.look[k].hit;
            const Ray ray = path_ray(&t.paths, t.now[i + k]);
            if (may_coincide(&p.look[k])) trace_on(&s, &ray, RAY_ALL, 1, &p.look[k], &hit);
            set_path_hit(&t.paths, t.now[i + k], &hit);
        }
    }
}
// t.result: whether opaque surfaces block the shadow rays, where packets can tell.
static void block_together(const SceneTables& s, const Params& par, Tile& t, uint32_t n) {
    PacketRays p;
    uint32_t of[PACKET], panes;
    for (uint32_t i = 0; i < n;) {
        for (p.count = 0; i < n && p.count < PACKET; i++) {
            Ray ray;
            if (!shadow_is_plain(&s, &par, &t.paths, t.shadow[i], &ray)) continue;
            of[p.count] = i;
            packet_put(p, p.count++, ray);
        }
        const uint32_t open = packet_look(s, p, packet_all(p), RAY_OPAQUE, &panes);
        for (uint32_t k = 0; k < p.count; k++) t.result[of[k]] = (open >> k & 1u) != 0 ? SHADOW_OPEN : SHADOW_BLOCKED;
    }
}
#include "device/cpu_connections.h"
// Follows the n paths of the queue to their ends.  together: their rays lie side by side.
template <class STAGES>
static void follow(const SceneTables& s, const Params& par, Tile& t, uint32_t n, bool together) {
    for (; n > 0; together = false) {
        uint32_t goes_on = 0, shadows = 0;
        if (together) extend_together(s, t, n);
        else extend(s, par, t, n);
        STAGES::shade(s, par, t, n);
        for (uint32_t i = 0; i < n; i++) {
            if (t.result[i] & PATH_CONTINUES) t.next[goes_on++] = t.now[i];
            if (t.result[i] & PATH_SHADOW) t.shadow[shadows++] = t.now[i];
        }
        for (uint32_t i = 0; i < shadows; i++) t.result[i] = SHADOW_TO_TRACE;
        block_together(s, par, t, shadows);
        STAGES::shadow(s, par, t, shadows);
        uint32_t* swap = t.now;
        t.now = t.next;
        t.next = swap;
        n = goes_on;
    }
}
// The connections of the queue that may lead through panes: a row of their own, for few suffix vertices have some.
template <class STAGES>
static void transmittance(const SceneTables& s, const Params& par, Tile& t, uint32_t n) {
    uint32_t connections[REUSE_SQUARE * REUSE_GROUP], count = 0;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t path = t.now[i];
        uint32_t left = connections_to_attenuate(t.paths.connections[path], reuse_which(path));
        for (; left != 0; left &= left - 1) connections[count++] = path * REUSE_GROUP + uint32_t(__builtin_ctz(left));
    }
    STAGES::transmittance(s, par, t, connections, count);
}
// Far ends light the prefix vertices of their groups, in one square.
template <class STAGES>
static void share(const SceneTables& s, const Params& par, Tile& t) {
    uint32_t n = 0;
    STAGES::suffix_roulette(t);
    of_groups([&](uint32_t first, uint32_t which) {
        const uint32_t path = REUSE_MEMBER(first, which);
        if (HAS_PREFIX(&t.paths, path)) t.now[n++] = path;
    });
    know_connections(s, par, t, n);
    transmittance<STAGES>(s, par, t, n);
    STAGES::connect(s, par, t);
    STAGES::normalise_mis(t, n);
    STAGES::gather(t);
}
// Square by square: what the paths of one share stays in the cache.
#define PATH_SKIP(type, name, when) square.paths.name += first;
template <class STAGES>
static void share_squares(const SceneTables& s, const Params& par, const Tile& t, uint32_t count) {
    for (uint32_t first = 0; first < count; first += REUSE_SQUARE) {
        Tile square = t;
        PATH_STATE(PATH_SKIP)
        share<STAGES>(s, par, square);
    }
}
static Params part_of(const void* params, uint32_t first, uint32_t count) {
    Params par = *static_cast<const Params*>(params);
    par.first = first;
    par.path_count = count;
    return par;
}
template <class STAGES>
static void run(const void* tables, const void* params, uint32_t first, uint32_t count, void* scratch, float* film) {
    const SceneTables s = *static_cast<const SceneTables*>(tables);
    const Params par = part_of(params, first, count);
    Tile t = carve(scratch, count);
    uint32_t n = 0;
    STAGES::generate(s, par, t, count);
    for (uint32_t i = 0; i < count; i++)
        if (t.result[i] != 0) t.now[n++] = i;
    follow<STAGES>(s, par, t, n, par.mode != MODE_RAY && (par.flags & PF_EYE_ON_SURFACE) == 0);
    if (par.reuse_path_count != 0) share_squares<STAGES>(s, par, t, count);
    store(par, t, count, film);
}
// device::SplatRay
struct Ray9 {
    float org[3], dir[3], dist, weight;
    uint32_t source;
};
static void splat(const void* tables, const void* params, const void* rays, uint32_t first, uint32_t count,
                 void* scratch, float* rgb) {
    const SceneTables s = *static_cast<const SceneTables*>(tables);
    const Params par = part_of(params, first, count);
    Tile t = carve(scratch, count);
    const Ray9* r = static_cast<const Ray9*>(rays) + first;
    for (uint32_t i = 0; i < count; i++) {
        t.paths.shadow_org[i] = pack4(F3(r[i].org[0], r[i].org[1], r[i].org[2]), as_float_(r[i].source));
        t.paths.shadow_dir[i] = pack4(F3(r[i].dir[0], r[i].dir[1], r[i].dir[2]), r[i].dist);
        t.paths.shadow_rad[i] = pack4(F3(r[i].weight, r[i].weight, r[i].weight), 0.0f);
        path_splat(&s, &par, &t.paths, i);
        path_shadow(&s, &par, &t.paths, i, SHADOW_TO_TRACE);
    }
    store(par, t, count, rgb);
}
template <class STAGES>
static void pilot(const void* tables, const void* params, const void* rays, uint32_t first, uint32_t count,
                 void* scratch, void* ends) {
    const SceneTables s = *static_cast<const SceneTables*>(tables);
    const Params par = part_of(params, first, count);
    Tile t = carve(scratch, count);
    const device::PilotRay* r = static_cast<const device::PilotRay*>(rays) + first;
    uint32_t n = 0;
    for (uint32_t i = 0; i < count; i++) {
        t.paths.org[i] = pack4(F3(r[i].org[0], r[i].org[1], r[i].org[2]), 0.0f);
        t.paths.dir[i] = pack4(F3(r[i].dir[0], r[i].dir[1], r[i].dir[2]), r[i].dir_w);
        if (path_begin_pilot(&par, &t.paths, i)) t.now[n++] = i;
    }
    follow<STAGES>(s, par, t, n, false);
    device::PilotEnd* end = static_cast<device::PilotEnd*>(ends) + first;
    for (uint32_t i = 0; i < count; i++) {
        put3(xyz4(t.paths.rad[i]), end[i].gathered);
        put3(xyz4(t.paths.throughput[i]), end[i].throughput);
        put3(xyz4(t.paths.org[i]), end[i].p);
        put3(xyz4(t.paths.dir[i]), end[i].n);
        end[i].bounce = t.paths.dir[i].w == PILOT_AT_BOUNCE;
    }
}
}  // namespace LUX_ISA

namespace device {
#define LUX_PASTE_(a, b) a##b
#define LUX_PASTE(a, b) LUX_PASTE_(a, b)
#define LUX_KERNELS(name, STAGES) \
    { name, LUX_ISA::run<LUX_ISA::STAGES>, LUX_ISA::splat, LUX_ISA::pilot<LUX_ISA::STAGES>, LUX_ISA::scratch_bytes }
#ifdef LUX_ISA_NAME
extern const CpuKernels LUX_PASTE(cpu_, LUX_ISA);
const CpuKernels LUX_PASTE(cpu_, LUX_ISA) = LUX_KERNELS(LUX_ISA_NAME, OneByOne);
#endif
#ifdef LANE_CALL
extern const CpuKernels LUX_LANES_OF_ISA;
const CpuKernels LUX_LANES_OF_ISA = LUX_KERNELS(LUX_LANES_NAME, InLanes);
#endif
}  // namespace device
