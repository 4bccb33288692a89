// SPDX-License-Identifier: BSD-3-Clause
// Contrast over the levels of a pyramid, row by row (rammg.h).
#include "glare/rammg.h"
#include <algorithm>
#include <cmath>
#include "base/wide.h"
#include "glare/pyramid.h"

namespace glare {
namespace {

// sum |a[k] - b[k]| in eight lanes for the compiler's vectors, in short blocks so that float is precise enough.
WIDE_LOOP double difference(const float* a, const float* b, int n) {
    double sum = 0;
    for (int first = 0; first < n; first += 128) {
        const int count = std::min(128, n - first);
        float lane[8] = {};
        int k = 0;
        for (; k + 8 <= count; k += 8)
            for (int j = 0; j < 8; ++j) lane[j] += std::fabs(a[first + k + j] - b[first + k + j]);
        for (; k < count; ++k) lane[0] += std::fabs(a[first + k] - b[first + k]);
        for (float l : lane) sum += l;
    }
    return sum;
}

// Sum over the pairs of row r, column x and row s, column x + shift.
double pairs(const Level& level, const float* values, int r, int s, int shift) {
    double sum = 0;
    level.pairs(r, s, shift, [&](int x0, int x1) {
        sum +=
            difference(values + size_t(r) * level.width + x0, values + size_t(s) * level.width + x0 + shift, x1 - x0);
    });
    return sum;
}

// sum_i sum_j a_j |L_i - L_j| over ordered pairs of valid pixels: every unordered pair twice.
double ordered_sum(const Level& level, const float* values) {
    double edge = 0, corner = 0;
    for (int r = 0; r < level.height; ++r) {
        edge += pairs(level, values, r, r, 1);
        if (r + 1 == level.height) break;
        edge += pairs(level, values, r, r + 1, 0);
        corner += pairs(level, values, r, r + 1, 1) + pairs(level, values, r, r + 1, -1);
    }
    return 2 * (edge + std::sqrt(0.5) * corner);
}

// Part of ordered_sum whose centre pixel lies on the frame (such pixels lack some neighbours).
double border_sum(const Level& level, const float* values) {
    const int w = level.width, h = level.height;
    double edge = 0, corner = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; x += (y == 0 || y == h - 1) ? 1 : std::max(w - 1, 1))
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int nx = x + dx, ny = y + dy;
                    if (nx < 0 || ny < 0 || nx >= w || ny >= h) continue;
                    (dx && dy ? corner : edge) += std::fabs(values[size_t(y) * w + x] - values[size_t(ny) * w + nx]);
                }
    return edge + std::sqrt(0.5) * corner;
}

WIDE_LOOP void shrink_values(const float* from, int width, int height, std::vector<float>& out) {
    const int to_width = width / 2, to_height = height / 2;
    out.resize(size_t(to_width) * to_height);
    for (int r = 0; r < to_height; ++r) {
        const float* a = from + size_t(2 * r + height % 2) * width;
        const float* b = a + width;
        float* o = &out[size_t(r) * to_width];
        for (int x = 0; x < to_width; ++x) o[x] = ((a[2 * x] + a[2 * x + 1]) + (b[2 * x] + b[2 * x + 1])) * 0.25f;
    }
}

}  // namespace

double rammg(const Luminance& lum, const Pyramid& pyramid) {
    static thread_local std::vector<float> room[2];  // reused: allocation would take longer than the calculation
    const std::vector<Level>& levels = pyramid.levels;
    const RammgArea area = pyramid.area;
    const float* values = lum.grey;
    double total = 0;
    for (size_t k = 0; k < levels.size(); ++k) {
        const Level& level = levels[k];
        double sum = ordered_sum(level, values);
        if (area == RammgArea::interior || area == RammgArea::prototype_scale) sum -= border_sum(level, values);
        total += sum / level.pixels();
        if (k + 1 == levels.size()) break;
        shrink_values(values, level.width, level.height, room[k % 2]);
        values = room[k % 2].data();
    }
    return pyramid.contrast_of(total);
}

}  // namespace glare
