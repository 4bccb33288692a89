// SPDX-License-Identifier: BSD-3-Clause
// Shadow rays: what reaches a point from the source sample it chose; and the small sources drawn into frame 0.
#ifndef LUX_PATH_SHADOW_H
#define LUX_PATH_SHADOW_H

// What a shadow ray lets through: straight through glass, smooth trans, mixtures with void (spec shading 4.5).
FN float3 shadow_straight(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 org, float3 dir, float dist,
                          uint source, Medium medium, uint clip, PRIVATE Sampler* rnd) {
    float3 T = F3(1.0f, 1.0f, 1.0f), black = F3(0.0f, 0.0f, 0.0f);
    GLOBAL const float* q = source_record(s, par, source);
    uint kind = as_uint_(q[SRC_KIND]);
    Ray ray;
    ray.org = org;
    ray.dir = dir;
    ray.tmin = 0.0f;
    ray.tmax = IS_FAR(dist) ? FAR_AWAY : shadow_end(dist);
    int must_hit = par->ds > 0.0f && (kind == SK_POLYGON || kind == SK_RING || kind == SK_CYLINDER);
    if (kind == SK_SPHERE || kind == SK_CYLINDER || must_hit) {
        // near its outline a round source may stand in its own light; with -ds RADIANCE aims beside odd shapes, too
        Hit hit;
        if (must_hit) ray.tmax = dist * 1.001f;
        trace_closest(s, &ray, RAY_OPAQUE, &hit);
        if (hit.prim == as_uint_(q[SRC_PRIM])) must_hit = 0;
        else if (hit.prim != NO_HIT && hit.t <= shadow_end(dist)) return black;
        if (!must_hit) ray.tmax = shadow_end(dist);
    } else if (trace_any(s, &ray, RAY_OPAQUE)) {
        return black;
    }
    int absorbs = par->medium.w > 0.0f;
    if (must_hit && par->shadow_mode == SHADOW_OPAQUE) return black;
    if (par->shadow_mode == SHADOW_OPAQUE) return absorbs ? shadow_attenuation(&medium, MIN_(dist, ENDLESS_MEDIUM)) : T;
    float total = 0.0f;
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes l;
        trace_closest(s, &ray, RAY_TRANSPARENT, &hit);
        if (hit.prim == NO_HIT && must_hit) return black;
        if (hit.prim == NO_HIT)
            return absorbs ? mul3(T, shadow_attenuation(&medium, MIN_(ray.tmax, ENDLESS_MEDIUM))) : T;
        Medium crossed = medium, beyond = medium;
        int at_source = hit.prim == as_uint_(q[SRC_PRIM]);
        surface_at(s, &ray, &hit, &g);
        total += hit.t;
        g.total = total;
        uint carried = g.mod;
        if (!at_source && !((par->flags & PF_ANTIMATTER) != 0u && clip_hit(s, par, &g, &clip) == CLIP_IGNORE) &&
            find_material(s, par, &g, rnd) && !shadow_alternate(s, par, &g, q, 0, rnd)) {
            if (g.type >= M_LIGHT && g.type <= M_ILLUM) {
                return black;
            } else if (g.type == M_MIST) {
                mist_crossing(s, par, &g, &medium, &beyond);
            } else {
                material_lobes(s, par, &g, LOBES_SHADOW, rnd, &medium, &beyond, &l);
                if ((par->flags & PF_ANTIMATTER) != 0u) clip_turned(s, par, &g, carried, &clip);
                if ((l.flags & LOBE_PASS) == 0u) T = mul3(T, l.through);
            }
            if (max3(T) <= 0.0f) return black;
        }
        if (!g.mixed) crossed = medium;
        if (absorbs) T = mul3(T, shadow_attenuation(&crossed, hit.t));
        if (at_source) return T;
        medium = beyond;
        ray.org = offset_ray(g.p, neg3(g.ng), g.reach);
        if (!IS_FAR(ray.tmax)) {
            ray.tmax -= hit.t;
            if (ray.tmax <= 0.0f) return must_hit ? black : T;
        }
    }
    return black;
}

