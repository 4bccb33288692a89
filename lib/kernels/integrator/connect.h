// SPDX-License-Identifier: BSD-3-Clause
// Suffix vertices light the prefix vertices of their group: each pixel's diffuse light is estimated from all directions
// that its group has sampled, if they are visible from it (Bekaert, Sbert and Halton 2002, "Accelerating Path Tracing
// by Re-Using Paths"), weighted by the balance heuristic (Veach 1997, section 9.2): divided by the sum of the pdfs with
// which each member would have sampled that vertex.  Unbiased: the expectation is that of separate paths.
#ifndef LUX_PATH_CONNECT_H
#define LUX_PATH_CONNECT_H

#define CERTAIN_IMPORTANCE 2.0f  // times the mean of a group's suffix vertices: above it one is always connected

// A prefix vertex, with the fields that connections to it need.
STRUCT(PrefixVertex) {
    float3 p, n, ng;
    float own;  // weight of its own ray, or NO_PREFIX
    Mixture mixture;
};

FN PrefixVertex prefix_vertex(TABLES(const Paths) paths, uint path) {
    Row_prefix_n n = prefix_n_of(read4_(paths->prefix_n, path));
    Row_prefix_p p = prefix_p_of(read4_(paths->prefix_p, path));
    Row_prefix_ng ng = prefix_ng_of(read4_(paths->prefix_ng, path));
    PrefixVertex prefix;
    prefix.p = p.point;
    prefix.n = n.normal;
    prefix.ng = ng.normal;
    prefix.own = n.own;
    prefix.mixture = paths->mixture[path];
    return prefix;
}

// From a prefix vertex to a suffix vertex.
STRUCT(Connection) {
    Ray ray;
    float3 dir;      // toward the suffix vertex
    float cosine;    // over the prefix vertex
    float per_area;  // cosine at the suffix vertex over squared distance; 1 if the suffix vertex is a direction
};

// suffix: path index of the suffix vertex.  Returns 0 if one vertex does not face the other.
FN int connection_ends(TABLES(const Paths) paths, PRIVATE(const PrefixVertex) prefix, uint suffix,
                       PRIVATE(Connection) connection) {
    Row_suffix_p to = suffix_p_of(paths->suffix_p[suffix]);
    if (prefix->own == NO_PREFIX) return 0;
    connection->ray.org = prefix->p;
    connection->ray.tmin = 0.0f;

    if (to.kind == SUFFIX_DIRECTION) {
        connection->dir = to.place;
        connection->per_area = 1.0f;
        connection->ray.dir = connection->dir;
        connection->ray.tmax = FAR_AWAY;
    } else {
        Row_suffix_n far = suffix_n_of(paths->suffix_n[suffix]);
        float3 way = sub3(to.place, prefix->p);
        float d2 = dot3(way, way);
        connection->dir = scale3(way, 1.0f / sqrt_(d2));
        float facing = -dot3(connection->dir, far.normal);
        if (!(facing > 0.0f)) return 0;
        connection->per_area = facing / d2;

        // up to a point just before the suffix vertex's surface, where its own next ray begins
        float3 open = sub3(offset_ray(to.place, far.normal, far.rounding), prefix->p);
        connection->ray.tmax = length3(open);
        connection->ray.dir = scale3(open, 1.0f / connection->ray.tmax);
    }

    connection->cosine = dot3(connection->dir, prefix->n);
    return connection->cosine > 0.0f && dot3(connection->dir, prefix->ng) > 0.0f;
}

// Importance of a path's suffix vertex: its contribution to the path's own prefix vertex, for an albedo of 1.
FN float suffix_importance(Row_prefix_n prefix, Row_suffix_p suffix, float3 radiance) {
    if (suffix.kind == SUFFIX_NONE || !(prefix.own > 0.0f)) return 0.0f;
    return (fabs_(radiance.x) + fabs_(radiance.y) + fabs_(radiance.z)) * prefix.own;
}

