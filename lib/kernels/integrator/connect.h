// SPDX-License-Identifier: BSD-3-Clause
// Far ends light the prefix vertices of their group: each pixel's diffuse light is estimated from all directions that
// its group has found, as far as they are in its view (Bekaert, Sbert and Halton 2002, "Accelerating Path Tracing by
// Re-Using Paths"), weighted by the balance heuristic (Veach 1997, section 9.2): over the sum of the densities with
// which each member would have found that end.  The expectation is that of the paths alone.
#ifndef LUX_PATH_CONNECT_H
#define LUX_PATH_CONNECT_H

#define CERTAIN_IMPORTANCE \
    2.0f  // times what the suffix vertices of a group bring on average: those that bring so much are sure to

// A prefix vertex, as links to it are made.
STRUCT(NearEnd) {
    float3 p, n, ng;
    float own;  // factor of its own ray, or NO_PREFIX
    Aims aims;
};

FN NearEnd prefix_vertex(TABLES(const Paths) paths, uint slot) {
    float4 p = read4_(paths->prefix_p, slot), n = read4_(paths->prefix_n, slot), ng = read4_(paths->prefix_ng, slot);
    NearEnd near;
    near.p = xyz4(p);
    near.n = xyz4(n);
    near.ng = xyz4(ng);
    near.own = n.w;
    near.aims.light = p.w;
    near.aims.highlights = as_uint_(ng.w);
    return near;
}

// From a prefix vertex to a suffix vertex.
STRUCT(Link) {
    Ray ray;
    float3 dir;      // toward the suffix vertex
    float cosine;    // over the prefix vertex
    float per_area;  // cosine at the suffix vertex over squared distance; 1 if that is a direction
};

// far: its slot.  0: one does not face the other.
FN int connection_ends(TABLES(const Paths) paths, PRIVATE(const NearEnd) near, uint far, PRIVATE(Link) link) {
    float4 to = paths->suffix_p[far];
    if (near->own == NO_PREFIX) return 0;
    link->ray.org = near->p;
    link->ray.tmin = 0.0f;

    if (to.w == SUFFIX_DIRECTION) {
        link->dir = xyz4(to);
        link->per_area = 1.0f;
        link->ray.dir = link->dir;
        link->ray.tmax = FAR_AWAY;
    } else {
        float4 suffix_n = paths->suffix_n[far];
        float3 way = sub3(xyz4(to), near->p);
        float d2 = dot3(way, way);
        link->dir = scale3(way, 1.0f / sqrt_(d2));
        float facing = -dot3(link->dir, xyz4(suffix_n));
        if (!(facing > 0.0f)) return 0;
        link->per_area = facing / d2;

        // up to a point just before the suffix vertex's surface, where its own next ray begins
        float3 open = sub3(offset_ray(xyz4(to), xyz4(suffix_n), suffix_n.w), near->p);
        link->ray.tmax = length3(open);
        link->ray.dir = scale3(open, 1.0f / link->ray.tmax);
    }

    link->cosine = dot3(link->dir, near->n);
    return link->cosine > 0.0f && dot3(link->dir, near->ng) > 0.0f;
}

// What a slot's own suffix vertex brings to its own prefix vertex, if that reflected all.
FN float suffix_importance(float4 prefix_n, float4 suffix_p, float4 suffix_rad) {
    if (suffix_p.w == SUFFIX_NONE || !(prefix_n.w > 0.0f)) return 0.0f;
    return (fabs_(suffix_rad.x) + fabs_(suffix_rad.y) + fabs_(suffix_rad.z)) * prefix_n.w;
}

// Far ends that bring less are linked by chance only (Russian roulette), and then count for more: most are dim, and the
// links take the time.  Sets the chance of that of member `which` of a group (REUSE_FIRST); 0: it is not linked.
FN void path_suffix_roulette(TABLES(const Paths) paths, UNIFORM uint first, uint which) {
    uint slot = REUSE_MEMBER(first, which);
    float4 prefix_n = read4_(paths->prefix_n, slot), suffix_p = read4_(paths->suffix_p, slot);
    float worth = suffix_importance(prefix_n, suffix_p, read4_(paths->suffix_rad, slot)), chance = 0.0f, all = 0.0f;
    if (worth > 0.0f) {
        for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
            UNIFORM uint far = REUSE_MEMBER(first, m);
            all += suffix_importance(paths->prefix_n[far], paths->suffix_p[far], paths->suffix_rad[far]);
        }
        chance = MIN_(worth / (CERTAIN_IMPORTANCE / (float)REUSE_GROUP * all), 1.0f);
        Sampler rnd = path_sampler(read4_(paths->info, slot));
        rnd.key = hash32(rnd.key ^ 0x2545f491u);
        if (!(sample1(&rnd) < chance)) chance = 0.0f;
    }
    paths->prefix_thr[slot].w = chance;
}

// Is the suffix vertex of a slot linked?
#define HAS_PREFIX(paths, slot) ((paths)->prefix_thr[slot].w > 0.0f)

// What is known of the links to a suffix vertex, two bits a member of the group: nothing lies in the way of member m
// (bit m); nothing opaque does (bit 16 + m, not set where nothing at all does).
FN uint connections_known(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint slot) {
    uint known = 0u;
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
        Link link;
        NearEnd near = prefix_vertex(paths, reuse_member(slot, m));
        if (!connection_ends(paths, &near, slot, &link)) continue;
        if (!trace_any(s, &link.ray, RAY_ALL)) known |= 1u << m;
        else if (par->shadow_mode != SHADOW_OPAQUE && !trace_any(s, &link.ray, RAY_OPAQUE)) known |= 65536u << m;
    }
    return known;
}

