// SPDX-License-Identifier: BSD-3-Clause
// Levels of RAMMG's pyramid: the valid columns of each row, and the neighbouring valid pixels of two rows.
#pragma once
#include <algorithm>
#include <vector>
#include "glare/geometry.h"
#include "glare/rammg.h"

namespace glare {

struct Level {
    int width, height;
    std::vector<Span> spans;
    std::vector<size_t> row;  // spans of row r: row[r] .. row[r+1]-1

    double pixels() const;  // number of valid pixels
    // Calls visit(first x, last x + 1) for runs where column x of row r and column x + shift of row s are both valid.
    template <class Visit>
    void pairs(int r, int s, int shift, Visit visit) const {
        size_t b = row[s];
        for (size_t a = row[r]; a < row[r + 1]; ++a) {
            while (b < row[s + 1] && spans[b].end - shift <= spans[a].begin) ++b;
            for (size_t c = b; c < row[s + 1] && spans[c].begin - shift < spans[a].end; ++c) {
                const int x0 = std::max(spans[a].begin, spans[c].begin - shift);
                const int x1 = std::min(spans[a].end, spans[c].end - shift);
                if (x0 < x1) visit(x0, x1);
            }
        }
    }
};

// From the whole picture down, while both sides are above 2 and a pixel is valid.
struct Pyramid {
    Pyramid(const Geometry& geometry, RammgArea area);
    // Contrast in cd/m2 of `total`: the sum over the levels of edge + corner sqrt(1/2) over pairs, twice, per pixel.
    double contrast_of(double total) const;

    RammgArea area;
    std::vector<Level> levels;
};

}  // namespace glare
