// SPDX-License-Identifier: BSD-3-Clause
// Eight pictures at a time, a pixel of all of them side by side.  A row of a level is gone when the next one has been
// compared with it and the row of the level below is made of both: all that is worked on stays in the cache.
#include "comfort/swayed_rammg.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "comfort/lanes.h"
#include "comfort/pyramid.h"

namespace comfort {
namespace {

struct alignas(4 * lanes) Pixel {  // what a vector asks for depends on the processor a function is for
    Floats of_picture;
};
using Sum = std::array<double, lanes>;
struct Contrast {
    Sum edge{}, corner{};
};

#define DIFFERENCE(a, b) Floats(Words((a) - (b)) & 0x7fffffffu)  // without its sign

inline __attribute__((always_inline)) void add(const Floats& from, Sum& to) {
    float values[lanes];
    std::memcpy(values, &from, sizeof values);
    for (int k = 0; k < lanes; ++k) to[size_t(k)] += double(values[k]);
}

// Short stretches, so that float is enough.
constexpr int stretch = 32;

WIDE_LOOP void add_pairs(const Pixel* a, const Pixel* b, int n, Sum& to) {
    for (int first = 0; first < n; first += stretch) {
        Floats sum = {};
        for (int i = first; i < std::min(n, first + stretch); ++i) sum += DIFFERENCE(a[i].of_picture, b[i].of_picture);
        add(sum, to);
    }
}

// The pixels of `here` with the one to the right, the one below, and those beside that.
WIDE_LOOP void add_all_pairs(const Pixel* here, const Pixel* below, int n, Contrast& to) {
    for (int first = 0; first < n; first += stretch) {
        Floats edge = {}, corner = {};
        const auto add_pixel = [&](const Floats& own, const Floats& next, const Floats& left, const Floats& middle,
                                   const Floats& right) __attribute__((always_inline)) {
            edge += DIFFERENCE(own, next) + DIFFERENCE(own, middle);
            corner += DIFFERENCE(own, left) + DIFFERENCE(own, right);
        };
        Floats own = here[first].of_picture, left = below[first - 1].of_picture, middle = below[first].of_picture;
        int i = first;
        for (const int end = std::min(n, first + stretch); i + 1 < end; i += 2) {  // two: nothing is moved on
            const Floats next = here[i + 1].of_picture, right = below[i + 1].of_picture;
            add_pixel(own, next, left, middle, right);
            own = here[i + 2].of_picture, left = right;
            const Floats last = below[i + 2].of_picture;
            add_pixel(next, own, middle, right, last);
            middle = last;
        }
        if (i < n && i < first + stretch) add_pixel(own, here[i + 1].of_picture, left, middle, below[i + 1].of_picture);
        add(edge, to.edge);
        add(corner, to.corner);
    }
}

WIDE_LOOP void shrink(const Pixel* a, const Pixel* b, int n, Pixel* out) {
    for (int x = 0; x < n; ++x)
        out[x].of_picture =
            ((a[2 * x].of_picture + a[2 * x + 1].of_picture) + (b[2 * x].of_picture + b[2 * x + 1].of_picture)) * 0.25f;
}

// Pictures first to first + 7 of n pixels.
WIDE_LOOP void show(const Swayed& s, size_t start, int n, int first, Pixel* out) {
    const float *mean = s.mean + start, *off = s.off + start;
    const uint8_t* pattern = s.pattern + start;
    const auto* flips = s.signs->flip.data();
    for (int x = 0; x < n; ++x) {
        Words flip;
        std::memcpy(&flip, flips[pattern[x]].data() + first, sizeof flip);
        uint32_t bits;
        std::memcpy(&bits, off + x, sizeof bits);
        out[x].of_picture = Floats(flip ^ bits) + mean[x];
    }
}

class Walk {
public:
    explicit Walk(const std::vector<Level>& levels) : levels_(levels), sums_(levels.size()) {
        for (const Level& l : levels)
            for (int k = 0; k < 2; ++k) rows_.emplace_back(size_t(l.width));
    }
    Pixel* row(size_t level, int r) { return rows_[2 * level + size_t(r & 1)].data(); }

