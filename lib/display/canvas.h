// SPDX-License-Identifier: BSD-3-Clause
// A drawing of rectangles, some hatched, and words.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "display/colours.h"

namespace display {

struct Rectangle {
    int x, y, width, height;
    bool hatched = false;
};
struct CanvasText {
    int x, y;  // top left, of letters 10 high
    std::string text;
};

// A browser shows the text while the pointer is over these rectangles (SVG).
struct Spot {
    std::vector<Rectangle> parts;
    std::string text;
    std::string link = {};  // where a click leads; empty: nowhere
};

struct Canvas {
    int width = 0, height = 0;
    std::vector<std::pair<Colour, std::vector<Rectangle>>> layers;  // later ones cover earlier ones
    std::vector<CanvasText> words;
    std::vector<Spot> spots;
    std::vector<int> spots_again;                      // and this far to the right
    std::vector<Rectangle>& of(const Colour& colour);  // a layer, made where there is none
};

std::string svg_text(const Canvas& canvas);
// As SVG or PNG, by the ending of the name.  Throws Error (path) for another one.  comment: of a PNG.
void write_canvas(const std::string& path, const Canvas& canvas, const std::string& comment);

}  // namespace display
