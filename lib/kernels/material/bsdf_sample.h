// SPDX-License-Identifier: BSD-3-Clause
// Directions drawn from the tables of bsdf.h: by a matrix's cumulative rows, or down a tree by the means of its nodes.
#ifndef LUX_BSDF_SAMPLE_H
#define LUX_BSDF_SAMPLE_H

// A cell of l by the matrix's row of v, and a direction in it.
FN float matrix_sample(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, float pick, float2 place,
                       PRIVATE(float3) l) {
    uint cells = table->l_cells, low = 0u;
    uint high = cells - 1u;
    GLOBAL const float* sums = s->f + table->sums + bsdf_v_cell(s, table, v) * cells;
    float total = sums[cells - 1u];
    float x = pick * total;
    if (total <= 0.0f) return 0.0f;

    while (low < high) {
        uint mid = (low + high) >> 1;
        if (sums[mid] > x) high = mid;
        else low = mid + 1u;
    }

    *l = basis_direction(s->bsdf_rings + table->l_rings_at, table->l_rings, low, place);
    if (table->swap != 0u) {
        l->x = -l->x;
        l->y = -l->y;
    }

    return total;
}

// The leaf of a tree for one random number, v given.
STRUCT(TreeLeaf) {
    float value;                      // f there
    float prob;                       // product of the choices down to it
    float corner_x, corner_y, width;  // of its square
};

// Chooses one of four children by their means; *x becomes the rest of the random number.  Returns 4 if all means are 0.
FN uint tree_child(GLOBAL const float* mean, int first, PRIVATE(float) x, PRIVATE(float) prob) {
    float m[4], sum = 0.0f;
    for (uint k = 0u; k < 4u; k++) {
        m[k] = mean[k << first];
        sum += m[k];
    }

    if (sum <= 0.0f) return 4u;

    float r = *x * sum;
    uint k = 0u, last = m[3] > 0.0f ? 3u : m[2] > 0.0f ? 2u : m[1] > 0.0f ? 1u : 0u;
    while (k < last && r >= m[k]) {
        r -= m[k];
        k++;
    }

    *x = m[k] > 0.0f ? MIN_(r / m[k], 0.99999994f) : 0.0f;
    *prob *= m[k] / sum;
    return k;
}

// Descends the tree: v's dimensions are given, the two from `first` on are chosen by the children's means over v's half
// of the cube.  Returns 0 if all means are 0.
FN int tree_descend(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, int first, float pick,
                    PRIVATE(TreeLeaf) leaf) {
    float c[4], x = pick;
    int dims = (int)table->dims;
    uint node = 0u;
    leaf->prob = 1.0f;
    leaf->corner_x = 0.0f;
    leaf->corner_y = 0.0f;
    leaf->width = 1.0f;
    tree_coordinates(table, v, F3(0.0f, 0.0f, 1.0f), c);

    for (;;) {
        uint next = s->u[table->children + node];
        if (next == NONE) break;
        for (int k = 0; k < dims; k++) {
            if (k == first || k == first + 1) continue;
            c[k] *= 2.0f;
            if (c[k] >= 1.0f) {
                c[k] -= 1.0f;
                next += 1u << k;
            }
        }
        uint child = tree_child(s->f + table->values + next, first, &x, &leaf->prob);
        if (child == 4u) return 0;
        leaf->width *= 0.5f;
        if ((child & 1u) != 0u) leaf->corner_x += leaf->width;
        if ((child & 2u) != 0u) leaf->corner_y += leaf->width;
        node = next + (child << first);
    }

    leaf->value = s->f[table->values + node];
    return 1;
}

FN float tree_sample(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, float pick, float2 place,
                     PRIVATE(float3) l) {
    int four = table->kind == BSDF_TREE4, swap = table->swap != 0u;
    if (!four && swap) {  // no dimension of the tree is v's: uniform in projected solid angle
        float2 d = bsdf_disc(place.x, place.y);
        float psa;
        *l = F3(d.x, d.y, bsdf_height(d.x, d.y));
        return K_PI * bsdf_value(s, table, v, *l, &psa);
    }

    TreeLeaf leaf;
    if (!tree_descend(s, table, v, four && !swap ? 2 : four ? 0 : 1, pick, &leaf)) return 0.0f;
    float2 d = bsdf_disc(leaf.corner_x + leaf.width * place.x, leaf.corner_y + leaf.width * place.y);

    if (!four) {  // turned with v's azimuth
        float r = sqrt_(v.x * v.x + v.y * v.y);
        float cs = r > 0.0f ? -v.x / r : 1.0f, sn = r > 0.0f ? -v.y / r : 0.0f;
        float dx = d.x * cs - d.y * sn;
        d.y = d.y * cs + d.x * sn;
        d.x = dx;
    } else if (swap) {
        d.x = -d.x;
        d.y = -d.y;
    }

    *l = F3(d.x, d.y, bsdf_height(d.x, d.y));
    return leaf.prob > 0.0f ? K_PI * leaf.value * leaf.width * leaf.width / leaf.prob : 0.0f;
}

// Samples an l for v, on the +z side.  Returns f cos / pdf, whose mean is the hemispherical value (for matrices each
// is); 0 = none.
FN float bsdf_sample(TABLES(const SceneTables) s, GLOBAL const BsdfTable* table, float3 v, PRIVATE(Sampler) rnd,
                     PRIVATE(float3) l) {
    float2 pick = sample2(rnd), place = sample2(rnd);
    if (table->kind == BSDF_MATRIX) return matrix_sample(s, table, v, pick.x, place, l);
    return tree_sample(s, table, v, pick.x, place, l);
}
#endif
