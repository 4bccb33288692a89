// SPDX-License-Identifier: BSD-3-Clause
// Look-ups of .cal programs: N-linear data arrays, pictures (data arrays of three channels) and text.
// A table is a record in the word arena (written by lib/cal/data.cpp and text.cpp); samples lie in the float arena.
//   data: dimensions, channels, index of the samples; per dimension, 4 words: count, first (float bits), step (float
//         bits), index of the positions in f or CAL_EVEN.  The last dimension varies fastest, then the channel.
//   text: lines; per line, 2 words: width, index of its characters (glyph count first); a character = start, glyph
//         record (0 = blank); glyph record = vertex count, x y ...
#ifndef LUX_CAL_DATA_H
#define LUX_CAL_DATA_H

#define CAL_MAX_DIMENSIONS 5u
#define CAL_EVEN 0xffffffffu

// Linear inside and up to one division outside; farther out it fades like 1/distance (spec: scene language 7.4).
FN void cal_interval(TABLES(const SceneTables) s, uint dim, float x, PRIVATE(uint) at, PRIVATE(float) c0,
                     PRIVATE(float) c1) {
    uint n = s->u[dim], positions = s->u[dim + 3u], low, high, mid;
    float first = as_float_(s->u[dim + 1u]), step = as_float_(s->u[dim + 2u]), t, a, b;

    if (positions == CAL_EVEN) {
        t = (x - first) / step;
        if (!(t >= 1.0f)) low = 0u;
        else if (t >= (float)(n - 1u)) low = n - 2u;
        else low = (uint)t;
    } else {
        low = 0u;
        high = n - 1u;
        int up = s->f[positions + high] >= s->f[positions];
        while (high - low > 1u) {
            mid = (low + high) / 2u;
            if (up ? x >= s->f[positions + mid] : x <= s->f[positions + mid]) low = mid;
            else high = mid;
        }
        a = s->f[positions + low];
        b = s->f[positions + low + 1u];
        t = (float)low + (x - a) / (b - a);
    }

    *at = low;
    a = t - (float)low;  // position within [low, low + 1]

    if (!(a <= 2.0f)) {
        *c0 = 1.0f / ((float)low - 1.0f - t);
        *c1 = -2.0f * *c0;
        if (!(a > 2.0f)) {
            *c0 = 0.0f;
            *c1 = 0.0f;
        }
    } else if (a < -1.0f) {
        *c1 = 1.0f / (t - (float)low);
        *c0 = -2.0f * *c1;
    } else {
        *c0 = 1.0f - a;
        *c1 = a;
    }
}

// Interpolates all channels (at most 3) at the coordinates x[0..dimensions-1].
FN void cal_data(TABLES(const SceneTables) s, uint table, PRIVATE(const float) x, PRIVATE(float) out) {
    uint dims = s->u[table], channels = s->u[table + 1u], samples = s->u[table + 2u], d, corner, k;
    uint at[CAL_MAX_DIMENSIONS];
    float c0[CAL_MAX_DIMENSIONS], c1[CAL_MAX_DIMENSIONS], sum[3];
    for (d = 0u; d < dims; d++) cal_interval(s, table + 3u + 4u * d, x[d], &at[d], &c0[d], &c1[d]);
    sum[0] = sum[1] = sum[2] = 0.0f;

    for (corner = 0u; corner < (1u << dims); corner++) {
        float w = 1.0f;
        uint index = 0u;
        for (d = 0u; d < dims; d++) {
            uint side = (corner >> (dims - 1u - d)) & 1u;
            w = w * (side ? c1[d] : c0[d]);
            index = index * s->u[table + 3u + 4u * d] + at[d] + side;
        }
        for (k = 0u; k < channels; k++) sum[k] += w * s->f[samples + index * channels + k];
    }

    for (k = 0u; k < channels; k++) out[k] = sum[k];
}

// Is (x, y) inside the glyph?  Even-odd; its corners are integers.
FN int cal_inside_glyph(TABLES(const SceneTables) s, uint glyph, float x, float y) {
    uint n = s->u[glyph];
    int inside = 0;
    if (n == 0u) return 0;
    float x0 = (float)(int)s->u[glyph + 2u * n - 1u], y0 = (float)(int)s->u[glyph + 2u * n];

    for (uint i = 0u; i < n; i++) {
        float x1 = (float)(int)s->u[glyph + 1u + 2u * i], y1 = (float)(int)s->u[glyph + 2u + 2u * i];
        if ((y0 > y) != (y1 > y)) {
            float cross = (x - x0) * (y1 - y0) - (x1 - x0) * (y - y0);
            if ((cross < 0.0f) == (y1 > y0)) inside = !inside;
        }
        x0 = x1;
        y0 = y1;
    }

    return inside;
}

// 1 where the text has ink: x in 1/255 of a cell from the line's start, row counted downwards.
FN float cal_text(TABLES(const SceneTables) s, uint table, float x, float row) {
    uint lines = s->u[table], line, chars, count, k;
    if (!(x >= 0.0f && x < 1e8f && row >= 0.0f && row < (float)lines)) return 0.0f;
    line = (uint)row;
    if (line >= lines) return 0.0f;
    if (x >= (float)(int)s->u[table + 1u + 2u * line]) return 0.0f;
    float y = ((float)line + 1.0f - row) * 255.0f;
    chars = s->u[table + 2u + 2u * line];
    count = s->u[chars];

    for (k = 0u; k < count; k++) {
        uint glyph = s->u[chars + 2u + 2u * k];
        float along = x - (float)(int)s->u[chars + 1u + 2u * k];
        if (glyph != 0u && along >= 0.0f && along < 256.0f && cal_inside_glyph(s, glyph, along, y)) return 1.0f;
    }

    return 0.0f;
}
#endif
