// SPDX-License-Identifier: BSD-3-Clause
// A tile: paths whose state stays in the cache, and their queues.  Included by cpu_kernels.inl.
#ifndef LUX_CPU_TILE_H
#define LUX_CPU_TILE_H

struct Tile {
    const SceneTables* s;
    Params par;  // of these paths
    Paths paths;
    uint32_t *now, *next, *shadow;             // queues
    int* result;                               // of a stage, by path or by place in its queue
    uint32_t n = 0, goes_on = 0, shadows = 0;  // lengths of these queues
    bool together = false;                     // do first rays that follow one another in the queue lie side by side?
};

#define PATH_BYTES(type, name, when, members) +sizeof(type)
static uint64_t scratch_bytes(uint32_t count) { return uint64_t(count) * (4 * 4 PATH_STATE(PATH_BYTES)) + 64; }

// Paths [first, first + count) of a pass, in scratch_bytes(count).
#define PATH_TAKE(type, name, when, members) t.paths.name = (type*)take(sizeof(type));
static Tile carve(const SceneTables& s, const Params& par, uint32_t first, uint32_t count, char* scratch) {
    char* p = reinterpret_cast<char*>((reinterpret_cast<uintptr_t>(scratch) + 63) & ~uintptr_t(63));
    const auto take = [&](size_t size) {
        char* q = p;
        p += size * count;
        return q;
    };
    Tile t;
    t.s = &s;
    t.par = par;
    t.par.first = first;
    t.par.path_count = count;
    PATH_STATE(PATH_TAKE)
    t.now = (uint32_t*)take(4);
    t.next = (uint32_t*)take(4);
    t.shadow = (uint32_t*)take(4);
    t.result = (int*)take(4);
    return t;
}

// One square of it.
#define PATH_SKIP(type, name, when, members) square.paths.name += first;
static Tile square_of(const Tile& t, uint32_t first) {
    Tile square = t;
    PATH_STATE(PATH_SKIP)
    return square;
}

static void put3(float3 v, float* out) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static void store(const Tile& t, float* film) {
    for (uint32_t i = 0; i < t.par.path_count; i++) {
        const uint32_t place = film_place(&t.par, i);
        if (place != NONE) put3(xyz4(t.paths.rad[i]), film + 3 * size_t(place));
    }
}

// The members of the groups of a square.
template <class STAGE>
static void of_groups(STAGE&& stage) {
    for (uint32_t group = 0; group < REUSE_GROUPS; group++)
        for (uint32_t which = 0; which < REUSE_GROUP; which++) stage(REUSE_FIRST(group), which);
}

// Each stage of the paths of a queue, one path at a time (cpu_lanes.h: in lanes).
struct OneByOne {
    static void layout(uint32_t* sizes) { record_sizes(sizes); }
    static void generate(Tile& t) {
        for (uint32_t i = 0; i < t.par.path_count; i++) t.result[i] = path_generate(t.s, &t.par, &t.paths, i);
    }
    static void shade(Tile& t) {
        for (uint32_t i = 0; i < t.n; i++) t.result[i] = path_shade(t.s, &t.par, &t.paths, t.now[i]);
    }
    // t.result: visibility of each shadow ray (integrator/shadow.h)
    static void shadow(Tile& t) {
        for (uint32_t i = 0; i < t.shadows; i++) path_shadow(t.s, &t.par, &t.paths, t.shadow[i], t.result[i]);
    }
    // of a square, as all that follow
    static void suffix_roulette(Tile& t) {
        of_groups([&](uint32_t first, uint32_t which) { path_suffix_roulette(&t.par, &t.paths, first, which); });
    }
    static void transmittance(Tile& t, const uint32_t* which, uint32_t n) {
        for (uint32_t i = 0; i < n; i++)
            connection_transmittance(t.s, &t.par, &t.paths, which[i] / REUSE_GROUP, which[i] % REUSE_GROUP);
    }
    static void connect(Tile& t) {
        of_groups([&](uint32_t first, uint32_t which) { path_connect(t.s, &t.par, &t.paths, first, which); });
    }
    static void normalise_mis(Tile& t) {
        for (uint32_t i = 0; i < t.n; i++) path_normalise_mis(&t.paths, t.now[i]);
    }
    static void gather(Tile& t) {
        of_groups([&](uint32_t first, uint32_t which) { path_gather(&t.paths, first, which); });
    }
};
#endif
