// SPDX-License-Identifier: BSD-3-Clause
// Paths that serve many hours: geometry and materials are the same in all of them, so a path is followed once.  What it
// would get from the sky is kept as a direction and a share (path_end_in_sky); the suns of all hours are asked at each
// vertex (sun_vertex, path_sun) for their response: light per radiance of the disc.  The host multiplies both with the
// light of each hour (render/hours.h).  The expectation is that of the hour rendered by itself.
#ifndef LUX_PATH_HOURS_H
#define LUX_PATH_HOURS_H

// Returns 1 if a ray without a hit sees the sky of the hours there.
FN int sees_hours_sky(TABLES(const SceneTables) s, PARAMS(const Params) par, float3 dir, uint flags) {
    if ((par->flags & PF_HOURS) == 0u) return 0;
    uint i = distant_at(s, par, dir, path_sampled(flags));
    return i != NONE && i >= par->hours_sky_at;
}

// The path has left the scene.
FN void path_end_in_sky(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex) {
    float3 share = vertex->throughput;
    uint kind = (vertex->flags & PC_SUFFIX) != 0u ? SKY_SUFFIX : SKY_PATH;
    if ((vertex->flags & PC_RECORDS_SUFFIX) != 0u) {
        suffix_sky(paths, vertex, F3(0.0f, 0.0f, 0.0f));
        share = F3(1.0f, 1.0f, 1.0f);
        kind = SKY_SUFFIX;
    }
    if (!path_sampled(vertex->flags)) kind |= (vertex->flags & PC_BENT) != 0u ? SKY_MIRRORED : SKY_STRAIGHT;
    write4_(paths->sky_way, vertex->path, sky_way_words(vertex->ray.dir, kind));
    write4_(paths->sky_share, vertex->path, sky_share_words(share, 0u));
}

// Returns 1 if the path ends here, at a suffix vertex: what it reflects diffusely is found by a pass in which it is a
// sensor (render/hour_factors.h), and shares paths again.
FN int ends_in_gather(PARAMS(const Params) par, PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    return (par->flags & PF_GATHERS) != 0u && vertex->at_suffix && lobe->type == SAMPLE_DIFFUSE_R &&
           dot3(vertex->g.n, vertex->g.ng) > 0.99999f;
}

FN void path_end_in_gather(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    PRIVATE(const Surface) g = &vertex->g;
    uint path = vertex->path;
    float3 reflectance = scale3(lobe->color, lobe->total / MAX_(lobe->prob, 1e-30f));
    write4_(paths->sky_way, path, sky_way_words(g->ng, SKY_GATHERS));
    write4_(paths->sky_share, path, sky_share_words(reflectance, 0u));
    write4_(paths->org, path, org_words(offset_ray(g->p, g->ng, g->rounding), vertex->clip_before));
    vertex_store(paths, vertex, vertex->path_length_start);
}

#ifndef LUX_LANES
ROW(suffix_share, rgb, float, pdf)  // pdf: with which the path's prefix vertex would have found the suffix vertex

// The vertex that path_shade() will shade, with its lobes; changes nothing of the path.  Returns 1 if suns may light
// it.
FN int sun_vertex(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path,
                  PRIVATE(Vertex) vertex) {
    vertex_load(par, paths, path, vertex);
    if (vertex->hit.prim == NO_HIT || !vertex->wanted) return 0;
    int on_sensor = vertex->hit.prim == ON_SENSOR;
    if (!on_sensor && !vertex_arrive(s, vertex)) return 0;
    sampler_ahead(&vertex->rnd);
    if ((on_sensor ? vertex_sensor(vertex) : vertex_hit(s, par, paths, vertex)) != HIT_SURFACE) return 0;
    vertex->at_suffix = (vertex->flags & PC_RECORDS_SUFFIX) != 0u && !is_pane(s, &vertex->g) &&
                        is_even_suffix(s, &vertex->g, &vertex->lobes);
    return 1;
}

// The suns that a path asks: all, or those of its pixel.
STRUCT(AskedSuns) {
    uint at, count;
    int all;
};
FN AskedSuns asked_suns(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path) {
    AskedSuns asked;
    asked.at = 0u;
    asked.count = par->suns_count;
    asked.all = (par->flags & PF_ASKS) == 0u;
    if (!asked.all) {
        GLOBAL const FocusEntry* entry = focus_entry(s, par, path);
        asked.at = entry->suns_at;
        asked.count = entry->suns;
    }
    return asked;
}
FN uint asked_sun(TABLES(const SceneTables) s, PRIVATE(const AskedSuns) asked, uint i) {
    return asked->all ? i : s->asked[asked->at + i];
}

// How a vertex samples the suns: each `step`-th, a power of two, counts `step` times; all at one place of their discs.
STRUCT(SunSampling) {
    uint turn, step;
    float2 place;  // of a disc of radius 1
};

