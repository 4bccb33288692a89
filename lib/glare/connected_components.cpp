// SPDX-License-Identifier: BSD-3-Clause
// Connected components by cells of direction space (connected_components.h).
#include "glare/connected_components.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace glare {
namespace {

constexpr int offset = 1 << 20;          // keeps cube coordinates positive in the key
constexpr size_t most_listed = 1 << 13;  // cells whose neighbours are found once; the usual reach has 3,000

uint64_t key_of(int x, int y, int z) {
    return (uint64_t(x + offset) << 42) | (uint64_t(y + offset) << 21) | uint64_t(z + offset);
}

// Union-find over runs; the parent lives in `group`.
uint32_t root(std::vector<Run>& runs, uint32_t r) {
    while (runs[r].group != r) r = runs[r].group = runs[runs[r].group].group;
    return r;
}
void unite(std::vector<Run>& runs, uint32_t a, uint32_t b) {
    a = root(runs, a), b = root(runs, b);
    if (a < b) runs[b].group = a;
    else runs[a].group = b;
}

// Calls visit(cell, other) for each used cell and those used before it whose cubes touch its own, or lie one cube
// farther.  used: numbers of cells in the order of their keys.  Each row of cubes along z has a cursor, which only
// moves on.
template <class Visit>
void for_preceding(const std::vector<uint64_t>& keys, const std::vector<uint32_t>& used, bool touching, Visit visit) {
    size_t cursors[13] = {};
    for (const uint32_t c : used) {
        size_t* cursor = cursors;
        for (int dx = -2; dx <= 0; ++dx)
            for (int dy = -2; dy <= (dx < 0 ? 2 : 0); ++dy, ++cursor) {
                const bool row_touches = dx >= -1 && std::abs(dy) <= 1;
                if (touching && !row_touches) continue;
                const int far = touching ? 1 : 2;
                const uint64_t middle = keys[c] + uint64_t(dx * (int64_t(1) << 42) + dy * (int64_t(1) << 21));
                const uint64_t end = std::min(middle + uint64_t(far) + 1, keys[c]);
                while (*cursor < used.size() && keys[used[*cursor]] < middle - uint64_t(far)) ++*cursor;
                for (size_t k = *cursor; k < used.size() && keys[used[k]] < end; ++k) {
                    const bool touches = row_touches && keys[used[k]] + 1 >= middle && keys[used[k]] <= middle + 1;
                    if (touches == touching) visit(c, used[k]);
                }
            }
    }
}

}  // namespace

ConnectedComponents::ConnectedComponents(const Geometry& geometry, double reach)
    : geometry_(geometry),
      cos_reach_(std::cos(reach)),
      everything_(reach >= evalglare_pi),
      pixels_touch_(3 * geometry.pitch_bound() <= reach) {
    const double chord = 2 * std::sin(std::min(reach, evalglare_pi) / 2);
    const double cells_per_unit = std::min(std::sqrt(3.0) / std::max(chord, 1e-12) * (1 + 1e-12), 5e5);
    if (everything_) return;
    std::vector<uint64_t> key(geometry.omega.size());
    in_rows(geometry.height, [&](int first, int end) {
        for (size_t p = size_t(first) * geometry.width; p < size_t(end) * geometry.width; ++p) {
            const Vec3 d = geometry.direction(p) * cells_per_unit;
            key[p] = key_of(int(std::floor(d.x)), int(std::floor(d.y)), int(std::floor(d.z)));
        }
    });
    uint64_t last = 0;  // most neighbours lie in one cube
    for (const uint64_t k : key)
        if (k != last) keys_.push_back(last = k);
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    for (const uint64_t k : key)
        if (!cell_.empty() && keys_[cell_.back()] == k) cell_.push_back(cell_.back());
        else cell_.push_back(uint32_t(std::lower_bound(keys_.begin(), keys_.end(), k) - keys_.begin()));
    if (keys_.size() <= most_listed) touching_ = preceding(true), farther_ = preceding(false);
}

