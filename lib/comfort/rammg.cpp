// SPDX-License-Identifier: BSD-3-Clause
// Contrast over the levels of a pyramid, row by row (rammg.h).
#include "comfort/rammg.h"
#include <algorithm>
#include <cmath>
#include "base/wide.h"

namespace comfort {
namespace {

// One level: rows of values and, per row, the stretches of columns that count.
struct Level {
    int width, height;
    const float* value;
    std::vector<Span> spans;
    std::vector<size_t> row;  // spans of row r: row[r] .. row[r+1]-1
};

// sum |a[k] - b[k]|, eight lanes so that the compiler can use vectors, in short stretches so that float is enough.
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

// Pairs between row r, column x and row s, column x + shift, where both count.
double pairs(const Level& level, int r, int s, int shift) {
    double sum = 0;
    size_t b = level.row[s];
    for (size_t a = level.row[r]; a < level.row[r + 1]; ++a) {
        while (b < level.row[s + 1] && level.spans[b].end - shift <= level.spans[a].begin) ++b;
        for (size_t c = b; c < level.row[s + 1] && level.spans[c].begin - shift < level.spans[a].end; ++c) {
            const int x0 = std::max(level.spans[a].begin, level.spans[c].begin - shift);
            const int x1 = std::min(level.spans[a].end, level.spans[c].end - shift);
            if (x0 < x1)
                sum += difference(level.value + size_t(r) * level.width + x0,
                                  level.value + size_t(s) * level.width + x0 + shift, x1 - x0);
        }
    }
    return sum;
}

// sum_i sum_j a_j |L_i - L_j| over ordered pairs that both count: every unordered pair twice.
double ordered_sum(const Level& level) {
    double edge = 0, corner = 0;
    for (int r = 0; r < level.height; ++r) {
        edge += pairs(level, r, r, 1);
        if (r + 1 == level.height) break;
        edge += pairs(level, r, r + 1, 0);
        corner += pairs(level, r, r + 1, 1) + pairs(level, r, r + 1, -1);
    }
    return 2 * (edge + std::sqrt(0.5) * corner);
}

// The share of ordered_sum whose centre pixel lies on the frame (such pixels lack some of their neighbours).
double border_sum(const Level& level) {
    const int w = level.width, h = level.height;
    double edge = 0, corner = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; x += (y == 0 || y == h - 1) ? 1 : std::max(w - 1, 1))
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int nx = x + dx, ny = y + dy;
                    if (nx < 0 || ny < 0 || nx >= w || ny >= h) continue;
                    (dx && dy ? corner : edge) +=
                        std::fabs(level.value[size_t(y) * w + x] - level.value[size_t(ny) * w + nx]);
                }
    return edge + std::sqrt(0.5) * corner;
}

// Rows and columns count from the bottom left: of an odd number the top row and the right column are dropped.
void shrink_spans(const Level& from, Level& to) {
    to.spans.clear();
    to.row.clear();
    for (int r = 0; r < to.height; ++r) {
        to.row.push_back(to.spans.size());
        const int top = 2 * r + from.height % 2;
        for (size_t a = from.row[top]; a < from.row[top + 1]; ++a)
            for (size_t c = from.row[top + 1]; c < from.row[top + 2]; ++c) {
                const int x0 = std::max(from.spans[a].begin, from.spans[c].begin),
                          x1 = std::min(from.spans[a].end, from.spans[c].end);
                const int p0 = (x0 + 1) / 2, p1 = std::min(x1 / 2, to.width);
                if (p0 < p1) to.spans.push_back({p0, p1});
            }
    }
    to.row.push_back(to.spans.size());
}

WIDE_LOOP void shrink_values(const Level& from, int width, int height, std::vector<float>& out) {
    out.resize(size_t(width) * height);
    for (int r = 0; r < height; ++r) {
        const float* a = from.value + size_t(2 * r + from.height % 2) * from.width;
        const float* b = a + from.width;
        float* o = &out[size_t(r) * width];
        for (int x = 0; x < width; ++x) o[x] = ((a[2 * x] + a[2 * x + 1]) + (b[2 * x] + b[2 * x + 1])) * 0.25f;
    }
}

}  // namespace

double rammg(const Luminance& lum, const Geometry& geometry, RammgArea area) {
    Level level{lum.width, lum.height, lum.grey, geometry.spans, geometry.row_spans};
    if (area != RammgArea::view) {
        level.spans.assign(lum.height, {0, lum.width});
        level.row.resize(lum.height + 1);
        for (int r = 0; r <= lum.height; ++r) level.row[r] = r;
    }
    std::vector<float> values[2];
    double total = 0;
    int levels = 0;
    while (std::min(level.width, level.height) > 2) {
        double n = 0;
        for (const Span& s : level.spans) n += s.end - s.begin;
        if (n == 0) break;
        double sum = ordered_sum(level);
        if (area == RammgArea::interior || area == RammgArea::prototype_scale) sum -= border_sum(level);
        total += sum / n;
        ++levels;
        Level next{level.width / 2, level.height / 2, nullptr, {}, {}};
        std::vector<float>& room = values[levels % 2];
        shrink_values(level, next.width, next.height, room);
        next.value = room.data();
        shrink_spans(level, next);
        level = std::move(next);
    }
    const double scale = cdm2_per_grey / (4 + 2 * std::sqrt(2.0)) / (area == RammgArea::prototype_scale ? 1 : 8);
    return total * scale / levels;  // 0/0 is nan: the picture was too small
}

}  // namespace comfort