// Russian roulette on suffix vertices of low importance, because most are dim and the connections take the time.
// Stores the survival probability of the suffix vertex of member `which` of a group (REUSE_FIRST); 0: it is not
// connected.  Where the light of many hours is still unknown all are.
FN void path_suffix_roulette(PARAMS(const Params) par, TABLES(const Paths) paths, UNIFORM uint first, uint which) {
    uint path = REUSE_MEMBER(first, which);
    float importance =
        suffix_importance(prefix_n_of(read4_(paths->prefix_n, path)), suffix_p_of(read4_(paths->suffix_p, path)),
                          xyz4(read4_(paths->suffix_rad, path)));
    float prob = 0.0f, all = 0.0f;
    if ((par->flags & PF_HOURS) != 0u) {
        prob = suffix_p_kind(paths->suffix_p[path]) != SUFFIX_NONE && prefix_n_own(paths->prefix_n[path]) > 0.0f ? 1.0f
                                                                                                                 : 0.0f;
    } else if (importance > 0.0f) {
        for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
            UNIFORM uint suffix = REUSE_MEMBER(first, m);
            all += suffix_importance(prefix_n_of(paths->prefix_n[suffix]), suffix_p_of(paths->suffix_p[suffix]),
                                     xyz4(paths->suffix_rad[suffix]));
        }
        prob = MIN_(importance / (CERTAIN_IMPORTANCE / (float)REUSE_GROUP * all), 1.0f);
        Sampler rnd = path_sampler(info_of(read4_(paths->info, path)));
        rnd.key = hash32(rnd.key ^ 0x2545f491u);
        if (!(sample1(&rnd) < prob)) prob = 0.0f;
    }
    paths->prefix_throughput[path] = prefix_throughput_words(xyz4(paths->prefix_throughput[path]), prob);
}

// Is the suffix vertex of a path connected?
#define CONNECTS_SUFFIX(paths, path) (prefix_throughput_survival((paths)->prefix_throughput[path]) > 0.0f)

// Visibility of the connections to a suffix vertex, two bits per member of the group: bit m: nothing lies between
// member m and the vertex; bit 16 + m: only surfaces that transmit light do.
FN uint connections_known(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    uint known = 0u;
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
        Connection connection;
        PrefixVertex prefix = prefix_vertex(paths, reuse_member(REUSE_MET(par, path), m));
        if (!connection_ends(paths, &prefix, path, &connection)) continue;
        if (!trace_any(s, &connection.ray, RAY_ALL)) known |= 1u << m;
        else if (par->shadow_mode != SHADOW_OPAQUE && !trace_any(s, &connection.ray, RAY_OPAQUE)) known |= 65536u << m;
    }
    return known;
}

// Returns 1 if g is a plain pane for a diffuse ray.  Any random number will do: mixtures are not panes.
FN int connection_pane(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g,
                       PRIVATE(Lobes) lobes) {
    Sampler rnd = sampler_start(0u, 0u, 0u, 0u, 0u);
    Medium open = medium_open(par), medium_behind = medium_open(par);
    if (!find_material(s, par, g, &rnd) || take_alternate(s, par, g, PC_DIFFUSE, &rnd)) return 0;
    if (!is_pane(s, g)) return 0;
    material_lobes(s, par, g, LOBES_SAMPLED, &rnd, &open, &medium_behind, lobes);
    return (lobes->flags & LOBE_PASS) == 0u;
}

// Transmittance of the panes along a ray, and the probability that a path passes all of them; returns 0 if something
// else is in the way.
FN int connection_panes(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Ray) ray, PRIVATE(float3) T,
                        PRIVATE(float) prob) {
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes lobes;
        trace_closest(s, ray, RAY_TRANSPARENT, &hit);
        if (hit.prim == NO_HIT) return 1;
        surface_at(s, ray, &hit, &g);
        g.path_length = hit.t;
        if (!connection_pane(s, par, &g, &lobes)) return 0;
        *T = mul3(*T, lobes.through);
        *prob *= pane_prob(&lobes);

        ray->org = offset_ray(g.p, neg3(g.ng), g.rounding);
        if (!IS_DISTANT(ray->tmax)) ray->tmax -= hit.t;
        if (ray->tmax <= 0.0f) return 1;
    }

    return 0;
}

// Members whose connections to the suffix vertex of a path may lead through panes, one bit each: nothing opaque lies
// between (and the member that found it, whose ray went that way).
FN uint connections_to_attenuate(uint known, uint finder) {
    return (known >> REUSE_GROUP | 1u << finder) & ~known & ((1u << REUSE_GROUP) - 1u);
}