ConnectedComponents::CellLists ConnectedComponents::preceding(bool touching) const {
    std::vector<uint32_t> all(keys_.size());
    std::iota(all.begin(), all.end(), 0u);
    std::vector<BoundaryPixel> pixels;
    std::vector<size_t> end(keys_.size() + 1);  // of the pixels of the cell before
    const bool few = cell_.size() <= 2 * keys_.size();
    if (few) {
        for (uint32_t p = 0; p < cell_.size(); ++p) pixels.push_back({p, 0}), ++end[cell_[p] + 1];
        std::partial_sum(end.begin(), end.end(), end.begin());
        std::sort(pixels.begin(), pixels.end(), [&](BoundaryPixel a, BoundaryPixel b) {
            return std::make_pair(cell_[a.pixel], a.pixel) < std::make_pair(cell_[b.pixel], b.pixel);
        });
    }
    CellLists out;
    out.from.resize(keys_.size() + 1);
    for_preceding(keys_, all, touching, [&](uint32_t c, uint32_t o) {
        if (few && !within_reach(pixels, end[c], end[c + 1], end[o], end[o + 1])) return;
        out.cells.push_back(o);
        ++out.from[c + 1];
    });
    std::partial_sum(out.from.begin(), out.from.end(), out.from.begin());
    return out;
}

// Joins runs that overlap a run of the next row.
void ConnectedComponents::join_rows(std::vector<Run>& runs) const {
    const uint32_t width = uint32_t(geometry_.width);
    size_t below = 0;
    for (size_t r = 0; r < runs.size(); ++r) {
        const uint32_t first = runs[r].start + width, last = first + runs[r].length;  // same columns, next row
        while (below < runs.size() && runs[below].start + runs[below].length <= first) ++below;
        for (size_t b = below; b < runs.size() && runs[b].start < last; ++b) unite(runs, uint32_t(r), uint32_t(b));
    }
}

// Pixels without four neighbours in runs.  If a surrounded pixel is within reach of another pixel, so is a neighbour
// nearer to it; so the shortest distance between components is between boundary pixels.
std::vector<ConnectedComponents::BoundaryPixel> ConnectedComponents::boundary(const std::vector<Run>& runs) const {
    std::vector<BoundaryPixel> out;
    const uint32_t width = uint32_t(geometry_.width);
    size_t above = 0, below = 0;
    for (uint32_t r = 0; r < runs.size(); ++r) {
        const uint32_t first = runs[r].start, last = first + runs[r].length - 1;
        if (!pixels_touch_ || runs[r].length < 3) {
            for (uint32_t p = first; p <= last; ++p) out.push_back({p, r});
            continue;
        }
        out.push_back({first, r});
        while (above < runs.size() && runs[above].start + runs[above].length + width <= first) ++above;
        while (below < runs.size() && runs[below].start + runs[below].length <= first + width) ++below;
        size_t a = above, b = below;
        for (uint32_t p = first + 1; p < last; ++p) {
            while (a < runs.size() && runs[a].start + runs[a].length + width <= p) ++a;
            while (b < runs.size() && runs[b].start + runs[b].length <= p + width) ++b;
            const bool has_above = a < runs.size() && runs[a].start + width <= p;
            const bool has_below = b < runs.size() && runs[b].start <= p + width;
            if (!has_above || !has_below) {
                out.push_back({p, r});
                continue;
            }
            const uint32_t inside_to =
                std::min({last, runs[a].start + runs[a].length + width, runs[b].start + runs[b].length - width});
            p = inside_to - 1;  // all of these have both neighbours
        }
        out.push_back({last, r});
    }
    return out;
}

bool ConnectedComponents::within_reach(const std::vector<BoundaryPixel>& p, size_t a0, size_t a1, size_t b0,
                                       size_t b1) const {
    static thread_local std::vector<Vec3> seen;
    seen.clear();
    for (size_t a = a0; a < a1; ++a) {
        const Vec3 da = geometry_.direction(p[a].pixel);
        for (size_t b = b0; b < b1; ++b) {
            if (seen.size() == b - b0) seen.push_back(geometry_.direction(p[b].pixel));
            if (dot(da, seen[b - b0]) >= cos_reach_) return true;
        }
    }
    return false;
}

