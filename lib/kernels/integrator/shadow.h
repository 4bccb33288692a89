// SPDX-License-Identifier: BSD-3-Clause
// Shadow rays: transmittance from a point to its sampled point on a source.
#ifndef LUX_PATH_SHADOW_H
#define LUX_PATH_SHADOW_H

// Opaque surfaces along a shadow ray: not traced yet, none, or one.
#define SHADOW_TO_TRACE 0
#define SHADOW_OPEN 1
#define SHADOW_BLOCKED 2

// A shadow ray on its way to its sampled point on a source.
STRUCT(ShadowRay) {
    Ray ray;
    GLOBAL const Source* src;  // record of the source aimed at; behind the relay of a virtual source, of the next one
    float3 T;                  // transmittance so far
    float path_length;         // path length so far
    Medium medium;             // the medium that the ray is in
    uint clip;                 // state of antimatter (clip.h)
    int absorbs;               // is there any medium in the scene?
    int is_virtual;            // aimed at a virtual source: its radiance is known at its end only
    int bent;                  // it does not follow one straight line
    int known;                 // SHADOW_TO_TRACE ...
    Sampler rnd;
};

// Evaluates a hit of a shadow ray.  Returns HIT_*: an emitter stops the ray, the lobes of a surface hold its
// transmittance.  g gets its material; *here and *medium_behind are the media of the segment that ends here and behind
// the surface.  relayed: g is the relay of the virtual source aimed at.
FN int shadow_hit(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow, PRIVATE(Surface) g,
                  int relayed, PRIVATE(Medium) here, PRIVATE(Medium) medium_behind, PRIVATE(Lobes) lobes) {
    int antimatter = has_antimatter(par);
    uint carried = g->mod;
    if (antimatter && clip_hit(s, g, &shadow->clip) == CLIP_IGNORE) return HIT_NULL;
    if (!find_material(s, par, g, &shadow->rnd)) return HIT_NULL;
    if (shadow_alternate(s, par, g, shadow->src, relayed, &shadow->rnd)) return HIT_NULL;
    if (material_has(g->type, MT_EMISSIVE) != 0u) return HIT_EMITTER;
    if (HAS(SOLIDS) && g->type == M_MIST) {
        mist_crossing(s, par, g, here, medium_behind);
        return HIT_NULL;
    }
    material_lobes(s, par, g, LOBES_SHADOW, &shadow->rnd, here, medium_behind, lobes);
    if (antimatter) clip_turned(s, par, g, carried, &shadow->clip);
    return (lobes->flags & LOBE_PASS) != 0u ? HIT_NULL : HIT_SURFACE;
}

// Returns 1 if the ray may miss the source that it was aimed at, so that only a hit of the source adds light: tubes are
// aimed at by their axis, and a surface in the source's plane may hide it.
FN int shadow_seeks_source(PARAMS(const Params) par, GLOBAL const Source* src) {
    uint kind = src->kind;
    if (src->covered != 0u) return 1;
    if (kind == SK_CYLINDER) return par->ds > 0.0f || par->dj <= 0.0f;
    return par->ds > 0.0f && (kind == SK_POLYGON || kind == SK_RING);
}

// Returns 1 if a ray that hits this source at t comes from behind.  A ray may enter a tube through its open end.
FN int shadow_from_behind(GLOBAL const Source* src, PRIVATE(const Ray) ray, float t) {
    if (src->kind != SK_CYLINDER) return 0;
    float3 axis = f3_of(src->u), from = sub3(madd3(ray->dir, t, ray->org), f3_of(src->centre));
    float3 radial = madd3(axis, -dot3(from, axis) / dot3(axis, axis), from);
    return dot3(radial, ray->dir) > 0.0f;
}