// Traces such a connection: transmittance of the panes; w: the probability that a path passes them, negative if
// something else is in the way.
FN void connection_transmittance(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                                 uint path, uint m) {
    Connection connection;
    PrefixVertex prefix = prefix_vertex(paths, reuse_member(REUSE_MET(par, path), m));
    float3 T = F3(1.0f, 1.0f, 1.0f);
    float prob = 1.0f;
    if (!connection_ends(paths, &prefix, path, &connection) || !connection_panes(s, par, &connection.ray, &T, &prob))
        prob = -1.0f;
    if (!(prob > 0.0f)) prob = -1.0f;  // no path passes: a pattern may make a pane black or negative
    paths->transmittance[path].of[m] = transmittance_words(T, prob);
}

// For the connections of the prefix vertex of member `which` to all suffix vertices of its group: the pdf with which it
// would have sampled them, and their contributions.  `connections` holds their visibility; the transmittance of those
// through panes is known.
FN void path_connect(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                     UNIFORM uint first, uint which) {
    PrefixVertex prefix = prefix_vertex(paths, REUSE_MEMBER(first, which));
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
        UNIFORM uint suffix = REUSE_MEMBER(REUSE_MET(par, first), m), finder = REUSE_FINDER(par, m);
        if (!CONNECTS_SUFFIX(paths, suffix)) continue;
        uint open = paths->connections[suffix];
        uint panes = connections_to_attenuate(open, finder);
        float pdf = 0.0f, contribution = 0.0f, through = 1.0f;
        if ((panes >> which & 1u) != 0u) through = transmittance_prob(paths->transmittance[suffix].of[which]);

        Connection connection;
        if (((open | panes) >> which & 1u) != 0u && !(through < 0.0f) &&
            connection_ends(paths, &prefix, suffix, &connection)) {
            if (which == finder) pdf = connection.cosine * K_INV_PI / prefix.own;
            else pdf = diffuse_pdf(s, par, &prefix.mixture, prefix.p, prefix.n, connection.dir);
            pdf = pdf * connection.per_area * through;
            contribution = connection.cosine * K_INV_PI * connection.per_area;
        }
        paths->pdf[suffix].of[which] = pdf;
        paths->contribution[suffix].of[which] = contribution;
    }
}

// One over the sum of these pdfs and the survival probability: the weight of the suffix vertex of a path.
FN float suffix_mis_weight(TABLES(const Paths) paths, uint path) {
    float pdfs = 0.0f;
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) pdfs += paths->pdf[path].of[m];
    return pdfs > 0.0f ? 1.0f / (pdfs * prefix_throughput_survival(paths->prefix_throughput[path])) : 0.0f;
}

FN void path_normalise_mis(TABLES(const Paths) paths, uint path) {
    Row_suffix_rad radiance = suffix_rad_of(read4_(paths->suffix_rad, path));
    float3 weighted = scale3(radiance.rgb, suffix_mis_weight(paths, path));
    write4_(paths->suffix_rad, path, suffix_rad_words(weighted, radiance.path_length));
}

// Contribution of a suffix vertex to the prefix vertex of member `which`, with the panes between them; finder:
// REUSE_FINDER.
FN float3 connection_weight(TABLES(const Paths) paths, UNIFORM uint suffix, UNIFORM uint finder, uint which) {
    float3 T = F3(1.0f, 1.0f, 1.0f);
    if ((connections_to_attenuate(paths->connections[suffix], finder) >> which & 1u) != 0u)
        T = xyz4(paths->transmittance[suffix].of[which]);
    return scale3(T, paths->contribution[suffix].of[which]);
}

// Adds the contributions of all suffix vertices of a group to the prefix vertex of member `which`.
FN void path_gather(TABLES(const Paths) paths, UNIFORM uint first, uint which) {
    uint path = REUSE_MEMBER(first, which);
    if (prefix_n_own(paths->prefix_n[path]) == NO_PREFIX) return;
    float3 sum = F3(0.0f, 0.0f, 0.0f);
    for (UNIFORM uint m = 0u; m < REUSE_GROUP; m++) {
        UNIFORM uint suffix = REUSE_MEMBER(first, m);
        if (!CONNECTS_SUFFIX(paths, suffix)) continue;
        sum = add3(sum, mul3(connection_weight(paths, suffix, m, which), xyz4(paths->suffix_rad[suffix])));
    }

    Row_rad rad = rad_of(read4_(paths->rad, path));
    float3 light = mul3(xyz4(read4_(paths->prefix_throughput, path)), sum);
    write4_(paths->rad, path, rad_words(add3(rad.rgb, light), rad.path_length));
}
#endif
