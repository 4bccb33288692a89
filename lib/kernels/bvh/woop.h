// SPDX-License-Identifier: BSD-3-Clause
// Ray prepared for traversal, and the watertight test of one triangle.
// Triangles: Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection": the triangle is sheared into the space
// where the ray is the z axis; neighbours compute the same bits for their common edge, and points on an edge (0) belong
// to both.  The distance is measured to the triangle's plane.  Boxes: slabs with the far side widened, Ize 2013,
// "Robust BVH Ray Traversal".  Needs strict floating point.
#ifndef LUX_WOOP_H
#define LUX_WOOP_H

#define SLAB_WIDEN 1.0000004f

STRUCT(WoopRay) {
    float3 org, dir, inv;
    uint kx, ky, kz;   // kz: longest axis of dir
    float ox, oy, oz;  // origin in the order kx ky kz
    float sx, sy;      // shear
};

// Slabs parallel to the ray: a large finite slope, because 0 times infinity is not a number.
FN float slab_inverse(float d) { return fabs_(d) > 1e-18f ? 1.0f / d : d < 0.0f ? -1e18f : 1e18f; }

FN void woop_prepare(float3 org, float3 dir, PRIVATE(WoopRay) r) {
    float ax = fabs_(dir.x), ay = fabs_(dir.y), az = fabs_(dir.z);
    r->org = org;
    r->dir = dir;
    r->inv = F3(slab_inverse(dir.x), slab_inverse(dir.y), slab_inverse(dir.z));
    r->kz = ax > ay ? (ax > az ? 0u : 2u) : (ay > az ? 1u : 2u);
    r->kx = r->kz == 2u ? 0u : r->kz + 1u;
    r->ky = r->kx == 2u ? 0u : r->kx + 1u;
    r->ox = axis3(org, r->kx);
    r->oy = axis3(org, r->ky);
    r->oz = axis3(org, r->kz);
    r->sx = axis3(dir, r->kx) / axis3(dir, r->kz);
    r->sy = axis3(dir, r->ky) / axis3(dir, r->kz);
}

// A normal of a triangle, not normalised, and a corner on its plane.  The cross product of a slat's two long edges
// would be inexact, so that the edges meet at a or b, whichever is nearer to c.
FN float3 triangle_normal(float3 a, float3 b, float3 c, PRIVATE(float3) corner) {
    float3 ab = sub3(b, a), side = sub3(c, a), other = sub3(c, b);
    *corner = a;
    if (dot3(other, other) < dot3(side, side)) {
        *corner = b;
        side = other;
    }
    return cross3(ab, side);
}

// Distance to a triangle's plane.  By the weights of its corners it would be wrong by 2^-24 L^2/w in a triangle of
// length L that the ray sees w wide: further than rays start from a surface, for a slat.
FN float triangle_distance(PRIVATE(const WoopRay) r, float3 a, float3 b, float3 c) {
    float3 corner;
    float3 n = triangle_normal(a, b, c, &corner);
    return dot3(n, sub3(corner, r->org)) / dot3(n, r->dir);
}

// Triangle a b c; t, u (of b), v (of c) if the ray's line meets it.  bvh8.h has the same in four lanes, step by step.
FN int woop_triangle(PRIVATE(const WoopRay) r, float3 a, float3 b, float3 c, PRIVATE(float) t, PRIVATE(float) u,
                     PRIVATE(float) v) {
    float az = axis3(a, r->kz) - r->oz, bz = axis3(b, r->kz) - r->oz, cz = axis3(c, r->kz) - r->oz;
    float ax = (axis3(a, r->kx) - r->ox) - r->sx * az, ay = (axis3(a, r->ky) - r->oy) - r->sy * az;
    float bx = (axis3(b, r->kx) - r->ox) - r->sx * bz, by = (axis3(b, r->ky) - r->oy) - r->sy * bz;
    float cx = (axis3(c, r->kx) - r->ox) - r->sx * cz, cy = (axis3(c, r->ky) - r->oy) - r->sy * cz;
    float wa = cx * by - cy * bx, wb = ax * cy - ay * cx, wc = bx * ay - by * ax;
    float det = wa + wb + wc;
    if ((wa < 0.0f || wb < 0.0f || wc < 0.0f) && (wa > 0.0f || wb > 0.0f || wc > 0.0f)) return 0;
    if (det == 0.0f) return 0;
    *t = triangle_distance(r, a, b, c);
    *u = wb / det;
    *v = wc / det;
    return 1;
}