// Returns 1 if an occlusion test against opaque surfaces comes first, before any glass.  *ray: the ray of that test.
FN int shadow_is_plain(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path,
                       PRIVATE(Ray) ray) {
    Row_shadow_org org = shadow_org_of(paths->shadow_org[path]);
    Row_shadow_dir dir = shadow_dir_of(paths->shadow_dir[path]);
    GLOBAL const Source* src = source_record(s, org.source);
    uint kind = src->kind;
    if (aims_shadows(par) || kind == SK_SPHERE || kind == SK_CYLINDER) return 0;
    if (shadow_seeks_source(par, src)) return 0;
    ray->org = org.point;
    ray->dir = dir.way;
    ray->tmin = 0.0f;
    ray->tmax = IS_DISTANT(dir.distance) ? FAR_AWAY : shadow_end(dir.distance);
    return 1;
}

// Returns 1 if the source is hidden, where the ray hits it, by a mixture in its plane.
FN int shadow_covered(TABLES(const SceneTables) s, GLOBAL const Source* src, PRIVATE(const Ray) ray,
                      PRIVATE(const Hit) hit) {
    if (src->covered == 0u) return 0;
    Surface g;
    Hit seen;
    Ray last = *ray;
    surface_at(s, ray, hit, &g);
    last.tmin = MAX_(hit->t - (g.rounding / fabs_(dot3(ray->dir, g.ng)) + SURFACE_ROUNDING * hit->t), 0.0f);
    trace_closest(s, &last, RAY_ALL, &seen);
    return seen.prim != hit->prim;
}

// Returns 1 if something opaque occludes the ray.  Also sets the length to trace for surfaces that transmit light, and
// *must_hit if the ray must still hit the source itself.
FN int shadow_blocked(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow, float dist,
                      PRIVATE(int) must_hit) {
    PRIVATE(Ray) ray = &shadow->ray;
    uint kind = shadow->src->kind;
    *must_hit = shadow_seeks_source(par, shadow->src);
    ray->tmax = IS_DISTANT(dist) ? FAR_AWAY : shadow_end(dist);
    if (shadow->known != SHADOW_TO_TRACE) return shadow->known == SHADOW_BLOCKED;
    if (kind != SK_SPHERE && kind != SK_CYLINDER && !*must_hit) return trace_any(s, ray, RAY_OPAQUE);

    // near its outline a round source may shadow itself; with -ds RADIANCE aims beside other shapes
    Hit hit;
    if (*must_hit) ray->tmax = dist * 1.001f;
    trace_closest(s, ray, RAY_OPAQUE, &hit);
    if (hit.prim == shadow->src->prim) {
        if (*must_hit && shadow_from_behind(shadow->src, ray, hit.t)) return 1;
        if (shadow_covered(s, shadow->src, ray, &hit)) return 1;
        *must_hit = 0;
    } else if (hit.prim != NO_HIT && hit.t <= shadow_end(dist)) return 1;
    if (!*must_hit) ray->tmax = shadow_end(dist);
    return 0;
}

// Transmittance straight through glass, smooth trans and mixtures with void (spec shading 4.5).
FN float3 shadow_straight(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow,
                          float dist) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    PRIVATE(Ray) ray = &shadow->ray;
    int must_hit;
    if (shadow_blocked(s, par, shadow, dist, &must_hit)) return black;

    if (par->shadow_mode == SHADOW_OPAQUE) {
        if (must_hit) return black;
        return shadow->absorbs ? shadow_attenuation(&shadow->medium, MIN_(dist, ENDLESS_MEDIUM)) : shadow->T;
    }

    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes lobes;
        trace_closest(s, ray, RAY_TRANSPARENT, &hit);
        if (hit.prim == NO_HIT) {
            if (must_hit) return black;
            if (!shadow->absorbs) return shadow->T;
            return mul3(shadow->T, shadow_attenuation(&shadow->medium, MIN_(ray->tmax, ENDLESS_MEDIUM)));
        }
        surface_at(s, ray, &hit, &g);
        shadow->path_length += hit.t;
        g.path_length = shadow->path_length;
        int at_source = hit.prim == shadow->src->prim;
        Medium here = shadow->medium, medium_behind = shadow->medium;
        int kind = at_source ? HIT_NULL : shadow_hit(s, par, shadow, &g, 0, &here, &medium_behind, &lobes);
        if (kind == HIT_SURFACE) shadow->T = mul3(shadow->T, lobes.through);
        if (kind == HIT_EMITTER || max3(shadow->T) <= 0.0f) return black;

        if (shadow->absorbs) {
            Medium crossed = g.mixed ? shadow->medium : here;
            shadow->T = mul3(shadow->T, shadow_attenuation(&crossed, hit.t));
        }
        if (at_source && shadow_covered(s, shadow->src, ray, &hit)) return black;
        if (at_source) return must_hit && !g.front ? black : shadow->T;

        shadow->medium = medium_behind;
        ray->org = offset_ray(g.p, neg3(g.ng), g.rounding);
        if (IS_DISTANT(ray->tmax)) continue;
        ray->tmax -= hit.t;
        if (ray->tmax <= 0.0f) return must_hit ? black : shadow->T;
    }
    return black;
}

