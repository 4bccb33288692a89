// SPDX-License-Identifier: BSD-3-Clause
// Values at points, such as the sensors of a plan, as maps: each point's cell in falsecolor, a contour at a limit.
// Points are seen along the axis, or against their mean direction, along which they spread most: a horizontal grid from
// above with +y up, a wall from its front with +z up.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "display/canvas.h"
#include "image/points.h"

namespace display {

// The maps of a column have one scale, whose legend stands below.
struct MapColumn {
    std::string unit;                         // "lx"
    std::optional<double> limit;              // of the contour
    std::vector<std::vector<double>> values;  // by grid, by point; one that is not finite is not known
    std::vector<std::vector<bool>> hatched;   // likewise; or empty
    std::string says_hatched;                 // what that means
    double top = 0;                           // value at the end of a linear scale from 0; 0: the scale fits the values
};

// A row of maps for each grid, a column for each quantity.  words: of a point, for the pointer; cells that are too
// small to be pointed at have none.
using WordsOfPoint = std::function<std::string(size_t grid, size_t point)>;
Canvas point_maps(const std::vector<std::string>& names, const std::vector<std::vector<image::Point>>& grids,
                  const std::vector<MapColumn>& columns, const WordsOfPoint& words = {});

}  // namespace display
