// SPDX-License-Identifier: BSD-3-Clause
// Ray against the analytic shapes (Shape of records.h): sphere, open cone or cylinder, ring, polygon with holes.
// Shared by bvh8.h, bvh_compact.h and Embree's callbacks (tests/unit).  dir need not be unit (instances).
// Equation: implicit surface along o + t d, solved about the point of the ray nearest the shape's centre or axis, so
// that a distant eye costs no digits.  Edges belong to the shape; flat shapes ignore rays with |cos| <= 1e-6, as
// RADIANCE.
#ifndef LUX_SHAPES_H
#define LUX_SHAPES_H

#define SHAPE_GRAZING 1e-6f

// Roots of a t^2 + 2 b t + c = 0, the smaller first; the count.  Both by the stable form q = -(b + sign(b) sqrt(disc)).
FN int quadratic(float a, float b, float c, PRIVATE(float) t0, PRIVATE(float) t1) {
    float disc = b * b - a * c, q;
    if (!(disc >= 0.0f)) return 0;
    q = -(b + (b < 0.0f ? -sqrt_(disc) : sqrt_(disc)));

    if (fabs_(a) <= 1e-9f * fabs_(b)) {  // along the slant of a cone: one root
        if (b == 0.0f) return 0;
        *t0 = -0.5f * c / b;
        *t1 = *t0;
        return 1;
    }

    *t0 = q / a;
    *t1 = q != 0.0f ? c / q : *t0;

    if (*t1 < *t0) {
        float s = *t0;
        *t0 = *t1;
        *t1 = s;
    }

    return 2;
}

// Sphere: with p the point of the ray nearest the centre, t = t_p -+ sqrt((r^2 - |p - c|^2) / d.d).
FN int sphere_hit(GLOBAL const Shape* shape, float3 org, float3 dir, float tmin, PRIVATE(float) t) {
    float3 oc = sub3(f3_of(shape->centre), org);
    float dd = dot3(dir, dir);
    float tp = dot3(oc, dir) / dd, r = shape->radius;
    float3 l = sub3(oc, scale3(dir, tp));
    float d2 = r * r - dot3(l, l), h;
    if (!(d2 >= 0.0f)) return 0;
    h = sqrt_(d2 / dd);
    *t = tp - h;
    if (*t > tmin) return 1;
    *t = tp + h;
    return *t > tmin;
}

// Cone: |w - (w.a) a| = r0 + k w.a with w from p0 and k = (r1 - r0)/length; 0 <= w.a <= length.
FN int cone_hit(GLOBAL const Shape* shape, float3 org, float3 dir, float tmin, PRIVATE(float) t) {
    float3 p0 = f3_of(shape->centre), axis = f3_of(shape->normal);
    float len = shape->length, r0 = shape->radius;
    float k = (shape->other_radius - r0) / len;
    float dd = dot3(dir, dir), da = dot3(dir, axis), t0 = 0.0f, t1 = 0.0f, h;
    float3 oc = sub3(org, p0), dp = sub3(dir, scale3(axis, da));
    float pp = dot3(dp, dp);
    float ts = dot3(sub3(scale3(axis, 0.5f * len), oc), dir) / dd;
    if (pp > 1e-3f * dd) ts = -dot3(sub3(oc, scale3(axis, dot3(oc, axis))), dp) / pp;
    float3 w = madd3(dir, ts, oc);
    float wa = dot3(w, axis);
    float r = r0 + k * wa;
    float3 wp = sub3(w, scale3(axis, wa));
    float a = pp - k * k * da * da, b = dot3(wp, dp) - k * da * r, c = dot3(wp, wp) - r * r;
    if (quadratic(a, b, c, &t0, &t1) == 0) return 0;
    h = wa + t0 * da;
    *t = ts + t0;
    if (*t > tmin && h >= 0.0f && h <= len) return 1;
    h = wa + t1 * da;
    *t = ts + t1;
    return *t > tmin && h >= 0.0f && h <= len;
}

FN int ring_hit(GLOBAL const Shape* shape, float3 org, float3 dir, float tmin, PRIVATE(float) t) {
    float3 oc = sub3(f3_of(shape->centre), org), n = f3_of(shape->normal), l;
    float c = dot3(dir, n), d2;
    if (c * c <= SHAPE_GRAZING * SHAPE_GRAZING * dot3(dir, dir)) return 0;
    *t = dot3(oc, n) / c;
    if (!(*t > tmin)) return 0;
    l = sub3(scale3(dir, *t), oc);
    d2 = dot3(l, l);
    return d2 >= shape->other_radius * shape->other_radius && d2 <= shape->radius * shape->radius;
}

