// SPDX-License-Identifier: BSD-3-Clause
// Drawing on 8-bit pictures: rectangles, text, outlines of sets of pixels, lines of text below.
#pragma once
#include <string>
#include <vector>
#include "display/tone.h"

namespace display {

constexpr Colour ink{235, 235, 235}, ground{24, 24, 24};

// Pixels a dot of text takes in a picture of this size.
int font_size(const Image8& picture);

// From (x0, y0) up to, not including, (x1, y1), as far as the picture goes.
void fill(Image8& image, int x0, int y0, int x1, int y1, Colour colour);

// The picture with room on its right and below, in the colour `ground`.
Image8 with_margin(const Image8& picture, int right, int below);

// Glyphs of 5 x 7 for digits, letters (drawn small) and some signs; unknown characters are blanks (font.cpp).
void draw_text(Image8& image, int x, int y, const std::string& text, int scale, Colour colour);
int text_width(const std::string& text, int scale);

// Colour k of a list whose neighbours differ well (hues by the golden angle).
Colour list_colour(size_t k);

// Pixels of the picture that belong to a set (coverage of half or more) and have a neighbour that does not; the others
// are tinted by `opacity` times their coverage.  width * height values, row 0 = top.
void draw_area(Image8& image, const std::vector<float>& coverage, Colour colour, double opacity);

// The words below the picture, each in its colour, as many to a row as fit.
struct Label {
    std::string text;
    Colour colour = ink;
};
Image8 with_labels(const Image8& picture, const std::vector<Label>& labels);

}  // namespace display