// An aimed ray leaves the scene: a distant source must lie in its direction.
FN float3 aimed_at_sky(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    GLOBAL const Source* src = shadow->src;
    PRIVATE(const Ray) ray = &shadow->ray;
    if (src->relay != NONE || src->kind != SK_DISTANT) return black;

    float3 e = sub3(ray->dir, f3_of(src->centre));
    if (shadow->absorbs) shadow->T = mul3(shadow->T, shadow_attenuation(&shadow->medium, ENDLESS_MEDIUM));
    if ((shadow->bent || shadow->is_virtual) && 0.5f * dot3(e, e) > src->cap) return black;
    if (!shadow->is_virtual) return shadow->T;
    return mul3(shadow->T, light_radiance(s, par, src->mod, NONE, ray->dir, ray->org, neg3(ray->dir), FAR_AWAY,
                                          FAR_AWAY, &shadow->rnd));
}

// The ray has arrived at its source.
FN float3 aimed_at_source(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow,
                          PRIVATE(const Surface) g) {
    if (!g->front) return F3(0.0f, 0.0f, 0.0f);
    if (shadow->absorbs) shadow->T = mul3(shadow->T, shadow_attenuation(&shadow->medium, g->length));
    if (!shadow->is_virtual) return shadow->T;
    return mul3(shadow->T, light_radiance(s, par, shadow->src->mod, g->prim, shadow->ray.dir, g->p, g->nface, g->length,
                                          g->path_length, &shadow->rnd));
}

// Redirects the ray at the relay of a virtual source, toward the source behind it.  Returns the new direction.
FN float3 aimed_relay(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow,
                      PRIVATE(const Surface) g, PRIVATE(const Lobes) lobes) {
    GLOBAL const Relay* relay = &s->relays[shadow->src->relay];
    shadow->src = &s->sources[relay->source];

    if (g->type != M_PRISM) {
        shadow->T = mul3(shadow->T, lobes->mirror);
        return sub3(scale3(g->ng, 2.0f * dot3(g->ng, g->v)),
                    g->v);  // textures do not act here
    }

    float3 next = shadow->ray.dir, aim = f3_of(shadow->src->centre);
    if (shadow->src->kind != SK_DISTANT) aim = unit3(sub3(aim, g->p));
    shadow->T = scale3(shadow->T, prism_exit(s, par, g, aim, relay->exit, &next));
    return next;
}

// Transmittance of another surface, and the direction behind it.
FN float3 aimed_through(PRIVATE(ShadowRay) shadow, PRIVATE(const Lobes) lobes) {
    if (max3(lobes->refract) > 0.0f) {
        shadow->T = mul3(shadow->T, lobes->refract);
        shadow->bent = 1;
        return lobes->refract_dir;
    }

    shadow->T = mul3(shadow->T, lobes->through);
    return shadow->ray.dir;
}

