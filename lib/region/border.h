// SPDX-License-Identifier: BSD-3-Clause
// The share of a pixel that lies inside something, from 9 x 9 samples and the border between unlike neighbours, which
// is found by halving (marching squares): a straight edge is right to about 1/500 of the pixel.
#pragma once
#include <functional>

namespace region {

constexpr int border_cells = 8;  // of a sampled pixel, along each side

// Is the sample at (column, row) / border_cells inside?  [row][column], rows from below.
using BorderSamples = bool[border_cells + 1][border_cells + 1];

// inside(u, v) answers for any other place in the pixel, 0..1.
double share_inside(const BorderSamples& in, const std::function<bool(double u, double v)>& inside);

}  // namespace region