// The same where light may bend (dielectric) or be relayed (mirror): followed surface by surface; it must arrive at the
// real source aimed at (spec shading 3.6, 4.6).  For virtual sources the result holds the source's radiance.
FN float3 shadow_aimed(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 org, float3 dir, float total,
                       uint source, Medium medium, uint clip, PRIVATE Sampler* rnd) {
    float3 T = F3(1.0f, 1.0f, 1.0f), black = F3(0.0f, 0.0f, 0.0f);
    GLOBAL const float* q = source_record(s, par, source);
    int is_virtual = as_uint_(q[SRC_VIRTUAL]) != NONE, bent = 0;
    Ray ray;
    ray.org = org;
    ray.dir = dir;
    ray.tmin = 0.0f;
    ray.tmax = FAR_AWAY;
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes l;
        uint relay = as_uint_(q[SRC_VIRTUAL]);
        trace_closest(s, &ray, RAY_ALL, &hit);
        if (hit.prim == NO_HIT) {
            if (relay != NONE || as_uint_(q[SRC_KIND]) != SK_DISTANT) return black;
            float3 e = sub3(ray.dir, f3_at(q + SRC_CENTRE));
            if (par->medium.w > 0.0f) T = mul3(T, shadow_attenuation(&medium, ENDLESS_MEDIUM));
            if ((bent || is_virtual) && 0.5f * dot3(e, e) > q[SRC_CAP]) return black;
            if (!is_virtual) return T;
            return mul3(T, light_radiance(s, par, as_uint_(q[SRC_MOD]), NONE, ray.dir, ray.org, neg3(ray.dir), FAR_AWAY,
                                          FAR_AWAY, rnd));
        }
        surface_at(s, &ray, &hit, &g);
        total += hit.t;
        g.total = total;
        uint carried = g.mod;
        if (relay == NONE && hit.prim == as_uint_(q[SRC_PRIM])) {
            if (!g.front) return black;
            if (par->medium.w > 0.0f) T = mul3(T, shadow_attenuation(&medium, hit.t));
            if (!is_virtual) return T;
            return mul3(
                T, light_radiance(s, par, as_uint_(q[SRC_MOD]), hit.prim, ray.dir, g.p, g.nface, hit.t, total, rnd));
        }
        float3 next = ray.dir;
        Medium here = medium, beyond = medium;  // of the segment that ends here; behind the surface
        uint before = clip;
        int relayed = relay != NONE && hit.prim == s->u[relay + RELAY_PRIM];
        if (!((par->flags & PF_ANTIMATTER) != 0u && clip_hit(s, par, &g, &clip) == CLIP_IGNORE) &&
            find_material(s, par, &g, rnd) && !shadow_alternate(s, par, &g, q, relayed, rnd)) {
            if (g.type >= M_LIGHT && g.type <= M_ILLUM) {
                return black;
            } else if (g.type == M_MIST) {
                mist_crossing(s, par, &g, &here, &beyond);
            } else {
                material_lobes(s, par, &g, LOBES_SHADOW, rnd, &here, &beyond, &l);
                if ((par->flags & PF_ANTIMATTER) != 0u) clip_turned(s, par, &g, carried, &clip);
                if ((l.flags & LOBE_PASS) == 0u) {
                    if (relayed) {  // the one aimed at
                        q = source_record(s, par, s->u[relay + RELAY_SOURCE]);
                        if (g.type == M_PRISM) {
                            float3 aim = f3_at(q + SRC_CENTRE);
                            if (as_uint_(q[SRC_KIND]) != SK_DISTANT) aim = unit3(sub3(aim, g.p));
                            T = scale3(T, prism_exit(s, par, &g, aim, s->u[relay + RELAY_EXIT], &next));
                        } else {
                            T = mul3(T, l.mirror);
                            next = sub3(scale3(g.ng, 2.0f * dot3(g.ng, g.v)), g.v);  // textures do not act here
                        }
                    } else if (max3(l.refract) > 0.0f) {
                        T = mul3(T, l.refract);
                        next = l.refract_dir;
                        bent = 1;
                    } else {
                        T = mul3(T, l.through);
                    }
                }
            }
            if (max3(T) <= 0.0f) return black;
        }
        if (par->medium.w > 0.0f) T = mul3(T, shadow_attenuation(g.mixed ? &medium : &here, hit.t));
        int reflected = dot3(next, g.ng) > 0.0f;
        medium = reflected ? here : beyond;
        if (reflected) clip = before;
        ray.org = offset_ray(g.p, reflected ? g.ng : neg3(g.ng), g.reach);
        ray.dir = next;
    }
    return black;
}

FN void path_shadow(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* paths, uint slot) {
    float4 o = paths->shadow_org[slot], d = paths->shadow_dir[slot], c = paths->shadow_rad[slot];
    uint4 info = paths->info[slot];
    Sampler rnd = path_sampler(info);
    rnd.key = hash_(rnd.key ^ 0x5bd1e995u);
    float3 T;
    Medium medium = par->medium.w > 0.0f ? shadow_medium(paths, slot) : medium_open(par);
    uint clip = (par->flags & PF_ANTIMATTER) != 0u ? as_uint_(paths->shadow_medium[slot].w) : CLIP_START;
    if (par->shadow_mode == SHADOW_AIMED) {
        T = shadow_aimed(s, par, xyz4(o), xyz4(d), c.w, as_uint_(o.w), medium, clip, &rnd);
    } else {
        T = shadow_straight(s, par, xyz4(o), xyz4(d), d.w, as_uint_(o.w), medium, clip, &rnd);
    }
    float4 r = paths->rad[slot];
    paths->rad[slot] = pack4(add3(xyz4(r), mul3(xyz4(c), T)), r.w);
}

// MODE_DRAW: slot i holds a straight ray from the eye to a point of a source and its weight, written by the host into
// the slot's shadow ray; the source's own radiance is applied here, path_shadow follows.
FN void path_draw(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* paths, uint slot) {
    uint i = as_uint_(paths->shadow_org[slot].w);
    GLOBAL const float* q = source_record(s, par, i);
    float3 org = xyz4(paths->shadow_org[slot]), dir = xyz4(paths->shadow_dir[slot]);
    float dist = paths->shadow_dir[slot].w;
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, slot + par->first, 0u, 3u);
    float3 normal = neg3(dir), point = org;
    if (as_uint_(q[SRC_KIND]) != SK_DISTANT) {
        point = madd3(dir, dist, org);
        normal = as_uint_(q[SRC_KIND]) == SK_SPHERE ? unit3(sub3(point, f3_at(q + SRC_CENTRE))) : f3_at(q + SRC_NORMAL);
    }
    float3 e =
        light_radiance(s, par, as_uint_(q[SRC_MOD]), as_uint_(q[SRC_PRIM]), dir, point, normal, dist, dist, &rnd);
    paths->shadow_rad[slot] = pack4(mul3(xyz4(paths->shadow_rad[slot]), e), 0.0f);
    paths->rad[slot] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);
    if (path_media_used(par)) {
        Medium open = medium_open(par);
        open.albedo = F3(0.0f, 0.0f, 0.0f);  // what the eye sees is dimmed by all extinction
        set_shadow_medium(paths, slot, &open, CLIP_START);
    }
    uint4 info;
    info.x = 0u;
    info.y = rnd.key;
    info.z = rnd.index;
    info.w = NONE;
    paths->info[slot] = info;
}
#endif
