// SPDX-License-Identifier: BSD-3-Clause
// From a hit to the point to be shaded: position, modelled geometric normal, side of the viewer.
#ifndef LUX_SURFACE_H
#define LUX_SURFACE_H

STRUCT(Surface) {
    float3 p;                          // hit point
    float3 nface;                      // geometric normal as modelled, unit
    float3 ng;                         // the same on the viewer's side
    float3 n;                          // shading normal on the viewer's side (textures, smoothing)
    float3 v;                          // unit, toward the viewer
    float3 color;                      // product of the patterns
    float3 pert;                       // sum of the textures
    float3 color_before, pert_before;  // without the material's own chain: state in which an alternate starts
    float u, vv;                       // mesh coordinates Lu, Lv
    float length;                      // of the ray that hit
    float rounding;                    // p is as near to the surface as this, along the normal (offset_ray.h)
    float path_length;                 // path length from the eye
    uint prim, mod;                    // primitive; its modifier, after find_material() the material's
    uint type;                         // material type
    uint inst;                         // instance (instance.h), NONE
    int front;                         // hit from the side the modelled normal points to
    int flat;                          // polygon or ring without texture
    int smooth;                        // perturbation from mesh smoothing
    int mixed;                         // the material is part of a mixture: it does not define the medium before it
};

// A polygon or ring, which a texture may still bend.  An instance with a modifier of its own is not flat: RADIANCE
// takes the instance for the surface.
FN int drawn_flat(TABLES(const SceneTables) s, PRIVATE(const Surface) g) {
    if ((s->prims[g->prim].kind & PRIM_TEXTURE_FLAT) == 0u) return 0;
    return !in_instance(g->inst) || s->instances[g->inst].mod == NONE;
}

// Returns 1 if a texture or mesh smoothing has turned the normal by more than RADIANCE's threshold.
FN int is_textured(PRIVATE(const Surface) g) { return dot3(g->pert, g->pert) > 1e-12f; }

// Outward normal of a sphere or cone at the point *p, which moves onto it.
FN float3 shape_normal(TABLES(const SceneTables) s, uint kind, uint number, PRIVATE(float3) p) {
    GLOBAL const Shape* shape = &s->shapes[number];
    if (kind == PRIM_SPHERE) {
        float3 centre = f3_of(shape->centre);
        float3 n = unit3(sub3(*p, centre));
        *p = madd3(n, shape->radius, centre);
        return n;
    }

    // cone: perpendicular to the slanted side, away from the axis
    float3 axis = f3_of(shape->normal), r = sub3(*p, f3_of(shape->centre));
    float length = shape->length, slope = shape->radius - shape->other_radius;
    float along = dot3(r, axis);
    float3 across = sub3(r, scale3(axis, along));
    float3 radial = unit3(across);
    *p = madd3(radial, shape->radius - slope * (along / length) - dot3(across, radial), *p);
    float side = sqrt_(length * length + slope * slope);
    return unit3(add3(scale3(radial, length / side), scale3(axis, slope / side)));
}

// Smoothing and uv of a mesh triangle: the perturbation is the interpolated normal minus the plane's (spec scene 3).
FN void mesh_corners(TABLES(const SceneTables) s, GLOBAL const Prim* prim, PRIVATE(const Hit) hit, PRIVATE(Surface) g) {
    GLOBAL const uint* corner = s->u + prim->at;
    GLOBAL const Corner* a = &s->corners[corner[0]];
    GLOBAL const Corner* b = &s->corners[corner[1]];
    GLOBAL const Corner* c = &s->corners[corner[2]];
    float3 na = f3_of(a->normal), nb = f3_of(b->normal), nc = f3_of(c->normal);
    float w = 1.0f - hit->u - hit->v, len;
    g->u = w * a->u + hit->u * b->u + hit->v * c->u;
    g->vv = w * a->v + hit->u * b->v + hit->v * c->v;
    if ((prim->kind & PRIM_CORNER_NORMALS) == 0u) return;
    float3 n = F3(w * na.x + hit->u * nb.x + hit->v * nc.x, w * na.y + hit->u * nb.y + hit->v * nc.y,
                  w * na.z + hit->u * nb.z + hit->v * nc.z);
    len = length3(n);
    if (len <= 1e-6f) return;
    g->pert = sub3(scale3(n, 1.0f / len), g->nface);
    g->smooth = 1;
}

