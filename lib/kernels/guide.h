// SPDX-License-Identifier: BSD-3-Clause
// Directions for diffuse light by what was learned of it before the first frame (trace/guide.h): in each cell of a
// grid, one for every side that a surface may face, a chance for each bin of the hemisphere.  The bins are equal
// squares on Shirley and Chiu's concentric map (1997), so that a bin without knowledge is sampled by the cosine, and
// the weight of a sample is one division.  Whatever the chances are, the mean is right, for none is 0.
#ifndef LUX_GUIDE_H
#define LUX_GUIDE_H

// SceneTables.guide: a hash table of Params.guide_mask + 1 entries, then the cells' chances.
#define GUIDE_ENTRY 2u             // words: key of a cell, NONE if empty; where its record begins
#define GUIDE_CELLS_A_SIDE 512.0f  // of the grid
// The key of a cell: its place in the grid and, in the lowest bits, the side that the surface faces.
#define GUIDE_X 21u
#define GUIDE_Y 12u
#define GUIDE_Z 3u

// record of a cell
#define GUIDE_SIDE 0u     // bins a side
#define GUIDE_LIGHT 1u    // mean luminance of the light that comes in, less that of sources (float)
#define GUIDE_CHANCES 2u  // of the bins
// Chances are 16-bit numbers, two a word: for bins a side of n the n rows' beginnings in 0 .. GUIDE_ONE, then for each
// row its columns'.
#define GUIDE_ONE 65536.0f
#define GUIDE_WORDS(n) (((n) + (n) * (n)) / 2u)

// The cell of a point on a surface with normal n; NONE outside the grid.
FN uint guide_key(UNIFORM(const Params) par, float3 p, float3 n) {
    float3 at = scale3(sub3(p, xyz4(par->guide_grid)), par->guide_grid.w);
    if (!(MIN_(at.x, MIN_(at.y, at.z)) >= 0.0f && MAX_(at.x, MAX_(at.y, at.z)) < GUIDE_CELLS_A_SIDE)) return NONE;

    float x = fabs_(n.x), y = fabs_(n.y), z = fabs_(n.z);
    uint side = x >= y && x >= z ? (n.x < 0.0f ? 0u : 1u) : y >= z ? (n.y < 0.0f ? 2u : 3u) : n.z < 0.0f ? 4u : 5u;
    return (uint)at.x << GUIDE_X | (uint)at.y << GUIDE_Y | (uint)at.z << GUIDE_Z | side;
}

// Where its record begins; NONE: nothing was learned there.
FN uint guide_find(SHARED(const SceneTables) s, UNIFORM(const Params) par, uint key) {
    for (uint i = hash32(key);; i++) {
        GLOBAL const uint* entry = s->guide + GUIDE_ENTRY * (i & par->guide_mask);
        if (entry[0] == key && key != NONE) return entry[1];
        if (entry[0] == NONE) return NONE;
    }
}

FN float guide_begin(GLOBAL const uint* chances, uint k) {
    return (float)(k % 2u == 0u ? chances[k / 2u] & 0xffffu : chances[k / 2u] >> 16);
}

// Which of n bins x falls in; *x becomes its place inside.  Returns the bin's chance.  All beginnings are looked at:
// a search that halves them takes longer, for no processor can foresee its turns.
FN float guide_pick(GLOBAL const uint* chances, uint n, PRIVATE(float) x, PRIVATE(uint) bin) {
    float r = *x * GUIDE_ONE;
    uint whole = (uint)r, begun = 0u;
    for (uint i = 0u; i < n / 2u; i++) {
        uint two = chances[i];
        begun += ((two & 0xffffu) <= whole ? 1u : 0u) + (two >> 16 <= whole ? 1u : 0u);
    }

    uint k = begun - 1u;
    float begin = guide_begin(chances, k);
    float width = (begun < n ? guide_begin(chances, begun) : GUIDE_ONE) - begin;
    *x = (r - begin) / width;
    *bin = k;
    return width * (1.0f / GUIDE_ONE);
}

// The direction about n of a point of the unit square, which is the hemisphere by its cosine.
FN float3 guide_direction(float3 n, float x, float y) {
    float u = 2.0f * x - 1.0f, v = 2.0f * y - 1.0f;
    float r = u, turn = 0.0f, sn, cs;
    if (fabs_(u) > fabs_(v)) {
        turn = 0.125f * (v / u);
    } else if (v != 0.0f) {
        r = v;
        turn = 0.25f - 0.125f * (u / v);
    }

    float3 e1, e2;
    float z2 = 1.0f - r * r;
    frame_of(n, &e1, &e2);
    k_sincos(K_TURN * turn, &sn, &cs);
    return unit3(add3(scale3(n, sqrt_(MAX_(z2, 0.0f))), add3(scale3(e1, r * cs), scale3(e2, r * sn))));
}

