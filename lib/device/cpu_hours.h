// SPDX-License-Identifier: BSD-3-Clause
// A tile of paths for many hours (kernels/integrator/hours.h): the suns that each vertex sees, and what the paths get
// from them.  A vertex's rays to suns that follow each other lie side by side in packets.  Included by cpu_kernels.inl.
#ifndef LUX_CPU_HOURS_H
#define LUX_CPU_HOURS_H

// The vertex's answers to the suns of a packet that nothing opaque hides.
static void answer_suns(const Tile& t, const Vertex& vertex, PacketRays& p, const uint32_t* suns, float weight,
                        device::FoundSuns& out) {
    uint32_t panes;
    const bool aims = aims_shadows(&t.par);
    const uint32_t open = aims ? packet_all(p) : packet_look(*t.s, p, packet_all(p), RAY_OPAQUE, &panes);
    for (uint32_t left = open; left != 0; left &= left - 1) {
        const uint32_t k = uint32_t(__builtin_ctz(left));
        float3 own, shared;
        path_sun(t.s, &t.par, &vertex, suns[k], F3(p.dir[0][k], p.dir[1][k], p.dir[2][k]), aims ? SHADOW_TO_TRACE : SHADOW_OPEN, &own, &shared);
        out.add(2 * vertex.path, suns[k], &own.x, weight);
        out.add(2 * vertex.path + 1, suns[k], &shared.x, weight);
    }
    p.count = 0;
}

static void ask_suns(const Tile& t, const Vertex& vertex, device::FoundSuns& out) {
    PacketRays p;
    uint32_t suns[PACKET];
    const SunSampling sampling = sun_sampling(&t.par, &vertex);
    const bool through = lobes_transmit(&vertex.lobes) != 0;
    const float3 above = sun_ray_start(&vertex, 1), below = sun_ray_start(&vertex, 0);
    // in its path's own light the suns count by the weight of its list: those of a suffix vertex for its group
    const AskedSuns asked = asked_suns(t.s, &t.par, vertex.path);
    for (uint32_t i = 0; i < asked.count; i++) {
        const uint32_t sun = asked_sun(t.s, &asked, i);
        if (!samples_sun(&sampling, &t.s->suns[sun])) continue;
        const float3 way = sun_way(&t.s->suns[sun], sampling.place);
        const bool up = dot3(way, vertex.g.ng) > 0.0f;
        if (!up && !through) continue;
        suns[p.count] = sun;
        packet_put(p, p.count++, {up ? above : below, 0.0f, way, FAR_AWAY});
        if (p.count == PACKET) answer_suns(t, vertex, p, suns, float(sampling.step), out);
    }
    if (p.count > 0) answer_suns(t, vertex, p, suns, float(sampling.step), out);
}

template <class STAGES>
struct HoursBackend : TileBackend<STAGES> {
    using Base = TileBackend<STAGES>;
    device::FoundSuns found;
    explicit HoursBackend(Tile& tile) : Base{tile} {}
    void shade() {
        Vertex vertex;
        const Tile& t = Base::t;
        for (uint32_t i = 0; i < t.n; i++)
            if (sun_vertex(t.s, &t.par, &t.paths, t.now[i], &vertex)) ask_suns(t, vertex, found);
        Base::shade();
    }
};

static void keep_skies(const Tile& t, device::HourPaths& out) {
    for (uint32_t i = 0; i < t.par.path_count; i++) {
        const Row_sky_way way = sky_way_of(t.paths.sky_way[i]);
        const float3 rgb = way.kind == SKY_NONE ? F3(0.0f, 0.0f, 0.0f) : xyz4(t.paths.sky_share[i]);
        out.sky.push_back({{way.dir.x, way.dir.y, way.dir.z}, {rgb.x, rgb.y, rgb.z}, way.kind});
    }
}

static void keep_shares(const Tile& t, device::HourPaths& out) {
    if (t.par.reuse_path_count == 0) return;
    out.shares.resize(size_t(t.par.path_count) * REUSE_GROUP * 3);
    for (uint32_t path = 0; path < t.par.path_count; path++)
        for (uint32_t m = 0; m < REUSE_GROUP; m++)
            put3(path_share_of_suffix(&t.paths, reuse_first(path), m, reuse_which(path)),
                 &out.shares[3 * (size_t(path) * REUSE_GROUP + m)]);
}
#endif
