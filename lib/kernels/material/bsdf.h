// SPDX-License-Identifier: BSD-3-Clause
// Look-up of tabulated BSDFs (BsdfTable of records.h, written by flatten/bsdf.cpp).  A table is evaluated for a
// direction v toward the viewer, which sampling keeps, and l toward the light; both unit, in the surface's frame (x, y,
// n), both away from the surface. No interpolation: values are constant in a cell, as in RADIANCE.
//   matrix  Klems' patches; rows of cumulative f times projected solid angle (Klems 1994)
//   tree    tensor trees over the unit square's image of the disc (Shirley & Chiu 1997; Ward et al. 2012)
#ifndef LUX_BSDF_H
#define LUX_BSDF_H

// The disc as a square and back (Shirley & Chiu 1997), areas in proportion.
FN float2 bsdf_square(float x, float y) {
    float r = sqrt_(x * x + y * y), a, b;
    float phi = k_atan2(y, x) * 1.27323954f;  // in eighths of a turn
    if (phi < -1.0f) phi += 8.0f;
    if (phi < 1.0f) {
        a = r;
        b = phi * r;
    } else if (phi < 3.0f) {
        b = r;
        a = (2.0f - phi) * r;
    } else if (phi < 5.0f) {
        a = -r;
        b = (4.0f - phi) * r;
    } else {
        b = -r;
        a = (phi - 6.0f) * r;
    }

    float2 q;
    q.x = MIN_(MAX_(0.5f + 0.5f * a, 0.0f), 0.99999994f);
    q.y = MIN_(MAX_(0.5f + 0.5f * b, 0.0f), 0.99999994f);
    return q;
}

FN float2 bsdf_disc(float sx, float sy) {
    float a = 2.0f * sx - 1.0f, b = 2.0f * sy - 1.0f, r, phi, sn, cs;
    if (a > -b) {
        if (a > b) {
            r = a;
            phi = b / a;
        } else {
            r = b;
            phi = 2.0f - a / b;
        }
    } else {
        if (a < b) {
            r = -a;
            phi = 4.0f + b / a;
        } else {
            r = -b;
            phi = b != 0.0f ? 6.0f - a / b : 0.0f;
        }
    }

    k_sincos(phi * 0.78539816f, &sn, &cs);
    float2 d;
    d.x = r * cs;
    d.y = r * sn;
    return d;
}

FN float bsdf_height(float x, float y) {
    float z2 = 1.0f - x * x - y * y;
    return sqrt_(MAX_(z2, 0.0f));
}

// ---- matrices
FN uint basis_cell(GLOBAL const BsdfRing* ring, uint rings, float x, float y, float z) {
    uint k = 0u;
    z = fabs_(z);
    while (k + 1u < rings && z <= ring[k + 1u].low) k++;
    ring += k;
    int count = (int)ring->cells;
    int i = (int)floor_(k_atan2(y, x) * 0.159154943f * (float)count + 0.5f);
    if (i < 0) i += count;
    if (i >= count) i -= count;
    return ring->first + (uint)i;
}

// A direction in a cell, uniform in projected solid angle: in the squared cosine and the azimuth.
FN float3 basis_direction(GLOBAL const BsdfRing* ring, uint rings, uint cell, float2 x) {
    uint k = 0u;
    while (k + 1u < rings && cell >= ring[k + 1u].first) k++;
    ring += k;
    float c0 = ring->low, c1 = ring->high, sn, cs;
    float z2 = c0 * c0 + (c1 * c1 - c0 * c0) * x.x;
    float r = sqrt_(MAX_(1.0f - z2, 0.0f));
    k_sincos(((float)(cell - ring->first) + x.y - 0.5f) * K_TURN / (float)ring->cells, &sn, &cs);
    return F3(r * cs, r * sn, sqrt_(MAX_(z2, 0.0f)));
}

// Incident directions are numbered from the far side, so that cell i transmits straight into cell i (swap: the other
// way).
FN uint bsdf_v_cell(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v) {
    float k = table->swap != 0u ? 1.0f : -1.0f;
    return basis_cell(s->bsdf_rings + table->v_rings_at, table->v_rings, k * v.x, k * v.y, v.z);
}

FN uint bsdf_l_cell(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 l) {
    float k = table->swap != 0u ? -1.0f : 1.0f;
    return basis_cell(s->bsdf_rings + table->l_rings_at, table->l_rings, k * l.x, k * l.y, l.z);
}

// ---- trees
// The incident coordinate of an isotropic tree; a direction on the edge of two cells (which single precision cannot
// keep apart) belongs to the outer one.
FN float tree_radius(float3 from) {
    float c = 0.5f - 0.5f * sqrt_(from.x * from.x + from.y * from.y) - 2e-8f;
    return MIN_(MAX_(c, 0.0f), 0.49999997f);
}