// Transmittance where light is refracted (dielectric) or relayed (mirror): followed surface by surface to the real
// source aimed at (spec shading 3.6, 4.6).  For virtual sources the result includes the source's radiance.
FN float3 shadow_aimed(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(ShadowRay) shadow) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    PRIVATE(Ray) ray = &shadow->ray;
    ray->tmax = FAR_AWAY;

    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes lobes;
        uint relay = shadow->src->relay, before = shadow->clip;
        trace_closest(s, ray, RAY_ALL, &hit);
        if (hit.prim == NO_HIT) return aimed_at_sky(s, par, shadow);

        surface_at(s, ray, &hit, &g);
        shadow->path_length += hit.t;
        g.path_length = shadow->path_length;
        if (relay == NONE && hit.prim == shadow->src->prim) return aimed_at_source(s, par, shadow, &g);

        // the surface redirects the ray, attenuates it or stops it
        float3 next = ray->dir;
        Medium here = shadow->medium, medium_behind = shadow->medium;
        int relayed = relay != NONE && hit.prim == s->relays[relay].prim;
        int kind = shadow_hit(s, par, shadow, &g, relayed, &here, &medium_behind, &lobes);
        if (kind == HIT_SURFACE)
            next = relayed ? aimed_relay(s, par, shadow, &g, &lobes) : aimed_through(shadow, &lobes);
        if (kind == HIT_EMITTER || max3(shadow->T) <= 0.0f) return black;

        // the medium before it attenuates it, too
        int reflected = dot3(next, g.ng) > 0.0f;
        if (shadow->absorbs) {
            Medium crossed = g.mixed ? shadow->medium : here;
            shadow->T = mul3(shadow->T, shadow_attenuation(&crossed, hit.t));
        }
        shadow->medium = relayed && reflected ? here : medium_behind;
        if (reflected) shadow->clip = before;
        ray->org = offset_ray(g.p, reflected ? g.ng : neg3(g.ng), g.rounding);
        ray->dir = next;
    }
    return black;
}

// Where patterns fall below 0, RADIANCE keeps light whose channels sum to more than 0.  (The emitter's own pattern is
// not in this sum.)
FN int shadow_counts(TABLES(const SceneTables) s, PRIVATE(const ShadowRay) shadow, float3 T) {
    if (T.x >= 0.0f && T.y >= 0.0f && T.z >= 0.0f) return 1;
    GLOBAL const Modifier* emitter = &s->modifiers[shadow->src->mod];
    int plain = !shadow->is_virtual && shadow->src->mod != NONE && emitter->type >= M_FIRST_MATERIAL;
    float3 light = plain ? mul3(T, f3_at(s->f + emitter->args)) : T;
    return light.x + light.y + light.z > 0.0f;
}

// Adds the light of a path's shadow ray.  known: visibility of a plain one (shadow_is_plain).
FN void path_shadow(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path,
                    int known) {
    Row_shadow_org org = shadow_org_of(read4_(paths->shadow_org, path));
    Row_shadow_dir dir = shadow_dir_of(read4_(paths->shadow_dir, path));
    Row_shadow_rad rad = shadow_rad_of(read4_(paths->shadow_rad, path));
    int antimatter = has_antimatter(par), aimed = aims_shadows(par);
    ShadowRay shadow;
    shadow.ray.org = org.point;
    shadow.ray.dir = dir.way;
    shadow.ray.tmin = 0.0f;
    shadow.src = source_record(s, org.source);
    shadow.T = F3(1.0f, 1.0f, 1.0f);
    shadow.path_length = aimed ? rad.path_length : 0.0f;
    shadow.absorbs = has_media(par);
    shadow.medium = shadow.absorbs ? shadow_medium(paths, path) : medium_open(par);
    shadow.clip = antimatter ? shadow_medium_clip(paths->shadow_medium[path]) : CLIP_START;
    shadow.is_virtual = shadow.src->relay != NONE;
    shadow.bent = 0;
    shadow.known = known;
    shadow.rnd = path_sampler(info_of(read4_(paths->info, path)));
    shadow.rnd.key = hash32(shadow.rnd.key ^ 0x5bd1e995u);

    float3 T = aimed ? shadow_aimed(s, par, &shadow) : shadow_straight(s, par, &shadow, dir.distance);
    if (par->mode == MODE_SPLAT && shadow.bent) return;  // samples and images of the sun (image.h) hold this light
    if (!shadow_counts(s, &shadow, T)) return;
    path_receive(par, paths, path, mul3(rad.rgb, T), T);
}
#endif
