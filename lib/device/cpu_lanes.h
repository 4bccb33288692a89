// SPDX-License-Identifier: BSD-3-Clause
// The stages of many paths side by side, which ispc has compiled (kernels/lanes.ispc), and what these leave to the
// kernels of one path (kernels/lanes_calls.isph).  Included by cpu_kernels.inl, where LANE_CALL gives their names.
#ifndef LUX_CPU_LANES_H
#define LUX_CPU_LANES_H

#ifdef _WIN32
#define LANE_ABI __attribute__((sysv_abi))  // ispc compiles for Linux (CMakeLists.txt)
#else
#define LANE_ABI
#endif

extern "C" {
LANE_ABI void LANE_CALL(layout)(uint32_t* sizes);
LANE_ABI void LANE_CALL(generate)(const SceneTables* s, const Params* par, const Paths* paths, uint32_t n, int* result);
LANE_ABI void LANE_CALL(shade)(const SceneTables* s, const Params* par, const Paths* paths, const uint32_t* queue,
                               uint32_t n, int* result);
LANE_ABI void LANE_CALL(shadow)(const SceneTables* s, const Params* par, const Paths* paths, const uint32_t* queue,
                                uint32_t n, const int* known);
LANE_ABI void LANE_CALL(suffix_roulette)(const Params* par, const Paths* paths);
LANE_ABI void LANE_CALL(transmittance)(const SceneTables* s, const Params* par, const Paths* paths,
                                       const uint32_t* connections, uint32_t n);
LANE_ABI void LANE_CALL(connect)(const SceneTables* s, const Params* par, const Paths* paths);
LANE_ABI void LANE_CALL(normalise_mis)(const Paths* paths, const uint32_t* queue, uint32_t n);
LANE_ABI void LANE_CALL(gather)(const Paths* paths);

LANE_ABI void LANE_CALL(closest)(const SceneTables* s, const float* rays, uint32_t lanes, uint32_t on, uint32_t mask,
                                 float* hits);
LANE_ABI int LANE_CALL(any)(const SceneTables* s, const float* words, uint32_t mask);
LANE_ABI int LANE_CALL(cal)(const SceneTables* s, uint32_t entry, const float* vars, float* out);
}

static Ray lane_ray(const float* words) {
    Ray ray;
    ray.org = F3(words[0], words[1], words[2]);
    ray.dir = F3(words[3], words[4], words[5]);
    ray.tmin = words[6];
    ray.tmax = words[7];
    return ray;
}

// Traces the rays of the lanes that are on.  Word k of lane i stands at k * lanes + i, in rays and in hits.
void LANE_CALL(closest)(const SceneTables* s, const float* rays, uint32_t lanes, uint32_t on, uint32_t mask,
                        float* hits) {
    Packet p;
    uint32_t of[PACKET];
    const auto put = [&](uint32_t lane, const Hit& hit) {
        const float words[] = {hit.t, as_float_(hit.prim), hit.u, hit.v, as_float_(hit.inst)};
        for (uint32_t k = 0; k < 5; k++) hits[k * lanes + lane] = words[k];
    };
    for (uint32_t left = on; left != 0; left &= left - 1) {
        const uint32_t lane = uint32_t(__builtin_ctz(left));
        float words[8];
        for (uint32_t k = 0; k < 8; k++) words[k] = rays[k * lanes + lane];
        const Ray ray = lane_ray(words);
        if (p.count == 0) p.tmin = ray.tmin;
        if (ray.tmin == p.tmin) {  // a packet has one
            of[p.count] = lane;
            packet_put(p, p.count++, ray);
        } else {
            Hit hit;
            trace_closest(s, &ray, mask, &hit);
            put(lane, hit);
        }
    }
    packet_trace(*s, p, mask);
    for (uint32_t k = 0; k < p.count; k++) put(of[k], packet_hit(*s, p, k, mask));
}

int LANE_CALL(any)(const SceneTables* s, const float* words, uint32_t mask) {
    const Ray ray = lane_ray(words);
    return trace_any(s, &ray, mask);
}

int LANE_CALL(cal)(const SceneTables* s, uint32_t entry, const float* vars, float* out) {
    return cal_run(s, entry, vars, out);
}

// Puts paths that have met the same material side by side, those that have met nothing first: the lanes of a group then
// take the same branches.  A counting sort; the queues of what comes after shading are still free, and hold the kinds
// and the sorted paths.
static void sort_by_material(Tile& t) {
    uint32_t place[PATH_KINDS + 1] = {};
    for (uint32_t i = 0; i < t.n; i++) {
        t.next[i] = path_kind(t.s, &t.paths, t.now[i]);
        place[t.next[i] + 1u]++;
    }
    for (uint32_t k = 1; k < PATH_KINDS; k++) place[k] += place[k - 1];
    for (uint32_t i = 0; i < t.n; i++) t.shadow[place[t.next[i]]++] = t.now[i];
    uint32_t* swap = t.now;
    t.now = t.shadow;
    t.shadow = swap;
}

struct InLanes {
    static void layout(uint32_t* sizes) { LANE_CALL(layout)(sizes); }
    static void generate(Tile& t) { LANE_CALL(generate)(t.s, &t.par, &t.paths, t.par.path_count, t.result); }
    static void shade(Tile& t) {
        sort_by_material(t);
        LANE_CALL(shade)(t.s, &t.par, &t.paths, t.now, t.n, t.result);
    }
    static void shadow(Tile& t) { LANE_CALL(shadow)(t.s, &t.par, &t.paths, t.shadow, t.shadows, t.result); }
    static void suffix_roulette(Tile& t) { LANE_CALL(suffix_roulette)(&t.par, &t.paths); }
    static void transmittance(Tile& t, const uint32_t* connections, uint32_t n) {
        LANE_CALL(transmittance)(t.s, &t.par, &t.paths, connections, n);
    }
    static void connect(Tile& t) { LANE_CALL(connect)(t.s, &t.par, &t.paths); }
    static void normalise_mis(Tile& t) { LANE_CALL(normalise_mis)(&t.paths, t.now, t.n); }
    static void gather(Tile& t) { LANE_CALL(gather)(&t.paths); }
};
#endif