// Coordinates of a pair of directions in the cube; c[3] is not used in three dimensions.
FN void tree_coordinates(GLOBAL const BsdfTable* table, float3 v, float3 l, PRIVATE(float) c) {
    float3 from = table->swap != 0u ? l : v, out = table->swap != 0u ? v : l;
    float2 q;

    if (table->kind == BSDF_TREE4) {
        q = bsdf_square(-from.x, -from.y);
        c[0] = q.x;
        c[1] = q.y;
        q = bsdf_square(out.x, out.y);
        c[2] = q.x;
        c[3] = q.y;
        return;
    }

    float r = sqrt_(from.x * from.x + from.y * from.y);
    float cs = r > 0.0f ? -from.x / r : 1.0f, sn = r > 0.0f ? -from.y / r : 0.0f;
    q = bsdf_square(out.x * cs + out.y * sn, out.y * cs - out.x * sn);
    c[0] = tree_radius(from);
    c[1] = q.x;
    c[2] = q.y;
    c[3] = 0.0f;
}

FN float tree_value(TABLES(const SceneTables) s, uint values, uint children, int dims, PRIVATE(const float) at,
                    PRIVATE(float) width) {
    float c[4];
    uint node = 0u;
    for (int k = 0; k < 4; k++) c[k] = at[k];
    *width = 1.0f;

    for (;;) {
        uint next = s->u[children + node];
        if (next == NONE) return s->f[values + node];
        for (int k = 0; k < dims; k++) {
            c[k] *= 2.0f;
            if (c[k] >= 1.0f) {
                c[k] -= 1.0f;
                next += 1u << k;
            }
        }
        node = next;
        *width *= 0.5f;
    }
}

FN uint tree_v_cell(GLOBAL const BsdfTable* table, float3 v) {
    float n = (float)table->v_grid;
    if (table->kind == BSDF_TREE3) return (uint)(tree_radius(v) * n);
    float k = table->swap != 0u ? 1.0f : -1.0f;
    float2 q = bsdf_square(k * v.x, k * v.y);
    return (uint)(q.x * n) + table->v_grid * (uint)(q.y * n);
}

// ---- one face for both
FN uint bsdf_cell(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v) {
    return table->kind == BSDF_MATRIX ? bsdf_v_cell(s, table, v) : tree_v_cell(table, v);
}

FN float bsdf_hemispherical(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v) {
    return s->f[table->hemi + bsdf_cell(s, table, v)];
}

// f(v, l) without its Lambertian part, 1/sr; *psa: projected solid angle of the pair's (smaller) cell.
FN float bsdf_value(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, float3 l,
                    PRIVATE(float) psa) {
    if (table->kind == BSDF_MATRIX) {
        uint i = bsdf_v_cell(s, table, v), o = bsdf_l_cell(s, table, l);
        *psa = MIN_(s->f[table->v_psa + i], s->f[table->l_psa + o]);
        return s->f[table->values + i * table->l_cells + o];
    }

    float c[4], w;
    tree_coordinates(table, v, l, c);
    float f = tree_value(s, table->values, table->children, (int)table->dims, c, &w);
    *psa = K_PI * w * w;
    return f;
}

// RGB of f(v, l) for luminance 1 (RADIANCE's primaries).
FN float3 bsdf_color(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, float3 l) {
    if (table->kind == BSDF_MATRIX) {
        if (table->rgb == NONE) return F3(1.0f, 1.0f, 1.0f);
        GLOBAL const float* q =
            s->f + table->rgb + 3u * (bsdf_v_cell(s, table, v) * table->l_cells + bsdf_l_cell(s, table, l));
        return f3_at(q);
    }

    if (table->u_children == NONE) return F3(1.0f, 1.0f, 1.0f);
    float c[4], w;
    tree_coordinates(table, v, l, c);
    float u1 = tree_value(s, table->u_values, table->u_children, (int)table->dims, c, &w),
          v1 = tree_value(s, table->v_values, table->v_children, (int)table->dims, c, &w);
    if (v1 <= 1e-6f) return F3(1.0f, 1.0f, 1.0f);
    float X = 2.25f * u1 / v1, Z = (3.0f - 0.75f * u1) / v1 - 5.0f;  // CIE 1976 u'v' to X/Y, Z/Y
    return F3(MAX_(2.56531284f * X - 1.16684962f - 0.39846323f * Z, 0.0f),
              MAX_(-1.02210817f * X + 1.97828662f + 0.04382156f * Z, 0.0f),
              MAX_(0.07472438f * X - 0.25193957f + 1.17721519f * Z, 0.0f));
}
#endif
