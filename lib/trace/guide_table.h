// SPDX-License-Identifier: BSD-3-Clause
// From what was learned of cells to the table that kernels read (kernels/guide.h).
#pragma once
#include <cstdint>
#include <vector>
#include "kernels/host.h"

namespace trace {

// A cell of the grid: some surface that faces one side.
struct GuideCell {
    uint32_t key = 0;            // guide_key of kernels/guide.h
    uint32_t side = 0;           // bins a side, a power of 2 above 1
    double light = 0;            // mean luminance of the light that comes in
    std::vector<double> square;  // mean square of it in each bin, rows first
};

struct Guide {
    std::vector<uint32_t> words;  // SceneTables.guide
    uint32_t mask = 0;            // Params.guide_mask; 0: there is nothing to guide
    kernels::float4 grid{};       // Params.guide_grid
};

// Keys are all different.
Guide guide_table(const std::vector<GuideCell>& cells, kernels::float4 grid);

}  // namespace trace
