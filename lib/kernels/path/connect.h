// SPDX-License-Identifier: BSD-3-Clause
// Far ends light the near ends of their group: each pixel's diffuse light is estimated from all directions that its
// group has found, as far as they are in its view (Bekaert, Sbert and Halton 2002, "Accelerating Path Tracing by
// Re-Using Paths"), weighted by the balance heuristic (Veach 1997, section 9.2): over the sum of the densities with
// which each member would have found that end.  The expectation is that of the paths alone.
#ifndef LUX_PATH_CONNECT_H
#define LUX_PATH_CONNECT_H

#define FAR_ENOUGH 2.0f  // times what the far ends of a group bring on average: those that bring so much are sure to

// From a near end to a far end.
STRUCT(Link) {
    Ray ray;
    float3 dir;      // toward the far end
    float cosine;    // over the near end
    float per_area;  // cosine at the far end over squared distance; 1 if that is a direction
};

// 0: one does not face the other.
FN int link_ends(SHARED(const Paths) paths, uint near, uint far, PRIVATE(Link) link) {
    float4 p = paths->near_p[near], n = paths->near_n[near], ng = paths->near_ng[near], to = paths->far_p[far];
    if (n.w == NO_NEAR_END) return 0;
    float3 from = xyz4(p);
    link->ray.org = from;
    link->ray.tmin = 0.0f;

    if (to.w == FAR_DIRECTION) {
        link->dir = xyz4(to);
        link->per_area = 1.0f;
        link->ray.dir = link->dir;
        link->ray.tmax = FAR_AWAY;
    } else {
        float4 far_n = paths->far_n[far];
        float3 way = sub3(xyz4(to), from);
        float d2 = dot3(way, way);
        link->dir = scale3(way, 1.0f / sqrt_(d2));
        float facing = -dot3(link->dir, xyz4(far_n));
        if (!(facing > 0.0f)) return 0;
        link->per_area = facing / d2;

        // up to a point just before the far end's surface, where its own next ray begins
        float3 open = sub3(offset_ray(xyz4(to), xyz4(far_n), far_n.w), from);
        link->ray.tmax = length3(open);
        link->ray.dir = scale3(open, 1.0f / link->ray.tmax);
    }

    link->cosine = dot3(link->dir, xyz4(n));
    return link->cosine > 0.0f && dot3(link->dir, xyz4(ng)) > 0.0f;
}

// What a slot's own far end brings to its own near end, if that reflected all.
FN float far_worth(SHARED(const Paths) paths, uint slot) {
    float4 n = paths->near_n[slot];
    if (paths->far_p[slot].w == FAR_NOTHING || !(n.w > 0.0f)) return 0.0f;
    float3 radiance = xyz4(paths->far_rad[slot]);
    return (fabs_(radiance.x) + fabs_(radiance.y) + fabs_(radiance.z)) * n.w;
}

// Far ends that bring less are linked by chance only (Russian roulette), and then count for more: most are dim, and the
// links take the time.  Sets the chance of a slot's; 0: it is not linked.
FN int path_thin(SHARED(const Paths) paths, uint slot) {
    float all = 0.0f, worth = far_worth(paths, slot), chance = 0.0f;
    if (worth > 0.0f) {
        for (SAME uint m = 0u; m < SHARE_GROUP; m++) all += far_worth(paths, share_member(slot, m));
        chance = MIN_(worth / (FAR_ENOUGH / (float)SHARE_GROUP * all), 1.0f);
        Sampler rnd = path_sampler(paths->info[slot]);
        rnd.key = hash32(rnd.key ^ 0x2545f491u);
        if (!(sample1(&rnd) < chance)) chance = 0.0f;
    }
    paths->near_thr[slot].w = chance;
    return chance > 0.0f;
}

// Is the far end of a slot linked?
FN int has_far_end(SHARED(const Paths) paths, uint slot) { return paths->near_thr[slot].w > 0.0f; }

// What is known of the links to a far end, two bits a member of the group: nothing lies in the way of member m (bit m);
// nothing opaque does (bit 16 + m, not set where nothing at all does).
FN uint links_known(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot) {
    uint known = 0u;
    for (SAME uint m = 0u; m < SHARE_GROUP; m++) {
        Link link;
        if (!link_ends(paths, share_member(slot, m), slot, &link)) continue;
        if (!trace_any(s, &link.ray, RAY_ALL)) known |= 1u << m;
        else if (par->shadow_mode != SHADOW_OPAQUE && !trace_any(s, &link.ray, RAY_OPAQUE)) known |= 65536u << m;
    }
    return known;
}