// Even-odd rule in the plane of two coordinates; a point within eps of an edge is inside.  Loops joined by seams
// (holes) need nothing special: a seam is crossed twice.  us: the polygon's corners (POLYGON_ROW).
FN int polygon_inside(GLOBAL const float* us, uint count, float u, float v, float eps) {
    GLOBAL const float* vs = us + POLYGON_ROW(count);
    int odd = 0;

    for (uint i = 0u; i < count; i++) {
        float pu = us[i], qu = us[i + 1u], pv = vs[i], qv = vs[i + 1u];
        if ((pv > v) != (qv > v) && u < (qu - pu) * (v - pv) / (qv - pv) + pu) odd = !odd;
    }

    for (uint i = 0u; i < count && !odd; i++) {
        float pu = us[i], pv = vs[i];
        float eu = us[i + 1u] - pu, ev = vs[i + 1u] - pv, wu = u - pu, wv = v - pv;
        float ee = eu * eu + ev * ev;
        float h = ee > 0.0f ? (wu * eu + wv * ev) / ee : 0.0f;
        h = h < 0.0f ? 0.0f : h > 1.0f ? 1.0f : h;
        wu -= h * eu;
        wv -= h * ev;
        odd = wu * wu + wv * wv <= eps * eps;
    }

    return odd;
}

#if WIDE_WORDS
// The same, eight edges at once: the padding of the rows is NaN, and no edge with a NaN is crossed or near.
FN int polygon_inside8(GLOBAL const float* us, uint count, float u, float v, float eps) {
    GLOBAL const float* vs = us + POLYGON_ROW(count);
    v8f none = splat8_(0.0f), all = splat8_(1.0f);
    int odd = 0;

    for (uint i = 0u; i < count; i += 8u) {
        v8f pu = load8_(us + i), qu = load8_(us + i + 1u), pv = load8_(vs + i), qv = load8_(vs + i + 1u);
        odd ^= lane_odd_(lanes8_(((pv > v) ^ (qv > v)) & ((qu - pu) * (v - pv) / (qv - pv) + pu > u)));
    }

    for (uint i = 0u; i < count && !odd; i += 8u) {
        v8f pu = load8_(us + i), pv = load8_(vs + i);
        v8f eu = load8_(us + i + 1u) - pu, ev = load8_(vs + i + 1u) - pv, wu = u - pu, wv = v - pv;
        v8f ee = eu * eu + ev * ev;
        v8f h = (wu * eu + wv * ev) / ee;
        h = ee > 0.0f ? h : none;
        h = h < 0.0f ? none : h;
        h = h > 1.0f ? all : h;
        wu -= h * eu;
        wv -= h * ev;
        odd = lanes8_(wu * wu + wv * wv <= eps * eps) != 0u;
    }

    return odd;
}
#else
#define polygon_inside8 polygon_inside
#endif

FN int polygon_hit(GLOBAL const Shape* shape, GLOBAL const float* uv, float3 org, float3 dir, float tmin,
                   PRIVATE(float) t) {
    float3 n = f3_of(shape->normal), p;
    float c = dot3(dir, n);
    uint axis = shape->dropped_axis;
    if (c * c <= SHAPE_GRAZING * SHAPE_GRAZING * dot3(dir, dir)) return 0;
    *t = (shape->offset - dot3(n, org)) / c;
    if (!(*t > tmin)) return 0;
    p = madd3(dir, *t, org);
    return polygon_inside8(uv + shape->uv_at, shape->corners, axis == 0u ? p.y : p.x, axis == 2u ? p.y : p.z,
                           shape->margin);
}

// First t > tmin at which the ray hits the shape; 0 if it does not.
FN int shape_hit(GLOBAL const Shape* shape, GLOBAL const float* polygon_uv, float3 org, float3 dir, float tmin,
                 PRIVATE(float) t) {
    uint kind = shape->kind;
    if (kind == SHAPE_SPHERE) return sphere_hit(shape, org, dir, tmin, t);
    if (kind == SHAPE_CONE) return cone_hit(shape, org, dir, tmin, t);
    if (kind == SHAPE_RING) return ring_hit(shape, org, dir, tmin, t);
    if (kind == SHAPE_POLYGON) return polygon_hit(shape, polygon_uv, org, dir, tmin, t);
    return 0;
}
#endif