// Normal at the point *at, in the primitive's coordinates.  *at moves onto the surface.
FN float3 surface_shape(TABLES(const SceneTables) s, GLOBAL const Prim* prim, PRIVATE(float3) at) {
    uint kind = prim->kind & PRIM_KIND_MASK;
    if (kind != PRIM_SPHERE && kind != PRIM_CONE) {
        float3 n = f3_of(prim->normal);
        *at = madd3(n, prim->offset - dot3(n, *at), *at);
        return n;
    }
    float3 n = shape_normal(s, kind, prim->at, at);
    return (prim->kind & PRIM_INWARD) != 0u ? neg3(n) : n;
}

// The same in an instance: normal in the world; the surface's point moves, too, and *extent becomes the length in the
// world to which the point's rounding is relative (offset_ray.h).
FN float3 surface_in_instance(TABLES(const SceneTables) s, GLOBAL const Prim* prim, GLOBAL const float* matrix,
                              PRIVATE(Surface) g, PRIVATE(float) extent) {
    float3 from = sub3(g->p, F3(matrix[3], matrix[7], matrix[11]));
    float3 at = affine_vector(matrix, from);
    float3 on = at;
    float3 n = surface_shape(s, prim, &on);
    float scale2 = affine_scale2(matrix), sum = *extent;
    for (UNIFORM uint i = 0u; i < 3u; i++) {
        GLOBAL const float* row = matrix + 4u * i;
        sum += fabs_(axis3(n, i)) * (fabs_(row[0] * from.x) + fabs_(row[1] * from.y) + fabs_(row[2] * from.z));
    }
    *extent = sum / sqrt_(scale2);
    g->p = madd3(affine_back(matrix, sub3(on, at)), 1.0f / scale2, g->p);
    return n;
}

FN float prim_extent(GLOBAL const Prim* prim) { return as_float_(prim->kind >> PRIM_EXTENT_SHIFT << 23); }
FN float sum_along(float3 n, float3 p) { return fabs_(n.x * p.x) + fabs_(n.y * p.y) + fabs_(n.z * p.z); }

// A surface before its modifiers are evaluated.
FN void surface_plain(uint prim, uint mod, uint inst, float length, PRIVATE(Surface) g) {
    g->prim = prim;
    g->mod = mod;
    g->inst = inst;
    g->length = length;
    g->color = F3(1.0f, 1.0f, 1.0f);
    g->pert = F3(0.0f, 0.0f, 0.0f);
    g->u = 0.0f;
    g->vv = 0.0f;
    g->smooth = 0;
    g->mixed = 0;
}

FN void surface_at(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, PRIVATE(const Hit) hit, PRIVATE(Surface) g) {
    GLOBAL const Prim* prim = &s->prims[hit->prim];
    GLOBAL const float* matrix = 0;
    surface_plain(hit->prim, prim->mod, hit->inst, hit->t, g);
    g->p = madd3(ray->dir, hit->t, ray->org);
    g->v = neg3(ray->dir);

    float extent = prim_extent(prim);
    if (in_instance(hit->inst)) {
        GLOBAL const Instance* record = &s->instances[hit->inst];
        matrix = &record->to_tree[0];
        if (record->mod != NONE) g->mod = record->mod;
        g->nface = surface_in_instance(s, prim, matrix, g, &extent);
    } else {
        g->nface = surface_shape(s, prim, &g->p);
    }

    g->flat = drawn_flat(s, g);
    if ((prim->kind & PRIM_KIND_MASK) == PRIM_SMOOTH) mesh_corners(s, prim, hit, g);

    if (matrix != 0) {  // mirrored instances keep their sides: the normal is mirrored with the geometry
        float3 n = affine_back(matrix, g->nface);
        float k = 1.0f / length3(n);
        g->nface = scale3(n, k);
        g->pert = scale3(affine_back(matrix, g->pert), k);
    }

    g->front = dot3(g->nface, g->v) > 0.0f;
    g->ng = g->front ? g->nface : neg3(g->nface);
    g->n = g->ng;
    g->rounding = SURFACE_ROUNDING * (extent + sum_along(g->ng, g->p));
}

// Returns 1 if the surface that a ray hits contains the ray's origin, within the rounding of both.
FN int holds_origin(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, PRIVATE(const Hit) hit) {
    if (hit->prim == NO_HIT) return 0;
    Surface g;
    surface_at(s, ray, hit, &g);
    return fabs_(dot3(sub3(g.p, ray->org), g.ng)) <= g.rounding;
}

// An orthonormal frame around n (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
FN void orthonormal_basis(float3 n, PRIVATE(float3) t, PRIVATE(float3) b) {
    float sign = n.z >= 0.0f ? 1.0f : -1.0f;
    float a = -1.0f / (sign + n.z);
    float c = n.x * n.y * a;
    *t = F3(1.0f + sign * n.x * n.x * a, sign * c, -sign * n.x);
    *b = F3(c, sign + n.y * n.y * a, -n.y);
}
#endif