void ConnectedComponents::join_cells(std::vector<Run>& runs, const std::vector<BoundaryPixel>& boundary) const {
    struct Range {
        uint32_t first = 0, end = 0;
    };
    std::vector<Range> of(keys_.size());  // counting sort by cell
    std::vector<uint32_t> used;
    for (const BoundaryPixel& b : boundary)
        if (of[cell_[b.pixel]].end++ == 0) used.push_back(cell_[b.pixel]);
    uint32_t sum = 0;
    for (const uint32_t c : used) {
        const uint32_t count = of[c].end;
        of[c] = {sum, sum};
        sum += count;
    }
    std::vector<BoundaryPixel> sorted(boundary.size());
    for (const BoundaryPixel& b : boundary) sorted[of[cell_[b.pixel]].end++] = b;

    constexpr uint32_t none = UINT32_MAX;
    std::vector<uint32_t> piece(keys_.size(), none);  // by used cell: a run of its component, mostly the root
    for (const uint32_t c : used) {                   // a cube is one piece
        for (uint32_t k = of[c].first; k + 1 < of[c].end; ++k)
            if (sorted[k].run != sorted[k + 1].run) unite(runs, sorted[k].run, sorted[k + 1].run);
        piece[c] = sorted[of[c].first].run;
    }
    const auto join = [&](uint32_t c, uint32_t o) {
        if (piece[o] == none || piece[o] == piece[c]) return;
        piece[c] = root(runs, piece[c]), piece[o] = root(runs, piece[o]);
        if (piece[c] == piece[o]) return;
        if (!within_reach(sorted, of[c].first, of[c].end, of[o].first, of[o].end)) return;
        unite(runs, piece[c], piece[o]);
        piece[c] = piece[o] = std::min(piece[c], piece[o]);
    };
    if (touching_.from.empty()) std::sort(used.begin(), used.end());
    for (const bool touching : {true, false}) {  // cells that do not touch last: most are joined by then
        const CellLists& lists = touching ? touching_ : farther_;
        if (lists.from.empty()) {
            for_preceding(keys_, used, touching, join);
            continue;
        }
        for (const uint32_t c : used)
            for (uint32_t k = lists.from[c]; k < lists.from[c + 1]; ++k) join(c, lists.cells[k]);
    }
}

uint32_t ConnectedComponents::label(std::vector<Run>& runs, uint32_t first_group) const {
    if (runs.empty()) return 0;
    if (!pixels_touch_) {
        std::vector<Run> single;
        for (const Run& r : runs)
            for (uint32_t p = 0; p < r.length; ++p) single.push_back({r.start + p, 1, 0});
        runs.swap(single);
    }
    for (uint32_t r = 0; r < runs.size(); ++r) runs[r].group = r;
    if (everything_) {
        for (Run& r : runs) r.group = 0;
    } else {
        if (pixels_touch_) join_rows(runs);
        join_cells(runs, boundary(runs));
    }
    // number the groups by their first pixel in column order
    struct Head {
        uint64_t key;
        uint32_t run;
    };
    std::vector<Head> heads;
    std::vector<uint32_t> head_of(runs.size(), UINT32_MAX);
    for (uint32_t r = 0; r < runs.size(); ++r) {
        const uint32_t top = root(runs, r);
        const uint64_t key = uint64_t(geometry_.x_of(runs[r].start)) * geometry_.height + geometry_.y_of(runs[r].start);
        if (head_of[top] == UINT32_MAX) {
            head_of[top] = uint32_t(heads.size());
            heads.push_back({key, top});
        } else heads[head_of[top]].key = std::min(heads[head_of[top]].key, key);
    }
    for (uint32_t r = 0; r < runs.size(); ++r) root(runs, r);
    std::vector<uint32_t> order(heads.size());
    for (uint32_t k = 0; k < order.size(); ++k) order[k] = k;
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return heads[a].key < heads[b].key; });
    std::vector<uint32_t> number(heads.size());
    for (uint32_t k = 0; k < order.size(); ++k) number[order[k]] = first_group + k;
    std::vector<uint32_t> group(runs.size());
    for (uint32_t r = 0; r < runs.size(); ++r) group[r] = number[head_of[root(runs, r)]];
    for (uint32_t r = 0; r < runs.size(); ++r) runs[r].group = group[r];
    return uint32_t(heads.size());
}

}  // namespace glare
