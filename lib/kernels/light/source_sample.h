// SPDX-License-Identifier: BSD-3-Clause
// Samples a point on an active source as seen from the point p that it lights: one function per kind of source, from
// the source's record, two random numbers x and the jitter dj, 0 (the centre) to 1 (the whole source).  The sample's
// solid angle w stays 0 where the source cannot light p.
#ifndef LUX_SOURCE_SAMPLE_H
#define LUX_SOURCE_SAMPLE_H

// RADIANCE's partition of a large source (-ds; spec shading 4.3): the piece that holds this sample, found by halving
// the source while it is large for its distance, each half with equal probability.  *c becomes the piece's centre, *u
// and *v its half vectors; returns the piece's part of the source.  The result differs from the whole source only if
// -dj < 1.  line: no v.
FN float source_piece(float3 p, float ds, int line, PRIVATE(float3) c, PRIVATE(float3) u, PRIVATE(float3) v,
                      PRIVATE(float2) x) {
    float share = 1.0f, k = 2.0f / ds;
    float du = k * length3(*u), dv = line ? 0.0f : k * length3(*v);
    for (int i = 0; i < 6; i++) {  // at most 64 pieces
        float d = length3(sub3(p, *c)), sign;
        if (d >= du && d >= dv) break;
        if (du >= dv) {
            sign = x->x < 0.5f ? -0.5f : 0.5f;
            x->x = x->x < 0.5f ? 2.0f * x->x : 2.0f * x->x - 1.0f;
            *c = madd3(*u, sign, *c);
            *u = scale3(*u, 0.5f);
            du *= 0.5f;
        } else {
            sign = x->y < 0.5f ? -0.5f : 0.5f;
            x->y = x->y < 0.5f ? 2.0f * x->y : 2.0f * x->y - 1.0f;
            *c = madd3(*v, sign, *c);
            *v = scale3(*v, 0.5f);
            dv *= 0.5f;
        }
        share *= 0.5f;
    }

    return share;
}

// Cosine of a glow and cone of a spotlight, applied to a sample.
FN void source_limits(GLOBAL const Source* src, uint kind, float3 p, PRIVATE(LightSample) light) {
    if (src->max_radius > 0.0f && light->dist > src->max_radius) light->w = 0.0f;
    if (!IS_SPOT(src)) return;

    // inside the cone, as if its light came from f behind (spec 4.2); a sphere is measured from its centre
    float f = src->spot_focus, d = light->dist;
    if (kind == SK_SPHERE) d = length3(sub3(f3_of(src->centre), p));
    if (-dot3(f3_of(src->spot), light->dir) < src->spot_cos) light->w = 0.0f;
    light->w *= d * d / ((d + f) * (d + f));
}

// RADIANCE's approximate map of a square of half width 1 to a disc of equal area (spec shading 4.3).
FN float2 square_to_disc(float a, float b) {
    float2 d;
    d.x = 1.1284f * a * sqrt_(1.0f - 0.5f * b * b);
    d.y = 1.1284f * b * sqrt_(1.0f - 0.5f * a * a);
    return d;
}