    // Row r of a level is there, and so are those before it.
    void take(size_t k, int r) {
        const Level& level = levels_[k];
        if (r > 0) compare(k, r - 1);
        if (r + 1 == level.height)
            level.pairs(r, r, 1, [&](int x0, int x1) { pairs(k, r, r, 1, x0, x1, sums_[k].edge); });
        const int odd = level.height % 2;
        if (k + 1 == levels_.size() || r - odd < 1 || (r - odd) % 2 == 0) return;
        const int half = (r - odd) / 2;
        const Level& next = levels_[k + 1];
        for (size_t s = next.row[size_t(half)]; s < next.row[size_t(half) + 1]; ++s) {
            const Span span = next.spans[s];
            shrink(row(k, r - 1) + 2 * span.begin, row(k, r) + 2 * span.begin, span.end - span.begin,
                   row(k + 1, half) + span.begin);
        }
        take(k + 1, half);
    }
    Sum total() const {
        Sum out{};
        for (size_t k = 0; k < levels_.size(); ++k)
            for (size_t j = 0; j < lanes; ++j)
                out[j] += 2 * (sums_[k].edge[j] + std::sqrt(0.5) * sums_[k].corner[j]) / levels_[k].pixels();
        return out;
    }

private:
    void pairs(size_t k, int r, int s, int shift, int x0, int x1, Sum& to) {
        if (x0 < x1) add_pairs(row(k, r) + x0, row(k, s) + x0 + shift, x1 - x0, to);
    }
    // Of row r with itself and with the next one: where all four neighbours count, as nearly everywhere, at once.
    void compare(size_t k, int r) {
        const Level& level = levels_[k];
        int begin = 0, end = 0;
        if (level.row[r] + 1 == level.row[r + 1] && level.row[r + 1] + 1 == level.row[r + 2]) {
            const Span a = level.spans[level.row[r]], b = level.spans[level.row[r + 1]];
            begin = std::max(a.begin, b.begin + 1), end = std::max(begin, std::min(a.end, b.end) - 1);
            add_all_pairs(row(k, r) + begin, row(k, r + 1) + begin, end - begin, sums_[k]);
        }
        const auto rest = [&](int s, int shift, Sum& to) {
            level.pairs(r, s, shift, [&](int x0, int x1) {
                pairs(k, r, s, shift, x0, std::min(x1, begin), to);
                pairs(k, r, s, shift, std::max(x0, end), x1, to);
            });
        };
        rest(r, 1, sums_[k].edge);
        rest(r + 1, 0, sums_[k].edge);
        rest(r + 1, 1, sums_[k].corner);
        rest(r + 1, -1, sums_[k].corner);
    }

    const std::vector<Level>& levels_;
    std::vector<std::vector<Pixel>> rows_;  // of each level the last two
    std::vector<Contrast> sums_;
};

}  // namespace

std::array<double, Signs::most> rammg(const Swayed& pictures, const Geometry& geometry, RammgArea area) {
    const std::vector<Level> levels = pyramid(geometry, area);
    std::array<double, Signs::most> out{};
    for (int first = 0; first < pictures.count(); first += lanes) {
        Walk walk(levels);
        for (int r = 0; r < pictures.height && !levels.empty(); ++r) {
            for (size_t s = levels[0].row[size_t(r)]; s < levels[0].row[size_t(r) + 1]; ++s) {
                const Span span = levels[0].spans[s];
                const size_t start = size_t(r) * size_t(pictures.width) + size_t(span.begin);
                show(pictures, start, span.end - span.begin, first, walk.row(0, r) + span.begin);
            }
            walk.take(0, r);
        }
        const Sum total = walk.total();
        for (size_t k = 0; k < lanes; ++k) out[size_t(first) + k] = contrast_of(total[k], levels.size(), area);
    }
    return out;
}

}  // namespace comfort