// Is there a plain pane at g, for a diffuse ray?  The random numbers of mixtures do not matter: such are no panes.
FN int connection_pane(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g,
                       PRIVATE(Lobes) lobes) {
    Sampler rnd = sampler_start(0u, 0u, 0u, 0u, 0u);
    Medium open = medium_open(par), beyond = medium_open(par);
    if (!find_material(s, par, g, &rnd) || take_alternate(s, par, g, PC_DIFFUSE, &rnd)) return 0;
    if (!is_pane(s, par, g)) return 0;
    material_lobes(s, par, g, LOBES_SAMPLED, &rnd, &open, &beyond, lobes);
    return (lobes->flags & LOBE_PASS) == 0u;
}

// What panes let through along a ray, and the chance that a path goes on through them; 0: something else is in the way.
FN int connection_panes(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Ray) ray, PRIVATE(float3) T,
                        PRIVATE(float) chance) {
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes lobes;
        trace_closest(s, ray, RAY_TRANSPARENT, &hit);
        if (hit.prim == NO_HIT) return 1;
        surface_at(s, ray, &hit, &g);
        g.total = hit.t;
        if (!connection_pane(s, par, &g, &lobes)) return 0;
        *T = mul3(*T, lobes.through);
        *chance *= pane_chance(&lobes);

        ray->org = offset_ray(g.p, neg3(g.ng), g.reach);
        if (!IS_DISTANT(ray->tmax)) ray->tmax -= hit.t;
        if (ray->tmax <= 0.0f) return 1;
    }

    return 0;
}

// The members whose links to the suffix vertex of a slot may lead through panes, a bit each: where nothing opaque lies
// in the way, and its own, along which its path went.
FN uint connections_to_attenuate(uint known, uint own) {
    return (known >> REUSE_GROUP | 1u << own) & ~known & ((1u << REUSE_GROUP) - 1u);
}

// Looks along such a link: what the panes let through; w: the chance that a path goes on through them, below 0 if
// something else is in the way.
FN void path_transmittance(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint slot,
                           uint m) {
    Link link;
    NearEnd near = prefix_vertex(paths, reuse_member(slot, m));
    float3 T = F3(1.0f, 1.0f, 1.0f);
    float chance = 1.0f;
    if (!connection_ends(paths, &near, slot, &link) || !connection_panes(s, par, &link.ray, &T, &chance))
        chance = -1.0f;
    if (!(chance > 0.0f)) chance = -1.0f;  // no path comes through: a pattern may make a pane black, or less than that
    paths->panes[slot].of[m] = pack4(T, chance);
}

// The links of the prefix vertex of member `which` of a group to all its suffix vertices: with which density it would
// have found them, and what they are worth to it.  What is known of them is in `links`; those that may lead through
// panes have been looked through.
FN void path_connect(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                     UNIFORM uint first, uint which) {
    NearEnd near = prefix_vertex(paths, REUSE_MEMBER(first, which));
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
        UNIFORM uint far = REUSE_MEMBER(first, m);
        if (!HAS_PREFIX(paths, far)) continue;
        uint open = paths->links[far];
        uint panes = connections_to_attenuate(open, m);
        float density = 0.0f, contribution = 0.0f, through = 1.0f;
        if ((panes >> which & 1u) != 0u) through = paths->panes[far].of[which].w;

        Link link;
        if (((open | panes) >> which & 1u) != 0u && !(through < 0.0f) && connection_ends(paths, &near, far, &link)) {
            if (which == m) density = link.cosine * K_INV_PI / near.own;
            else density = diffuse_density(s, par, &near.aims, near.p, near.n, link.dir);
            density = density * link.per_area * through;
            contribution = link.cosine * K_INV_PI * link.per_area;
        }
        paths->density[far].of[which] = density;
        paths->contribution[far].of[which] = contribution;
    }
}

// Divides what the suffix vertex of a slot sends out by the sum of those densities.
FN void path_normalise_mis(TABLES(const Paths) paths, uint slot) {
    float densities = 0.0f;
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) densities += paths->density[slot].of[m];
    float4 radiance = read4_(paths->suffix_rad, slot);
    float each = densities > 0.0f ? 1.0f / (densities * paths->prefix_thr[slot].w) : 0.0f;
    write4_(paths->suffix_rad, slot, pack4(scale3(xyz4(radiance), each), radiance.w));
}

// Adds to member `which` of a group what all suffix vertices of the group bring to its prefix vertex.
FN void path_gather(TABLES(const Paths) paths, UNIFORM uint first, uint which) {
    uint slot = REUSE_MEMBER(first, which);
    if (paths->prefix_n[slot].w == NO_PREFIX) return;
    float3 sum = F3(0.0f, 0.0f, 0.0f);
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
        UNIFORM uint far = REUSE_MEMBER(first, m);
        if (!HAS_PREFIX(paths, far)) continue;
        float3 T = F3(1.0f, 1.0f, 1.0f);
        if ((connections_to_attenuate(paths->links[far], m) >> which & 1u) != 0u) T = xyz4(paths->panes[far].of[which]);
        sum = add3(sum, mul3(scale3(T, paths->contribution[far].of[which]), xyz4(paths->suffix_rad[far])));
    }

    float4 rad = read4_(paths->rad, slot);
    write4_(paths->rad, slot, pack4(add3(xyz4(rad), mul3(xyz4(read4_(paths->prefix_thr, slot)), sum)), rad.w));
}
#endif
