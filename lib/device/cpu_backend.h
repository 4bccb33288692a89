// SPDX-License-Identifier: BSD-3-Clause
// A tile as a backend of wavefront.h.  STAGES: how a stage runs over a queue (OneByOne, InLanes).  Included by
// cpu_kernels.inl.
#ifndef LUX_CPU_BACKEND_H
#define LUX_CPU_BACKEND_H

// The first hit of ray i of a traced packet, as trace_closest() finds it.
FN Hit packet_hit(const SceneTables& s, Packet& p, uint32_t i, uint32_t mask) {
    Hit hit = p.look[i].hit;
    const Ray ray = packet_whole_ray(p, i);
    if (may_coincide(&p.look[i])) resolve_coincident_hits(&s, &ray, mask, 1, &p.look[i], &hit);
    return hit;
}

// First hits: rays that lie side by side in packets, others alone.  Neighbours stay neighbours behind panes and in
// mirrors.
static void extend_paths(Tile& t) {
    Packet p;
    uint32_t of[PACKET];
    for (uint32_t i = 0; i < t.n;) {
        for (p.count = 0; i < t.n && p.count < PACKET; i++) {
            const uint32_t path = t.now[i], flags = info_flags(t.paths.info[path]);
            if (path_steps(flags) == 0 ? !t.together : path_sampled(flags) != 0) {
                path_extend(t.s, &t.par, &t.paths, path);
                continue;
            }
            of[p.count] = path;
            packet_put(p, p.count++, path_ray(&t.paths, path));
        }
        packet_trace(*t.s, p, RAY_ALL);
        for (uint32_t k = 0; k < p.count; k++) {
            const Hit hit = packet_hit(*t.s, p, k, RAY_ALL);
            set_path_hit(&t.paths, of[k], &hit);
        }
    }
}

// t.result: whether opaque surfaces block the shadow rays, where packets can tell.
static void block_together(Tile& t) {
    PacketRays p;
    uint32_t of[PACKET], panes;
    for (uint32_t i = 0; i < t.shadows;) {
        for (p.count = 0; i < t.shadows && p.count < PACKET; i++) {
            Ray ray;
            if (!shadow_is_plain(t.s, &t.par, &t.paths, t.shadow[i], &ray)) continue;
            of[p.count] = i;
            packet_put(p, p.count++, ray);
        }
        const uint32_t open = packet_look(*t.s, p, packet_all(p), RAY_OPAQUE, &panes);
        for (uint32_t k = 0; k < p.count; k++) t.result[of[k]] = (open >> k & 1u) != 0 ? SHADOW_OPEN : SHADOW_BLOCKED;
    }
}

template <class STAGES>
struct TileBackend {
    Tile& t;

    void generate() {
        STAGES::generate(t);
        t.n = 0;
        for (uint32_t i = 0; i < t.par.path_count; i++)
            if (t.result[i] != 0) t.now[t.n++] = i;
        t.together = t.par.mode != MODE_RAY && !begins_on_surface();
    }
    bool begins_on_surface() const { return (t.par.flags & (PF_EYE_ON_SURFACE | PF_SENSORS)) != 0; }
    bool has_paths() const { return t.n > 0; }
    void extend() { extend_paths(t); }
    void shade() {
        STAGES::shade(t);
        t.goes_on = t.shadows = 0;
        for (uint32_t i = 0; i < t.n; i++) {
            if (t.result[i] & PATH_CONTINUES) t.next[t.goes_on++] = t.now[i];
            if (t.result[i] & PATH_SHADOW) t.shadow[t.shadows++] = t.now[i];
        }
    }
    void shadow() {
        for (uint32_t i = 0; i < t.shadows; i++) t.result[i] = SHADOW_TO_TRACE;
        block_together(t);
        STAGES::shadow(t);
    }
    void next_bounce() {
        uint32_t* now = t.now;
        t.now = t.next, t.next = now, t.n = t.goes_on;
    }

    // Square by square: the state of one stays in the cache.
    template <class F>
    void in_reuse_parts(F&& reuse) {
        for (uint32_t first = 0; first < t.par.path_count; first += REUSE_SQUARE) {
            Tile square = square_of(t, first);
            TileBackend part{square};
            reuse(part);
        }
    }
    void begin_round(uint32_t turn) { t.par.reuse_turn = turn; }
    void suffix_roulette() { STAGES::suffix_roulette(t); }
    // The queue becomes the paths whose suffix vertex is connected, group by group.
    void see_connections() {
        t.n = 0;
        of_groups([&](uint32_t first, uint32_t which) {
            const uint32_t path = REUSE_MEMBER(first, which);
            if (CONNECTS_SUFFIX(&t.paths, path)) t.now[t.n++] = path;
        });
        know_connections(t);
    }
    // The connections that may lead through panes: a row of their own, because few suffix vertices have some.
    void attenuate_connections() {
        uint32_t connections[REUSE_SQUARE * REUSE_GROUP], count = 0;
        for (uint32_t i = 0; i < t.n; i++) {
            const uint32_t path = t.now[i];
            uint32_t left =
                connections_to_attenuate(t.paths.connections[path], REUSE_FINDER(&t.par, reuse_which(path)));
            for (; left != 0; left &= left - 1)
                connections[count++] = path * REUSE_GROUP + uint32_t(__builtin_ctz(left));
        }
        STAGES::transmittance(t, connections, count);
    }
    void connect() { STAGES::connect(t); }
    void normalise_mis() { STAGES::normalise_mis(t); }
    void gather() { STAGES::gather(t); }

    void begin_pilots(const device::PilotRay* rays) {
        t.n = 0;
        t.together = rays[0].length == PILOT_FROM_EYE && !begins_on_surface();
        for (uint32_t i = 0; i < t.par.path_count; i++) {
            const device::PilotRay& ray = rays[i];
            t.paths.org[i] = org_words(F3(ray.org[0], ray.org[1], ray.org[2]), 0u);
            t.paths.dir[i] = dir_words(F3(ray.dir[0], ray.dir[1], ray.dir[2]), ray.length);
            if (path_begin_pilot(t.s, &t.par, &t.paths, i)) t.now[t.n++] = i;
        }
    }
};
#endif
