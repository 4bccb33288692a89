// SPDX-License-Identifier: BSD-3-Clause
// Connected components of pixels under the relation "directions at most `reach` apart".  evalglare's two scans give the
// same components, except for rounding accidents (docs/differences-evalglare.md).  Linear in pixels: the interior of a
// source is stored as runs; its boundary is binned into cubes of direction space whose diagonal is the chord of the
// reach, so that a cube is one component and only neighbouring cubes are compared.
#pragma once
#include <cstdint>
#include <vector>
#include "glare/geometry.h"

namespace glare {

// Neighbouring pixels of one row, all in one group.
struct Run {
    uint32_t start, length;  // first pixel's index (row 0 = top) and count
    uint32_t group;
};

class ConnectedComponents {
public:
    ConnectedComponents(const Geometry& geometry, double reach_rad);
    // Numbers the runs' groups first, first+1, ... by each group's first pixel, columns from the left, in a column from
    // the bottom. Runs must be in picture order and must not overlap; they may be cut into single pixels (views whose
    // neighbours can be farther apart than the reach).  Returns the number of groups.
    uint32_t label(std::vector<Run>& runs, uint32_t first = 0) const;

private:
    struct BoundaryPixel {
        uint32_t pixel, run;
    };
    struct CellLists {  // of each cell c those that precede it: cells[from[c]] to cells[from[c + 1] - 1]
        std::vector<uint32_t> from, cells;
    };
    CellLists preceding(bool touching) const;
    std::vector<BoundaryPixel> boundary(const std::vector<Run>& runs) const;
    void join_rows(std::vector<Run>& runs) const;
    void join_cells(std::vector<Run>& runs, const std::vector<BoundaryPixel>& boundary) const;
    bool within_reach(const std::vector<BoundaryPixel>& p, size_t a0, size_t a1, size_t b0, size_t b1) const;

    const Geometry& geometry_;
    double cos_reach_;
    bool everything_, pixels_touch_;
    std::vector<uint64_t> keys_;    // of cells, by number: their cubes in order
    std::vector<uint32_t> cell_;    // by pixel
    CellLists touching_, farther_;  // empty: the cells are too many
};

}  // namespace glare
