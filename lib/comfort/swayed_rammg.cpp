// SPDX-License-Identifier: BSD-3-Clause
// The pixels themselves are summed by words (swayed_pairs.h).  The levels below have a pixel of all pictures side by
// side.  A row of a level is gone when the next one has been compared with it and the row of the level below is made of
// both: all that is worked on stays in the cache.
#include "comfort/swayed_rammg.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/wide.h"
#include "comfort/lanes.h"
#include "comfort/pyramid.h"
#include "comfort/swayed_pairs.h"

namespace comfort {
namespace {

constexpr int eights = Signs::most / lanes;
struct alignas(4 * lanes) Pixel {  // what a vector asks for depends on the processor a function is for
    Floats of_picture[eights];
};
using Sum = std::array<double, Signs::most>;
struct Contrast {
    Sum edge{}, corner{};
};

inline __attribute__((always_inline)) void add(const Floats& from, double* to) {
    float values[lanes];
    std::memcpy(values, &from, sizeof values);
    for (int k = 0; k < lanes; ++k) to[k] += double(values[k]);
}

// Short stretches, so that float is enough.
constexpr int stretch = 32;

WIDE_LOOP void add_pairs(const Pixel* a, const Pixel* b, int n, Sum& to) {
    for (int first = 0; first < n; first += stretch)
        for (int e = 0; e < eights; ++e) {
            Floats sum = {};
            for (int i = first; i < std::min(n, first + stretch); ++i)
                sum += distance(a[i].of_picture[e], b[i].of_picture[e]);
            add(sum, &to[size_t(e * lanes)]);
        }
}

// The pixels of `here` with the one to the right, the one below, and those beside that; of eight pictures.
inline __attribute__((always_inline)) void add_all_pairs(const Pixel* here, const Pixel* below, int n, int e,
                                                         Contrast& to) {
    Floats edge = {}, corner = {};
    const auto add_pixels = [&](int first, auto count) __attribute__((always_inline)) {
        constexpr int n = decltype(count)::value;
        Floats own[n + 1], other[n + 2];
        for (int k = 0; k < n + 1; ++k) own[k] = here[first + k].of_picture[e];
        for (int k = 0; k < n + 2; ++k) other[k] = below[first + k - 1].of_picture[e];
        for (int k = 0; k < n; ++k) {
            edge += distance(own[k], own[k + 1]) + distance(own[k], other[k + 1]);
            corner += distance(own[k], other[k]) + distance(own[k], other[k + 2]);
        }
    };
    constexpr std::integral_constant<int, 4> four;  // so that most are loaded once
    constexpr std::integral_constant<int, 1> one;
    int i = 0;
    for (; i + four <= n; i += four) add_pixels(i, four);
    for (; i < n; ++i) add_pixels(i, one);
    add(edge, &to.edge[size_t(e * lanes)]);
    add(corner, &to.corner[size_t(e * lanes)]);
}

WIDE_LOOP void add_all_pairs(const Pixel* here, const Pixel* below, int n, Contrast& to) {
    for (int first = 0; first < n; first += stretch)
        for (int e = 0; e < eights; ++e)
            add_all_pairs(here + first, below + first, std::min(n - first, stretch), e, to);
}

WIDE_LOOP void shrink(const Pixel* a, const Pixel* b, int n, Pixel* out) {
    for (int x = 0; x < n; ++x)
        for (int e = 0; e < eights; ++e)
            out[x].of_picture[e] = ((a[2 * x].of_picture[e] + a[2 * x + 1].of_picture[e]) +
                                    (b[2 * x].of_picture[e] + b[2 * x + 1].of_picture[e])) *
                                   0.25f;
}

// How two by two pixels go together, by column of the level below.  Up to the sign of its first pixel a picture has one
// of eight sums, by which of the other signs are not those of the pixels before.
constexpr int pairs_of_columns = Signs::words / 2;
struct Blocks {
    Words flip[pairs_of_columns][eights], which[pairs_of_columns][eights];
};
WIDE_LOOP void find_blocks(const unsigned* v, const unsigned* w, const Signs& signs, Blocks& out) {
    for (int x = 0; x < pairs_of_columns; ++x, v += 2, w += 2)
        for (int e = 0; e < eights; ++e) {
            const auto flips = [&](unsigned word) __attribute__((always_inline)) {
                Words flip;
                std::memcpy(&flip, &signs.flip[word][size_t(e * lanes)], sizeof flip);
                return flip;
            };
            out.flip[x][e] = flips(v[0]);
            out.which[x][e] = flips(v[0] ^ v[1]) >> 31 | flips(v[0] ^ w[0]) >> 30 | flips(w[0] ^ w[1]) >> 29;
        }
}

// The means of two by two pixels, from column `begin` of the level below on.
WIDE_LOOP void shrink(const SwayedRow& a, const SwayedRow& b, const Blocks& blocks, int begin, int end, Pixel* out) {
    constexpr uint32_t o = 1u << 31;
    constexpr Words right{0, o, 0, o, 0, o, 0, o}, lower{0, 0, o, o, 0, 0, o, o}, lower_right{0, 0, 0, 0, o, o, o, o};
    const float *ma = a.mean(), *mb = b.mean(), *sa = a.sway(), *sb = b.sway();
    for (int first = begin; first < std::min(end, begin + pairs_of_columns); ++first) {
        const auto &flip = blocks.flip[first % pairs_of_columns], &which = blocks.which[first % pairs_of_columns];
        for (int x = first; x < end; x += pairs_of_columns) {
            const int l = 2 * x, r = l + 1;
            const float mean = ((ma[l] + ma[r]) + (mb[l] + mb[r])) * 0.25f;
            const Floats above = sa[l] + turned(sa[r], right), below = sb[l] + turned(sb[r], lower_right);
            const Floats sums = (above + Floats(Words(below) ^ lower)) * 0.25f;
            for (int e = 0; e < eights; ++e)
                out[x].of_picture[e] = Floats(Words(pick(sums, which[e])) ^ flip[e]) + mean;
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

}  // namespace

class SwayedContrast::Below {
public:
    explicit Below(const std::vector<Level>& levels) : levels_(levels), sums_(levels.size()) {
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
            for (size_t j = 0; j < out.size(); ++j)
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

SwayedContrast::SwayedContrast(const Pyramid& pyramid, const Signs& signs)
    : pyramid_(pyramid), levels_(pyramid.levels), signs_(signs), below_(std::make_unique<Below>(levels_)) {}
SwayedContrast::~SwayedContrast() = default;

void SwayedContrast::take(const SwayedRow& here, const SwayedRow& before, int r) {
    if (levels_.empty()) return;
    const Level& pixels = levels_[0];
    const auto add = [&](const SwayedRow& a, int row, int shift, PairSums& to) {
        pixels.pairs(row, r, shift, [&](int x0, int x1) { to.add(a, here, x0, shift, x1 - x0); });
    };
    add(here, r, 1, edge_);
    if (r == 0) return;
    add(before, r - 1, 0, edge_);
    add(before, r - 1, 1, corner_);
    add(before, r - 1, -1, corner_);
    const int half = row_made(levels_, 0, r);
    if (half < 0) return;
    Blocks blocks;
    find_blocks(before.words(0), here.words(0), signs_, blocks);
    for (const Span& s : spans(levels_[1], half)) shrink(before, here, blocks, s.begin, s.end, below_->row(1, half));
    below_->take(1, half);
}

std::array<double, Signs::most> SwayedContrast::of_pictures() const {
    std::array<double, Signs::most> out;
    out.fill(pyramid_.contrast_of(0));
    if (levels_.empty()) return out;
    const auto edges = edge_.of_pictures(signs_), corners = corner_.of_pictures(signs_);
    const Sum below = below_->total();
    const double count = levels_[0].pixels();
    for (size_t k = 0; k < out.size(); ++k) {
        const double total = (edges[k] + std::sqrt(0.5) * corners[k]) / count + below[k];
        out[k] = pyramid_.contrast_of(2 * total);
    }
    return out;
}

std::array<double, Signs::most> rammg(const Swayed& pictures, const Geometry& geometry, RammgArea area) {
    const Pyramid pyramid(geometry, area);
    SwayedContrast out(pyramid, *pictures.signs);
    SwayedRow rows[2]{SwayedRow(pictures.width), SwayedRow(pictures.width)};
    for (int r = 0; r < pictures.height; ++r) {
        rows[r % 2].show(pictures, r, {0, pictures.width});
        out.take(rows[r % 2], rows[(r + 1) % 2], r);
    }
    return out.of_pictures();
}

}  // namespace comfort