// A query along a ray.
FN void look_along(PRIVATE(const Ray) ray, PRIVATE(Look) look) {
    look->hit.t = ray->tmax;
    look->hit.prim = NO_HIT;
    look->hit.u = 0.0f;
    look->hit.v = 0.0f;
    look->hit.inst = NO_HIT;
    look->limit = ray->tmax;
    look->from = ray->tmin;
    look->after = ray->tmin;
    look->after_prim = NO_HIT;
    look->after_inst = NO_HIT;
    look->size = TIE_SHARE * (fabs_(ray->org.x) + fabs_(ray->org.y) + fabs_(ray->org.z));
    look->second = ray->tmax;
}

// Continues behind the hit found, up to a limit.
FN void look_past(PRIVATE(Look) look, float limit) {
    look->after = look->hit.t;
    look->after_prim = look->hit.prim;
    look->after_inst = look->hit.inst;
    look->from = MAX_(look->from, look->hit.t - (TIE_SHARE * look->hit.t + look->size));  // boxes are inexact, too
    look->limit = limit;
    look->hit.t = limit;
    look->hit.prim = NO_HIT;
    look->second = limit;
}

FN int hit_precedes(float t, uint prim, uint inst, float other_t, uint other_prim, uint other_inst) {
    return t < other_t || (t == other_t && (prim < other_prim || (prim == other_prim && inst < other_inst)));
}

// Keeps a hit if it is the first so far.
FN int hit_offer(PRIVATE(Look) look, float t, uint prim, float u, float v, uint inst) {
    PRIVATE(Hit) best = &look->hit;
    int none = best->prim == NO_HIT;
    if (!(t > look->after) && !hit_precedes(look->after, look->after_prim, look->after_inst, t, prim, inst)) return 0;
    if (none ? !(t < best->t) : !hit_precedes(t, prim, inst, best->t, best->prim, best->inst)) {
        look->second = MIN_(look->second, t);
        return 0;
    }
    look->second = best->t;
    best->t = t;
    best->prim = prim;
    best->u = u;
    best->v = v;
    best->inst = inst;
    look->limit = MIN_(look->limit, t + (TIE_SHARE * t + look->size));
    return 1;
}

// Is another hit near enough to the first?
FN int may_coincide(PRIVATE(const Look) look) { return look->second < look->limit; }

// The tree that a ray traverses, the scene's or an instance's, and the query there.
STRUCT(TreeRay) {
    WoopRay r;  // in the tree's coordinates
    uint inst;  // Hit.inst of its hits
    uint mask;  // RAY_*
};

FN void enter_scene(PRIVATE(const Ray) ray, uint mask, PRIVATE(TreeRay) way) {
    woop_prepare(ray->org, ray->dir, &way->r);
    way->inst = NO_HIT;
    way->mask = mask;
}

// *root: the tree's first node.  Returns 0 if no surface of the instance is of a class in the mask.
FN int enter_instance(TABLES(const SceneTables) s, uint number, PRIVATE(const Ray) ray, uint mask, PRIVATE(TreeRay) way,
                      PRIVATE(uint) root) {
    GLOBAL const Instance* instance = &s->instances[number];
    uint forced = instance->forced;
    if (forced != 0u && (mask & forced) == 0u) return 0;
    woop_prepare(instance_point(&instance->to_tree[0], ray->org), affine_vector(&instance->to_tree[0], ray->dir),
                 &way->r);
    way->inst = number;
    way->mask = forced == 0u ? mask : RAY_ALL;
    *root = ROOT_OF_TREE(instance->tree);
    return 1;
}
#endif