// Direction at azimuth `turn` (in whole turns) about the axis, at 1 - cos = z1 from it.
FN float3 cone_direction(float3 axis, float z1, float turn) {
    float3 e1, e2;
    float sn, cs, r = sqrt_(z1 * (2.0f - z1));
    orthonormal_basis(axis, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(axis, 1.0f - z1), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

// From p to a point at distance *dist.
FN float3 light_direction(float3 to, PRIVATE(float) dist) {
    *dist = length3(to);
    return scale3(to, 1.0f / MAX_(*dist, 1e-9f));
}

// A sphere or sun seen through a prism: its axes are sheared with its place, and the sample decides how much of it the
// bent rays hit.  So RADIANCE's own samples are used (spec shading 4.3): points of a ball; a square mapped to a disc.
FN float3 sheared_place(GLOBAL const Source* src, int distant, float2 x, float dj) {
    float third = 4096.0f * x.x;  // what is left of the first number
    float3 k = F3(2.0f * x.x - 1.0f, 2.0f * x.y - 1.0f, 2.0f * (third - floor_(third)) - 1.0f);
    if (dj > 0.7f && distant) {
        float2 d = square_to_disc(k.x, k.y);
        k = F3(d.x, d.y, 0.0f);
    } else if (dj > 0.7f) {
        float most = MAX_(fabs_(k.x), MAX_(fabs_(k.y), fabs_(k.z)));
        k = scale3(k, most / (MAX_(length3(k), 1e-6f) * 0.7236f));
    }

    k = scale3(k, dj);
    float3 at = madd3(f3_of(src->u), k.x, madd3(f3_of(src->v), k.y, f3_of(src->centre)));
    return distant ? at : madd3(f3_of(src->normal), k.z, at);
}

// A sun: uniform over its cap, pulled to its centre by dj.
FN void sample_distant(GLOBAL const Source* src, float3 p, float2 x, float dj, PRIVATE(LightSample) light) {
    float3 axis = f3_of(src->centre);
    if (dj <= 0.0f) light->dir = axis;
    else if (src->sheared != 0u) light->dir = unit3(sheared_place(src, 1, x, dj));
    else light->dir = cone_direction(axis, x.x * dj * dj * src->cap, x.y);

    light->dist = FAR_AWAY;
    light->w = src->area;
    light->point = p;  // patterns on a sun are evaluated at the ray's origin
    light->normal = neg3(light->dir);
}

FN void sample_sheared_sphere(GLOBAL const Source* src, float3 p, float2 x, float dj, PRIVATE(LightSample) light) {
    light->dir = light_direction(sub3(sheared_place(src, 0, x, dj), p), &light->dist);
    light->w = K_PI * src->radius * src->radius / MAX_(light->dist * light->dist, 1e-18f);
    light->point = madd3(light->dir, light->dist, p);
    light->normal = neg3(light->dir);
}

FN void sample_sphere(GLOBAL const Source* src, float3 p, float2 x, float dj, PRIVATE(LightSample) light) {
    float r = src->radius;
    float3 c = f3_of(src->centre);
    float3 to = sub3(c, p);
    float d2 = dot3(to, to);
    if (d2 <= r * r) return;
    float d = sqrt_(d2);
    to = scale3(to, 1.0f / d);

    if (dj <= 0.0f) {  // RADIANCE's centre sample (spec shading 4.2)
        if (src->max_radius > 0.0f && d > src->max_radius) return;
        light->dir = to;
        light->dist = d - r;
        light->w = K_PI * r * r / d2;
        light->point = madd3(to, -r, c);
        light->normal = neg3(to);
        return;
    }

    if (src->sheared != 0u) {
        sample_sheared_sphere(src, p, x, dj, light);
        return;
    }

    // exact: uniform over the cone it subtends
    float s2 = r * r / d2;
    float cap = s2 / (1.0f + sqrt_(1.0f - s2));  // 1 - cos of the half angle
    float z1 = x.x * cap;
    float off = sqrt_(z1 * (2.0f - z1));
    float e = r * r - d2 * off * off;
    light->dir = cone_direction(to, z1, x.y);
    light->dist = d * (1.0f - z1) - sqrt_(e > 0.0f ? e : 0.0f);
    light->w = K_TURN * cap;
    light->point = madd3(light->dir, light->dist, p);
    light->normal = unit3(sub3(light->point, c));
}

// A parallelogram; with -ds also a polygon or ring, in RADIANCE's own pieces and approximate shape: the shadow ray must
// then hit the source.
FN float3 point_of_pieces(PARAMS(const Params) par, GLOBAL const Source* src, uint kind, float3 p, float2 x, float dj,
                          PRIVATE(float) pieces) {
    float3 centre = f3_of(src->centre), u = f3_of(src->u), v = f3_of(src->v);
    if (kind == SK_RING) {  // square of equal area
        u = scale3(u, 0.886226925f);
        v = scale3(v, 0.886226925f);
    }

    float3 c = centre, pu = u, pv = v;
    if (par->ds > 0.0f) *pieces = 1.0f / source_piece(p, par->ds, 0, &c, &pu, &pv, &x);
    float3 at = madd3(pu, dj * (2.0f * x.x - 1.0f), madd3(pv, dj * (2.0f * x.y - 1.0f), c));
    if (kind != SK_RING) return at;

    float3 o = sub3(at, centre);
    float2 d = square_to_disc(dot3(o, u) / dot3(u, u), dot3(o, v) / dot3(v, v));
    return madd3(u, d.x, madd3(v, d.y, centre));
}

FN float3 point_of_ring(GLOBAL const Source* src, float2 x, float dj) {
    float r = dj * sqrt_(x.x), sn, cs;
    k_sincos(K_TURN * x.y, &sn, &cs);
    return madd3(f3_of(src->u), r * cs, madd3(f3_of(src->v), r * sn, f3_of(src->centre)));
}

// A triangle of the fan, by area, and a point in it.
FN float3 point_of_polygon(TABLES(const SceneTables) s, GLOBAL const Source* src, float2 x, float dj) {
    if (dj <= 0.0f) return f3_of(src->centre);
    uint count = src->fan_count, k = 0u;
    GLOBAL const FanTriangle* fan = &s->fans[src->fan_at];
    while (k + 1u < count && x.x >= fan->upto) {
        k++;
        fan++;
    }

    float u = (x.x - fan->from) / (fan->upto - fan->from);
    float su = sqrt_(u);
    return madd3(f3_of(fan->edge1), su * (1.0f - x.y), madd3(f3_of(fan->edge2), su * x.y, f3_of(fan->corner)));
}

// Completes a sample from its point and the normal there.
FN void sample_point(GLOBAL const Source* src, float3 at, float3 n, float3 p, PRIVATE(LightSample) light) {
    float3 to = sub3(at, p);
    float d2 = dot3(to, to);
    if (d2 <= 0.0f) return;
    light->dist = sqrt_(d2);
    light->dir = scale3(to, 1.0f / light->dist);
    float cosine = -dot3(n, light->dir);
    if (cosine <= 1e-4f) return;
    light->w = src->area * cosine / d2;
    light->point = at;
    light->normal = n;
}

FN void sample_flat(TABLES(const SceneTables) s, PARAMS(const Params) par, GLOBAL const Source* src, uint kind,
                    float3 p, float2 x, float dj, PRIVATE(LightSample) light) {
    float3 at;
    if (kind == SK_PARALLELOGRAM || par->ds > 0.0f) at = point_of_pieces(par, src, kind, p, x, dj, &light->pieces);
    else if (kind == SK_RING) at = point_of_ring(src, x, dj);
    else at = point_of_polygon(s, src, x, dj);
    sample_point(src, at, f3_of(src->normal), p, light);
}

// A cylinder in RADIANCE's approximation, with -dj 0 or in the pieces of -ds: a line with the cylinder's apparent
// width.
FN void sample_line(PARAMS(const Params) par, GLOBAL const Source* src, float3 p, float2 x, float dj,
                    PRIVATE(LightSample) light) {
    float3 c = f3_of(src->centre), axis = f3_of(src->u);
    float3 none = axis;
    float r = src->radius, share = 1.0f;

    if (par->ds > 0.0f) {
        float3 across = cross3(sub3(p, c), axis);
        if (length3(across) > 2.0f * r * length3(axis)) share = source_piece(p, par->ds, 1, &c, &axis, &none, &x);
        c = madd3(axis, dj * (2.0f * x.x - 1.0f), c);
    }

    float3 to = sub3(c, p);
    float d2 = dot3(to, to), h = length3(axis);
    float ca = dot3(to, axis) / (h * sqrt_(d2));
    float sa = 1.0f - ca * ca;
    light->pieces = 1.0f / share;
    light->dist = sqrt_(d2);
    light->dir = scale3(to, 1.0f / light->dist);
    light->w = 4.0f * r * (h / share) * sqrt_(sa > 0.0f ? sa : 0.0f) / d2;

    // patterns are evaluated where the ray hits the tube, not on its axis
    float3 out = madd3(axis, ca / h, neg3(light->dir));
    float sine = length3(out);
    light->point = sine > 1e-4f ? madd3(light->dir, -r / sine, c) : c;
    light->normal = sine > 1e-4f ? scale3(out, 1.0f / sine) : neg3(light->dir);
}

FN void sample_cylinder(PARAMS(const Params) par, GLOBAL const Source* src, float3 p, float2 x, float dj,
                        PRIVATE(LightSample) light) {
    if (dj <= 0.0f || par->ds > 0.0f) {
        sample_line(par, src, p, x, dj, light);
        return;
    }

    float3 axis = f3_of(src->u), e1, e2;
    float sn, cs;
    orthonormal_basis(unit3(axis), &e1, &e2);
    k_sincos(K_TURN * x.y, &sn, &cs);
    float3 n = add3(scale3(e1, cs), scale3(e2, sn));
    float3 at = madd3(n, src->radius, madd3(axis, 2.0f * x.x - 1.0f, f3_of(src->centre)));
    sample_point(src, at, n, p, light);
}

// Samples a point of active source `source` as seen from p; w = 0 if it cannot light p.
FN void sample_source(TABLES(const SceneTables) s, PARAMS(const Params) par, uint source, float3 p, float2 x, float dj,
                      PRIVATE(LightSample) light) {
    GLOBAL const Source* src = &s->sources[source];
    uint kind = src->kind;
    light->w = 0.0f;
    light->pieces = 1.0f;

    if (kind == SK_DISTANT) {
        sample_distant(src, p, x, dj, light);
        return;
    }

    if (kind == SK_SPHERE) sample_sphere(src, p, x, dj, light);
    else if (kind == SK_CYLINDER) sample_cylinder(par, src, p, x, dj, light);
    else sample_flat(s, par, src, kind, p, x, dj, light);
    if (!(light->w <= 0.0f)) source_limits(src, kind, p, light);
}

// The way from a point to a flat source, shortened for a shadow ray to end before it meets the source itself: by the
// rounding (offset_ray.h) of the source and of the ray's length, along the source's normal.
FN float3 way_before_source(TABLES(const SceneTables) s, GLOBAL const Source* src, float3 from, float3 way) {
    uint kind = src->kind;
    if (src->relay != NONE || (kind != SK_PARALLELOGRAM && kind != SK_POLYGON && kind != SK_RING)) return way;
    float3 n = f3_of(src->normal);
    float extent = prim_extent(&s->prims[src->prim]);
    float distance = SURFACE_ROUNDING * (extent + sum_along(n, add3(from, way)) + length3(way));
    return madd3(n, dot3(n, way) < 0.0f ? distance : -distance, way);
}
#endif
