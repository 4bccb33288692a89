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
    float error_scale;                 // length that sets the rounding of p: the ray's or the primitive's
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
    if ((s->prims[PRIM_WORDS * g->prim + PRIM_KIND] & PRIM_TEXTURE_FLAT) == 0u) return 0;
    return !in_instance(g->inst) || as_uint_(*(instance_record(s, g->inst) + INST_MOD)) == NONE;
}

// Returns 1 if a texture or mesh smoothing has turned the normal by more than RADIANCE's threshold.
FN int is_textured(PRIVATE(const Surface) g) { return dot3(g->pert, g->pert) > 1e-12f; }

// Outward normal of a sphere or cone at the point p.
FN float3 shape_normal(TABLES(const SceneTables) s, uint kind, uint number, float3 p) {
    GLOBAL const float* shape = shape_record(s, number);
    if (kind == PRIM_SPHERE) return unit3(sub3(p, f3_at(shape + SPHERE_CENTRE)));

    // cone: perpendicular to the slanted side, away from the axis
    float3 axis = f3_at(shape + CONE_AXIS), r = sub3(p, f3_at(shape + CONE_START));
    float3 radial = unit3(sub3(r, scale3(axis, dot3(r, axis))));
    float length = shape[CONE_LENGTH], slope = shape[CONE_RADIUS0] - shape[CONE_RADIUS1];
    float side = sqrt_(length * length + slope * slope);
    return unit3(add3(scale3(radial, length / side), scale3(axis, slope / side)));
}

// Smoothing and uv of a mesh triangle: the perturbation is the interpolated normal minus the plane's (spec scene 3).
FN void mesh_corners(TABLES(const SceneTables) s, GLOBAL const uint* prim, PRIVATE(const Hit) hit, PRIVATE(Surface) g) {
    GLOBAL const uint* corner = s->u + prim[PRIM_VERTEX];
    GLOBAL const float* a = s->f + corner[0];
    GLOBAL const float* b = s->f + corner[1];
    GLOBAL const float* c = s->f + corner[2];
    float w = 1.0f - hit->u - hit->v, len;
    g->u = w * a[3] + hit->u * b[3] + hit->v * c[3];
    g->vv = w * a[4] + hit->u * b[4] + hit->v * c[4];
    if ((prim[PRIM_KIND] & PRIM_CORNER_NORMALS) == 0u) return;
    float3 n = F3(w * a[0] + hit->u * b[0] + hit->v * c[0], w * a[1] + hit->u * b[1] + hit->v * c[1],
                  w * a[2] + hit->u * b[2] + hit->v * c[2]);
    len = length3(n);
    if (len <= 1e-6f) return;
    g->pert = sub3(scale3(n, 1.0f / len), g->nface);
    g->smooth = 1;
}

// Normal at the point `at`, in the primitive's coordinates; for a sphere also the exact position.  matrix: from world
// to these coordinates, 0 outside instances.
FN void surface_shape(TABLES(const SceneTables) s, GLOBAL const uint* prim, float3 at, GLOBAL const float* matrix,
                      PRIVATE(Surface) g) {
    uint kind = prim[PRIM_KIND] & PRIM_KIND_MASK;
    if (kind != PRIM_SPHERE && kind != PRIM_CONE) {
        g->nface = f3_bits(prim + PRIM_NORMAL);
        return;
    }

    float3 n = shape_normal(s, kind, prim[PRIM_NORMAL], at);
    g->nface = (prim[PRIM_KIND] & PRIM_INWARD) != 0u ? neg3(n) : n;
    if (kind != PRIM_SPHERE) return;

    // move the point onto the surface: far from it single precision drifts
    GLOBAL const float* sphere = shape_record(s, prim[PRIM_NORMAL]);
    float3 on = madd3(n, sphere[SPHERE_RADIUS], f3_at(sphere + SPHERE_CENTRE));
    if (matrix == 0) g->p = on;
    else g->p = madd3(affine_back(matrix, sub3(on, at)), 1.0f / affine_scale2(matrix), g->p);
}

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
    GLOBAL const uint* prim = s->prims + PRIM_WORDS * hit->prim;
    GLOBAL const float* matrix = 0;
    surface_plain(hit->prim, prim[PRIM_MOD], hit->inst, hit->t, g);
    g->p = madd3(ray->dir, hit->t, ray->org);
    g->v = neg3(ray->dir);
    g->error_scale = MAX_(hit->t, as_float_(prim[PRIM_EXTENT]));

    float3 at = g->p;  // the point in the coordinates of the primitive
    if (in_instance(hit->inst)) {
        GLOBAL const float* record = instance_record(s, hit->inst);
        matrix = instance_matrix(s, record);
        at = affine_point(matrix, g->p);
        if (as_uint_(record[INST_MOD]) != NONE) g->mod = as_uint_(record[INST_MOD]);
        // the matrix rounds by the size of the point, traversal by the size of the tree
        g->error_scale = MAX_(MAX_(hit->t, record[INST_ERROR_SCALE]), fabs_(g->p.x) + fabs_(g->p.y) + fabs_(g->p.z));
    }

    g->flat = drawn_flat(s, g);
    surface_shape(s, prim, at, matrix, g);
    if ((prim[PRIM_KIND] & PRIM_KIND_MASK) == PRIM_SMOOTH) mesh_corners(s, prim, hit, g);

    if (matrix != 0) {  // mirrored instances keep their sides: the normal is mirrored with the geometry
        float3 n = affine_back(matrix, g->nface);
        float k = 1.0f / length3(n);
        g->nface = scale3(n, k);
        g->pert = scale3(affine_back(matrix, g->pert), k);
    }

    g->front = dot3(g->nface, g->v) > 0.0f;
    g->ng = g->front ? g->nface : neg3(g->nface);
    g->n = g->ng;
}

// Surfaces within this distance along the normal may coincide: a quarter of the least offset of a ray that leaves the
// surface (offset_ray.h).
#define SURFACE_ROUNDING 2.3841858e-7f  // 2^-22
FN float surface_rounding(PRIVATE(const Surface) g) {
    return SURFACE_ROUNDING *
           (g->error_scale + fabs_(g->ng.x * g->p.x) + fabs_(g->ng.y * g->p.y) + fabs_(g->ng.z * g->p.z));
}

// Returns 1 if the surface that a ray hits contains the ray's origin, within that distance.
FN int holds_origin(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, PRIVATE(const Hit) hit) {
    if (hit->prim == NO_HIT) return 0;
    Surface g;
    surface_at(s, ray, hit, &g);
    return hit->t * fabs_(dot3(ray->dir, g.ng)) <= surface_rounding(&g);
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
