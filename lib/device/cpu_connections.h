// SPDX-License-Identifier: BSD-3-Clause
// Visibility of the connections from a group's prefix vertices to a suffix vertex (kernels/integrator/connect.h):
// the rays to a suffix vertex are made side by side, step by step as connection_ends() makes one, and those of one kind
// go through the tree as a packet. Included by cpu_kernels.inl.
#ifndef LUX_CPU_CONNECTIONS_H
#define LUX_CPU_CONNECTIONS_H

static_assert(REUSE_GROUP <= PACKET, "the connections of a suffix vertex fill one packet");

// The prefix vertices of a group, side by side.
struct PrefixVertices {
    float p[3][REUSE_GROUP], n[3][REUSE_GROUP], ng[3][REUSE_GROUP];
    uint32_t there;  // a bit each
};

FN void put_lane(float (*to)[REUSE_GROUP], uint32_t m, float4 v) {
    to[0][m] = v.x;
    to[1][m] = v.y;
    to[2][m] = v.z;
}

// Gathers the prefix vertices of the group of a path.
FN void prefix_vertices(const Paths& paths, uint32_t path, PrefixVertices& near) {
    near.there = 0;
    for (uint32_t m = 0; m < REUSE_GROUP; m++) {
        const uint32_t member = reuse_member(path, m);
        put_lane(near.p, m, paths.prefix_p[member]);
        put_lane(near.n, m, paths.prefix_n[member]);
        put_lane(near.ng, m, paths.prefix_ng[member]);
        near.there |= (prefix_n_own(paths.prefix_n[member]) != NO_PREFIX ? 1u : 0u) << m;
    }
}

FN float3 lane3(const float (*from)[REUSE_GROUP], uint32_t m) { return F3(from[0][m], from[1][m], from[2][m]); }

// Rays from the prefix vertices to the suffix vertex of a path.  Returns the vertices that face it, a bit each.
FN uint32_t connection_rays(const Paths& paths, const PrefixVertices& near, uint32_t far, PacketRays& p) {
    const Row_suffix_p to = suffix_p_of(paths.suffix_p[far]);
    const Row_suffix_n there = suffix_n_of(paths.suffix_n[far]);
    const int distant = to.kind == SUFFIX_DIRECTION;
    const float3 end = to.place, n = there.normal, before = offset_ray(end, n, there.rounding);
    int faces[REUSE_GROUP];
    for (uint32_t m = 0; m < REUSE_GROUP; m++) {
        const float3 from = lane3(near.p, m), way = sub3(end, from), open = sub3(before, from);
        const float distance = length3(open);
        const float3 toward = distant ? end : scale3(way, 1.0f / sqrt_(dot3(way, way)));
        const float3 dir = distant ? end : scale3(open, 1.0f / distance);
        packet_put(p, m, {from, p.tmin, dir, distant ? FAR_AWAY : distance});
        const int faced = distant | int(-dot3(toward, n) > 0.0f), up = dot3(toward, lane3(near.n, m)) > 0.0f;
        faces[m] = faced & up & int(dot3(toward, lane3(near.ng, m)) > 0.0f);
    }
    uint32_t facing = 0;
    for (uint32_t m = 0; m < REUSE_GROUP; m++) facing |= uint32_t(faces[m]) << m;
    return facing & near.there;
}

// Sets what is known of the connections of each path of the queue, as connections_known() says.
FN void know_connections(Tile& t) {
    PacketRays p;
    PrefixVertices near;
    p.count = REUSE_GROUP;
    for (uint32_t i = 0; i < t.n; i++) {
        const uint32_t path = t.now[i];
        if (i == 0 || reuse_first(path) != reuse_first(t.now[i - 1]))
            prefix_vertices(t.paths, REUSE_MET(&t.par, path), near);
        uint32_t through = 0;
        const uint32_t facing = connection_rays(t.paths, near, path, p);
        const uint32_t open = packet_look(*t.s, p, facing, RAY_ALL, &through) & ~through;
        if (t.par.shadow_mode == SHADOW_OPAQUE) through = 0;
        t.paths.connections[path] = open | through << REUSE_GROUP;
    }
}
#endif