FN int samples_sun(PRIVATE(const SunSampling) sampling, GLOBAL const Source* sun) {
    return ((sun->hour + sampling->turn) & (sampling->step - 1u)) == 0u;
}

// The samples of a pixel take turns, so that each sun has as many of what the eye sees.  Far from the eye a path
// carries less light.
FN SunSampling sun_sampling(PARAMS(const Params) par, PRIVATE(const Vertex) vertex) {
    SunSampling sampling;
    Sampler rnd = vertex->rnd;
    uint bounces = path_bounces(vertex->flags);
    uint turn = rnd.index;
    rnd.key = hash32(rnd.key ^ (0x68bc21ebu + path_steps(vertex->flags)));
    rnd.until = 0u;
    rnd.dim = 0u;
    sampling.step = bounces == 0u ? par->suns_step_eye : par->suns_step << MIN_(bounces - 1u, 2u);
    sampling.turn = bounces == 0u ? turn + hash32(vertex->rnd.key) : rnd.key;

    float sn, cs;
    float2 x = sample2(&rnd);
    float r = sqrt_(x.x) * MIN_(MAX_(par->dj, 0.0f), 1.0f);
    k_sincos(K_TURN * x.y, &sn, &cs);
    sampling.place.x = r * cs;
    sampling.place.y = r * sn;
    return sampling;
}

// Toward that place of a sun, not unit; its half axes are as long as the tangent of its radius.
FN float3 sun_way(GLOBAL const Source* sun, float2 place) {
    return madd3(f3_of(sun->u), place.x, madd3(f3_of(sun->v), place.y, f3_of(sun->centre)));
}

// Where shadow rays begin.
FN float3 sun_ray_start(PRIVATE(const Vertex) vertex, int above) {
    PRIVATE(const Surface) g = &vertex->g;
    return offset_ray(bsdf_start(&vertex->lobes, g, above), above ? g->ng : neg3(g->ng), g->rounding);
}

// Adds the response to a sun: of the path, and of its suffix vertex to be shared with its group.  known: visibility
// (shadow.h).
FN void path_sun(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Vertex) at, uint sun, float3 way,
                 int known, PRIVATE(float3) own, PRIVATE(float3) shared) {
    Vertex vertex = *at;  // random numbers of its own
    PRIVATE(const Surface) g = &vertex.g;
    vertex.rnd.key = hash32(vertex.rnd.key ^ hash32(s->suns[sun].hour + 0x51ed270bu));
    vertex.rnd.until = 0u;
    *own = *shared = F3(0.0f, 0.0f, 0.0f);

    LightSample light;
    light.dir = way;
    light.dist = FAR_AWAY;
    light.w = s->suns[sun].area;
    light.pieces = 1.0f;
    light.point = g->p;
    light.normal = neg3(way);
    float3 response = direct_response(s, par, &light, &vertex);
    if (!(max3(response) > 0.0f)) return;

    ShadowRay shadow;
    shadow.ray.org = sun_ray_start(&vertex, dot3(way, g->ng) > 0.0f);
    shadow.ray.dir = way;
    shadow.ray.tmin = 0.0f;
    shadow.src = &s->suns[sun];
    shadow.T = F3(1.0f, 1.0f, 1.0f);
    shadow.path_length = aims_shadows(par) ? g->path_length : 0.0f;
    shadow.medium = medium_open(par);
    shadow.clip = CLIP_START;
    shadow.absorbs = shadow.is_virtual = shadow.bent = 0;
    shadow.known = known;
    shadow.rnd = vertex.rnd;
    shadow.rnd.key = hash32(shadow.rnd.key ^ 0x5bd1e995u);
    float3 T = aims_shadows(par) ? shadow_aimed(s, par, &shadow) : shadow_straight(s, par, &shadow, FAR_AWAY);
    if (!(T.x + T.y + T.z > 0.0f)) return;

    if (vertex.at_suffix) {
        float3 even = lobes_even(&vertex.lobes, g, way, light.w);
        *shared = mul3(even, T);
        response = sub3(response, even);
    }
    float3 rest = mul3(mul3(vertex.throughput, response), T);
    if ((vertex.flags & PC_SUFFIX) != 0u) *shared = rest;
    else *own = rest;
}

// What a path gets of the outgoing light of member m of the group that its own meets in this round, before the weight
// of that suffix vertex; after path_connect().
FN float4 path_share_of_suffix(PARAMS(const Params) par, TABLES(const Paths) paths, uint path, uint m) {
    uint suffix = reuse_member(REUSE_MET(par, path), m), which = reuse_which(path);
    if (prefix_n_own(paths->prefix_n[path]) == NO_PREFIX || !CONNECTS_SUFFIX(paths, suffix))
        return suffix_share_words(F3(0.0f, 0.0f, 0.0f), 0.0f);
    float3 weight = connection_weight(paths, suffix, REUSE_FINDER(par, m), which);
    return suffix_share_words(mul3(xyz4(paths->prefix_throughput[path]), weight), paths->pdf[suffix].of[which]);
}
#endif
#endif
