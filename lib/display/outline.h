// SPDX-License-Identifier: BSD-3-Clause
// Outlines of areas of a picture as closed lines, for pictures and pages that draw them.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace display {

// Corners in pixels, x from the left and y from the top; the last one is joined to the first.
using Ring = std::vector<std::array<float, 2>>;

// Where the coverage passes 1/2 (marching squares between the centres of pixels; 0 outside of the picture).
// width * height values, row 0 = top.
std::vector<Ring> outlines(const std::vector<float>& coverage, int width, int height);

// As JSON: [[x,y,x,y,...],...], to a hundredth of a pixel.
std::string rings_text(const std::vector<Ring>& rings);

}  // namespace display