// Is there a plain pane at g, for a diffuse ray?  The random numbers of mixtures do not matter: such are no panes.
FN int link_pane(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Surface) g, PRIVATE(Lobes) lobes) {
    Sampler rnd = sampler_start(0u, 0u, 0u, 0u, 0u);
    Medium open = medium_open(par), beyond = medium_open(par);
    if (!find_material(s, par, g, &rnd) || take_alternate(s, par, g, PC_DIFFUSE, &rnd)) return 0;
    if (!is_pane(g)) return 0;
    material_lobes(s, par, g, LOBES_SAMPLED, &rnd, &open, &beyond, lobes);
    return (lobes->flags & LOBE_PASS) == 0u;
}

// What panes let through along a ray, and the chance that a path goes on through them; 0: something else is in the way.
FN int link_panes(SHARED(const SceneTables) s, UNIFORM(const Params) par, PRIVATE(Ray) ray, PRIVATE(float3) T,
                  PRIVATE(float) chance) {
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes lobes;
        trace_closest(s, ray, RAY_TRANSPARENT, &hit);
        if (hit.prim == NO_HIT) return 1;
        surface_at(s, ray, &hit, &g);
        g.total = hit.t;
        if (!link_pane(s, par, &g, &lobes)) return 0;
        *T = mul3(*T, lobes.through);
        *chance *= pane_chance(&lobes);

        ray->org = offset_ray(g.p, neg3(g.ng), g.reach);
        if (!IS_FAR(ray->tmax)) ray->tmax -= hit.t;
        if (ray->tmax <= 0.0f) return 1;
    }

    return 0;
}

// The members whose links to the far end of a slot may lead through panes, a bit each: where nothing opaque lies in the
// way, and its own, along which its path went.
FN uint links_to_look_through(uint slot, uint known) {
    return (known >> SHARE_GROUP | 1u << share_which(slot)) & ~known & ((1u << SHARE_GROUP) - 1u);
}

// Looks along such a link.  Its gift becomes what the panes let through; w: the chance that a path goes on through
// them, below 0 if something else is in the way.
FN void path_look_through(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot,
                          uint m) {
    Link link;
    float3 T = F3(1.0f, 1.0f, 1.0f);
    float chance = 1.0f;
    if (!link_ends(paths, share_member(slot, m), slot, &link) || !link_panes(s, par, &link.ray, &T, &chance))
        chance = -1.0f;
    paths->gifts[slot].to[m] = pack4(T, chance);
}

// What the far end of a slot brings to each of its group: its gifts times its radiance, which is divided by the sum of
// the densities.  known: links_known() of it; those that may lead through panes have been looked through.
FN void path_connect(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot,
                     uint known) {
    uint own = share_which(slot), panes = links_to_look_through(slot, known);
    float densities = 0.0f;

    for (SAME uint m = 0u; m < SHARE_GROUP; m++) {
        Link link;
        uint near = share_member(slot, m);
        float4 through = pack4(F3(1.0f, 1.0f, 1.0f), 1.0f);
        if ((panes >> m & 1u) != 0u) through = paths->gifts[slot].to[m];
        paths->gifts[slot].to[m] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);
        if (((known | panes) >> m & 1u) == 0u || through.w < 0.0f) continue;
        if (!link_ends(paths, near, slot, &link)) continue;

        float density;
        if (m == own) {
            density = link.cosine * K_INV_PI / paths->near_n[near].w;
        } else {
            Aims aims;
            aims.light = paths->near_p[near].w;
            aims.highlights = as_uint_(paths->near_ng[near].w);
            density = diffuse_density(s, par, &aims, xyz4(paths->near_p[near]), xyz4(paths->near_n[near]), link.dir);
        }
        densities += density * link.per_area * through.w;
        paths->gifts[slot].to[m] = pack4(scale3(xyz4(through), link.cosine * K_INV_PI * link.per_area), 0.0f);
    }

    float4 radiance = paths->far_rad[slot];
    float each = densities > 0.0f ? 1.0f / (densities * paths->near_thr[slot].w) : 0.0f;
    paths->far_rad[slot] = pack4(scale3(xyz4(radiance), each), radiance.w);
}

// Adds to a slot what all far ends of its group bring to its near end.
FN void path_collect(SHARED(const Paths) paths, uint slot) {
    if (paths->near_n[slot].w == NO_NEAR_END) return;
    uint own = share_which(slot);
    float3 sum = F3(0.0f, 0.0f, 0.0f);
    for (SAME uint m = 0u; m < SHARE_GROUP; m++) {
        uint from = share_member(slot, m);
        if (has_far_end(paths, from))
            sum = add3(sum, mul3(xyz4(paths->gifts[from].to[own]), xyz4(paths->far_rad[from])));
    }

    float4 rad = paths->rad[slot];
    paths->rad[slot] = pack4(add3(xyz4(rad), mul3(xyz4(paths->near_thr[slot]), sum)), rad.w);
}
#endif
