// SPDX-License-Identifier: BSD-3-Clause
// The pixels themselves are summed by words (swayed_pairs.h).  The levels below have eight pictures at a time, a pixel
// of all of them side by side.  A row of a level is gone when the next one has been compared with it and the row of the
// level below is made of both: all that is worked on stays in the cache.
#include "comfort/swayed_rammg.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "comfort/lanes.h"
#include "comfort/pyramid.h"
#include "comfort/swayed_pairs.h"

namespace comfort {
namespace {

struct alignas(4 * lanes) Pixel {  // what a vector asks for depends on the processor a function is for
    Floats of_picture;
};
using Sum = std::array<double, lanes>;
struct Contrast {
    Sum edge{}, corner{};
};

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
        for (int i = first; i < std::min(n, first + stretch); ++i) sum += distance(a[i].of_picture, b[i].of_picture);
        add(sum, to);
    }
}

// The pixels of `here` with the one to the right, the one below, and those beside that.
WIDE_LOOP void add_all_pairs(const Pixel* here, const Pixel* below, int n, Contrast& to) {
    for (int first = 0; first < n; first += stretch) {
        Floats edge = {}, corner = {};
        const auto add_pixel = [&](const Floats& own, const Floats& next, const Floats& left, const Floats& middle,
                                   const Floats& right) __attribute__((always_inline)) {
            edge += distance(own, next) + distance(own, middle);
            corner += distance(own, left) + distance(own, right);
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

constexpr int eights = Signs::most / lanes;

// The signs of all pictures by column of a row.
struct Flips {
    Flips(const SwayedRow& row, const Signs& signs) {
        for (int x = 0; x < Signs::words; ++x)
            std::memcpy(by_column[x], signs.flip[row.words(0)[x]].data(), sizeof by_column[x]);
    }
    Words by_column[Signs::words][eights];
};

inline __attribute__((always_inline)) Floats turned(const float& sway, const Words& flip) {
    uint32_t bits;
    std::memcpy(&bits, &sway, sizeof bits);
    return Floats(flip ^ bits);
}

// The means of two by two pixels, from column `begin` of the level below on.
WIDE_LOOP void shrink(const SwayedRow& a, const SwayedRow& b, const Flips& of_a, const Flips& of_b, unsigned begin,
                      unsigned end, Pixel* const* out) {
    const float *ma = a.mean(), *mb = b.mean(), *sa = a.sway(), *sb = b.sway();
    for (unsigned x = begin; x < end; ++x) {
        const unsigned left = 2 * x, right = left + 1, l = left % Signs::words, r = l + 1;
        const float mean = (ma[left] + ma[right]) + (mb[left] + mb[right]);
        for (int k = 0; k < eights; ++k) {
            const Floats sway = (turned(sa[left], of_a.by_column[l][k]) + turned(sa[right], of_a.by_column[r][k])) +
                                (turned(sb[left], of_b.by_column[l][k]) + turned(sb[right], of_b.by_column[r][k]));
            out[k][x].of_picture = (sway + mean) * 0.25f;
        }
    }
}

// Row r of a level is the second of two: which they make of the level below.  -1: none.
int row_made(const std::vector<Level>& levels, size_t k, int r) {
    const int from = r - levels[k].height % 2;
    return k + 1 < levels.size() && from > 0 && from % 2 == 1 ? from / 2 : -1;
}

struct Spans {
    const Span *first, *last;
    const Span* begin() const { return first; }
    const Span* end() const { return last; }
};
Spans spans(const Level& level, int r) {
    const Span* all = level.spans.data();
    return {all + level.row[size_t(r)], all + level.row[size_t(r) + 1]};
}

// The levels below the pixels, of eight pictures.
class Walk {
public:
    explicit Walk(const std::vector<Level>& levels) : levels_(levels), sums_(levels.size()) {
        for (size_t k = 0; k < levels.size(); ++k)
            for (int r = 0; r < 2; ++r) rows_.emplace_back(k ? size_t(levels[k].width) : 0);
    }

    Pixel* row(size_t level, int r) { return rows_[2 * level + size_t(r & 1)].data(); }
    // Row r of a level is there, and so are those before it.
    void take(size_t k, int r) {
        const Level& level = levels_[k];
        if (r > 0) compare(k, r - 1);
        if (r + 1 == level.height)
            level.pairs(r, r, 1, [&](int x0, int x1) { pairs(k, r, r, 1, x0, x1, sums_[k].edge); });
        if (const int half = row_made(levels_, k, r); half >= 0) {
            for (const Span& s : spans(levels_[k + 1], half))
                shrink(row(k, r - 1) + 2 * s.begin, row(k, r) + 2 * s.begin, s.end - s.begin,
                       row(k + 1, half) + s.begin);
            take(k + 1, half);
        }
    }
    // Of edges and corners, over the pixels of their level.
    Sum total() const {
        Sum out{};
        for (size_t k = 1; k < levels_.size(); ++k)
            for (size_t j = 0; j < lanes; ++j)
                out[j] += (sums_[k].edge[j] + std::sqrt(0.5) * sums_[k].corner[j]) / levels_[k].pixels();
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

std::array<double, Signs::most> rammg(const Swayed& pictures, const Geometry& geometry, RammgArea area,
                                      const std::function<void(int)>& before_row) {
    const std::vector<Level> levels = pyramid(geometry, area);
    std::array<double, Signs::most> out;
    out.fill(contrast_of(0, levels.size(), area));
    for (int r = 0; levels.empty() && r < pictures.height; ++r) before_row(r);
    if (levels.empty()) return out;
    const Level& pixels = levels[0];
    PairSums edge, corner;
    std::vector<Walk> below(eights, Walk(levels));
    std::vector<SwayedRow> rows(2, SwayedRow(pictures.width));
    for (int r = 0; r < pictures.height; ++r) {
        before_row(r);
        SwayedRow &here = rows[size_t(r & 1)], &before = rows[size_t(~r & 1)];
        for (const Span& s : spans(pixels, r)) here.show(pictures, r, s.begin, s.end);
        const auto add = [&](const SwayedRow& a, int row, int shift, PairSums& to) {
            pixels.pairs(row, r, shift, [&](int x0, int x1) { to.add(a, here, x0, shift, x1 - x0); });
        };
        add(here, r, 1, edge);
        if (r == 0) continue;
        add(before, r - 1, 0, edge);
        add(before, r - 1, 1, corner);
        add(before, r - 1, -1, corner);
        const int half = row_made(levels, 0, r);
        if (half < 0) continue;
        Pixel* made[eights];
        for (int k = 0; k < eights; ++k) made[k] = below[size_t(k)].row(1, half);
        const Flips of_before(before, *pictures.signs), of_here(here, *pictures.signs);
        for (const Span& s : spans(levels[1], half))
            shrink(before, here, of_before, of_here, unsigned(s.begin), unsigned(s.end), made);
        for (Walk& walk : below) walk.take(1, half);
    }
    const auto edges = edge.of_pictures(*pictures.signs), corners = corner.of_pictures(*pictures.signs);
    const double count = pixels.pixels();
    for (size_t w = 0; w < below.size(); ++w) {
        const Sum rest = below[w].total();
        for (size_t j = 0, k = w * lanes; j < lanes; ++j, ++k) {
            const double total = (edges[k] + std::sqrt(0.5) * corners[k]) / count + rest[j];
            out[k] = contrast_of(2 * total, levels.size(), area);
        }
    }
    return out;
}

}  // namespace comfort
