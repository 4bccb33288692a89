// SPDX-License-Identifier: BSD-3-Clause
// A tile of paths for many hours (kernels/integrator/hours.h): the suns that each vertex sees, and what the paths get
// from them.  A vertex's rays to suns that follow each other lie side by side in packets.  Included by cpu_kernels.inl.
#ifndef LUX_CPU_HOURS_H
#define LUX_CPU_HOURS_H

// Rays from vertices to suns, and what they are for.
struct SunRays {
    PacketRays p;
    const Vertex* from[PACKET];
    uint32_t sun[PACKET];
    float weight[PACKET];
};

// The answers of the vertices to the suns that nothing opaque hides.
static void answer_suns(const Tile& t, SunRays& rays, device::FoundSuns& out) {
    uint32_t panes;
    const bool aims = aims_shadows(&t.par);
    const uint32_t all = packet_all(rays.p), open = aims ? all : packet_look(*t.s, rays.p, all, RAY_OPAQUE, &panes);
    for (uint32_t left = open; left != 0; left &= left - 1) {
        const uint32_t k = uint32_t(__builtin_ctz(left)), list = 2 * rays.from[k]->path;
        const float3 way = F3(rays.p.dir[0][k], rays.p.dir[1][k], rays.p.dir[2][k]);
        float3 own, shared;
        path_sun(t.s, &t.par, rays.from[k], rays.sun[k], way, aims ? SHADOW_TO_TRACE : SHADOW_OPEN, &own, &shared);
        out.add(list, rays.sun[k], &own.x, rays.weight[k]);
        out.add(list + 1, rays.sun[k], &shared.x, rays.weight[k]);
    }
    rays.p.count = 0;
}

// Vertices that ask the same suns: one, or those of a pixel, whose rays to a sun lie side by side.
struct SunVertices {
    Vertex vertex[PACKET];
    SunSampling sampling[PACKET];
    float3 above[PACKET], below[PACKET];  // where their rays begin
    int through[PACKET];
    uint32_t count = 0;
};

// The middles of the suns, in a list that is shorter than their records.
struct SunCentres {
    std::vector<float3> of;
    float reach = 0.0f;  // from there to the disc's edge, at most
    explicit SunCentres(const Tile& t) {
        for (uint32_t i = 0; i < t.par.suns_count; i++) {
            const Source& sun = t.s->suns[i];
            of.push_back(f3_of(sun.centre));
            reach = std::max(reach, length3(f3_of(sun.u)) + length3(f3_of(sun.v)));
        }
    }
};

static void ask_suns(const Tile& t, const SunCentres& centres, SunVertices& v, device::FoundSuns& out) {
    if (v.count == 0) return;
    const float behind = -1.01f * centres.reach;
    SunRays rays;
    for (uint32_t k = 0; k < v.count; k++) {
        v.sampling[k] = sun_sampling(&t.par, &v.vertex[k]);
        v.above[k] = sun_ray_start(&v.vertex[k], 1);
        v.below[k] = sun_ray_start(&v.vertex[k], 0);
        v.through[k] = lobes_transmit(&v.vertex[k].lobes);
    }
    const AskedSuns asked = asked_suns(t.s, &t.par, v.vertex[0].path);
    for (uint32_t i = 0; i < asked.count; i++) {
        const uint32_t sun = asked_sun(t.s, &asked, i);
        for (uint32_t k = 0; k < v.count; k++) {
            if (!v.through[k] && dot3(centres.of[sun], v.vertex[k].g.ng) < behind) continue;
            if (!samples_sun(&v.sampling[k], &t.s->suns[sun])) continue;
            const float3 way = sun_way(&t.s->suns[sun], v.sampling[k].place);
            const bool up = dot3(way, v.vertex[k].g.ng) > 0.0f;
            if (!up && !v.through[k]) continue;
            const uint32_t ray = rays.p.count++;
            rays.from[ray] = &v.vertex[k], rays.sun[ray] = sun, rays.weight[ray] = float(v.sampling[k].step);
            packet_put(rays.p, ray, {up ? v.above[k] : v.below[k], 0.0f, unit3(way), FAR_AWAY});
            if (rays.p.count == PACKET) answer_suns(t, rays, out);
        }
    }
    if (rays.p.count > 0) answer_suns(t, rays, out);
    v.count = 0;
}

template <class STAGES>
struct HoursBackend : TileBackend<STAGES> {
    using Base = TileBackend<STAGES>;
    const SunCentres centres;
    device::FoundSuns found;
    explicit HoursBackend(Tile& tile) : Base{tile}, centres(tile) {}
    void shade() {
        SunVertices v;
        const Tile& t = Base::t;
        for (uint32_t i = 0; i < t.n; i++) {
            // Vertices of a packet have the suns of one pixel.
            const auto joins = [&] {
                return (t.par.flags & PF_ASKS) != 0u && v.count < PACKET &&
                       focus_entry(t.s, &t.par, v.vertex[0].path) == focus_entry(t.s, &t.par, t.now[i]);
            };
            if (v.count > 0 && !joins()) ask_suns(t, centres, v, found);
            if (sun_vertex(t.s, &t.par, &t.paths, t.now[i], &v.vertex[v.count])) v.count++;
        }
        ask_suns(t, centres, v, found);
        Base::shade();
    }
};

static void keep_skies(const Tile& t, device::HourPaths& out) {
    for (uint32_t i = 0; i < t.par.path_count; i++) {
        const Row_sky_way way = sky_way_of(t.paths.sky_way[i]);
        const float3 rgb = way.kind == SKY_NONE ? F3(0.0f, 0.0f, 0.0f) : xyz4(t.paths.sky_share[i]);
        out.sky.push_back({{way.dir.x, way.dir.y, way.dir.z}, {rgb.x, rgb.y, rgb.z}, way.kind});
        const float3 org = xyz4(t.paths.org[i]);
        out.end.insert(out.end.end(), {org.x, org.y, org.z});
    }
}

// Suffix vertices meet the prefix vertices of their groups, square by square.
template <class BACKEND>
static void keep_shares(BACKEND& backend, device::HourPaths& out) {
    const Params& par = backend.t.par;
    std::vector<float4> found(size_t(par.reuse_rounds) * REUSE_SQUARE * REUSE_GROUP);
    backend.in_reuse_parts([&](auto& square) {
        auto to = found.begin();
        device::meet_suffixes(square, par.reuse_rounds, [&] {
            for (uint32_t path = 0; path < REUSE_SQUARE; path++)
                for (uint32_t m = 0; m < REUSE_GROUP; m++)
                    *to++ = path_share_of_suffix(&square.t.par, &square.t.paths, path, m);
        });
        device::weigh_shares(par.reuse_rounds, found.data(), square.t.paths.suffix_rad, square.t.paths.rad, out);
    });
}
#endif