FN float guide_light(SHARED(const SceneTables) s, uint cell) { return as_float_(s->guide[cell + GUIDE_LIGHT]); }

// The chance of the bin in which dir lies: the map backwards.
FN float guide_chance(GLOBAL const uint* chances, uint side, float3 n, float3 dir) {
    float3 e1, e2;
    frame_of(n, &e1, &e2);
    float a = dot3(dir, e1), b = dot3(dir, e2);
    float r = sqrt_(a * a + b * b), u = 0.0f, v = 0.0f;
    if (fabs_(a) > fabs_(b)) {
        u = a < 0.0f ? -r : r;
        v = 4.0f * K_INV_PI * u * k_atan(b / a);
    } else if (b != 0.0f) {
        v = b < 0.0f ? -r : r;
        u = 4.0f * K_INV_PI * v * k_atan(a / b);
    }

    float bins = (float)side;
    float x = 0.5f * (u + 1.0f) * bins, y = 0.5f * (v + 1.0f) * bins;
    uint row = MIN_((uint)MAX_(x, 0.0f), side - 1u), column = MIN_((uint)MAX_(y, 0.0f), side - 1u);
    GLOBAL const uint* columns = chances + (side + side * row) / 2u;
    float row_end = row + 1u < side ? guide_begin(chances, row + 1u) : GUIDE_ONE;
    float column_end = column + 1u < side ? guide_begin(columns, column + 1u) : GUIDE_ONE;
    float in_row = row_end - guide_begin(chances, row), in_column = column_end - guide_begin(columns, column);
    return in_row * (1.0f / GUIDE_ONE) * (in_column * (1.0f / GUIDE_ONE));
}

// A direction by the chances of the bins.  Returns its bin's.
FN float guide_bin(GLOBAL const uint* chances, uint side, float3 n, float2 r, PRIVATE(float3) dir) {
    uint row, column;
    float x = r.x, y = r.y;
    float chance = guide_pick(chances, side, &x, &row);
    chance *= guide_pick(chances + (side + side * row) / 2u, side, &y, &column);
    float bins = (float)side;
    *dir = guide_direction(n, ((float)row + x) / bins, ((float)column + y) / bins);
    return chance;
}

// Samples a direction over the hemisphere of n at p by a cell's chances, a share of them toward highlights.  Returns
// cos/(pi density).
FN float guide_sample(SHARED(const SceneTables) s, UNIFORM(const Params) par, uint cell, float3 p, float3 n, float2 r,
                      PRIVATE(float3) dir) {
    uint side = s->guide[cell + GUIDE_SIDE];
    GLOBAL const uint* chances = s->guide + cell + GUIDE_CHANCES;
    float bins = (float)side * (float)side, shine = par->highlight_share;
    uint met = shine > 0.0f ? highlights_met(s, par, p, n) : 0u;
    if (met == 0u) return 1.0f / (guide_bin(chances, side, n, r, dir) * bins);

    int shines = r.x < shine;
    float chance = 0.0f;
    if (shines) {
        *dir = highlight_direction(s, par, met, r.x / shine, r.y);
    } else {
        r.x = MIN_((r.x - shine) / (1.0f - shine), 0.99999994f);
        chance = guide_bin(chances, side, n, r, dir);
    }

    float c = dot3(*dir, n), bright = highlights_density(s, par, met, *dir);
    if (!(c > 0.0f) || (shines && !(bright > 0.0f))) return 0.0f;
    if (shines) chance = guide_chance(chances, side, n, *dir);
    return c * K_INV_PI / ((1.0f - shine) * chance * bins * c * K_INV_PI + shine * bright);
}

// The cell that guides at p: that of a place nearby, so that cells show no borders; else p's own.
FN uint guide_cell(SHARED(const SceneTables) s, UNIFORM(const Params) par, float3 p, float3 n,
                   PRIVATE(const Sampler) rnd) {
    float3 e1, e2;
    float size = 1.0f / par->guide_grid.w;
    uint r = hash32(rnd->key ^ hash32(rnd->index ^ hash32(rnd->dim)));
    frame_of(n, &e1, &e2);
    float x = (float)(r & 0xffffu) * (1.0f / GUIDE_ONE) - 0.5f, y = (float)(r >> 16) * (1.0f / GUIDE_ONE) - 0.5f;
    float3 nearby = madd3(e1, x * size, madd3(e2, y * size, p));

    uint cell = guide_find(s, par, guide_key(par, nearby, n));
    return cell != NONE ? cell : guide_find(s, par, guide_key(par, p, n));
}
#endif
