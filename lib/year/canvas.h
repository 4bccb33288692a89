// SPDX-License-Identifier: BSD-3-Clause
// A drawing of rectangles, some hatched, and words, as SVG or PNG.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "display/colours.h"

namespace year {

struct Rectangle {
    int x, y, width, height;
    bool hatched = false;
};
struct Words {
    int x, y;  // top left, of letters 10 high
    std::string text;
};

struct Canvas {
    int width = 0, height = 0;
    std::vector<std::pair<display::Colour, std::vector<Rectangle>>> layers;  // later ones cover earlier ones
    std::vector<Words> words;
    std::vector<Rectangle>& of(const display::Colour& colour);  // a layer, made where there is none
};

std::string svg_text(const Canvas& canvas);
std::string png_bytes(const Canvas& canvas, const std::string& comment);

}  // namespace year
