// SPDX-License-Identifier: BSD-3-Clause
// See canvas.h.
#include "display/canvas.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/printable.h"
#include "display/draw.h"
#include "display/file.h"
#include "image/stream.h"

namespace display {
namespace {

// Lines at 45 degrees, every fourth pixel of the picture, so that they go on in the next rectangle.
void hatch(Image8& image, const Rectangle& r) {
    for (int y = r.y; y < r.y + r.height; ++y)
        for (int x = r.x; x < r.x + r.width; ++x)
            if ((x + y) % 4 == 0) fill(image, x, y, x + 1, y + 1, black);
}

std::string path_of(const Rectangle& r) {
    return fmt::format("M{} {}h{}v{}h-{}z", r.x, r.y, r.width, r.height, r.width);
}

// A browser shows the title under the pointer.
std::string spots_text(const Canvas& c) {
    if (c.spots.empty()) return "";
    std::string text = "<g id=\"points\" fill=\"none\" pointer-events=\"all\">\n";
    for (const Spot& spot : c.spots) {
        if (!spot.link.empty()) text += "<a href=\"" + base::escaped(spot.link) + "\">";
        text += "<path d=\"";
        for (const Rectangle& r : spot.parts) text += path_of(r);
        text += "\"><title>" + base::escaped(spot.text) + "</title></path>";
        text += spot.link.empty() ? "\n" : "</a>\n";
    }
    text += "</g>\n";
    for (const int x : c.spots_again) text += fmt::format("<use href=\"#points\" x=\"{}\"/>\n", x);
    return text;
}

std::string png_of(const Canvas& c, const std::string& comment) {
    Image8 image;
    image.width = c.width, image.height = c.height;
    image.rgb.assign(size_t(3) * size_t(c.width) * size_t(c.height), 255);
    for (const auto& [colour, rectangles] : c.layers)
        for (const Rectangle& r : rectangles) {
            fill(image, r.x, r.y, r.x + r.width, r.y + r.height, colour);
            if (r.hatched) hatch(image, r);
        }
    for (const CanvasText& w : c.words) draw_text(image, w.x, w.y + 2, w.text, 1, black);
    return png_bytes(image, comment);
}

}  // namespace

std::string svg_text(const Canvas& c) {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "shape-rendering=\"crispEdges\">\n"
        "<pattern id=\"h\" width=\"4\" height=\"4\" patternUnits=\"userSpaceOnUse\"><path d=\"M-1 1l2-2M0 4l4-4M3 "
        "5l2-2\" "
        "stroke=\"#000\"/></pattern>\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
        c.width, c.height);
    std::string hatched;
    for (const auto& [colour, rectangles] : c.layers) {
        text += fmt::format("<path fill=\"#{:02x}{:02x}{:02x}\" d=\"", colour[0], colour[1], colour[2]);
        for (const Rectangle& r : rectangles) {
            const std::string path = path_of(r);
            text += path;
            if (r.hatched) hatched += path;
        }
        text += "\"/>\n";
    }
    text += "<path fill=\"url(#h)\" d=\"" + hatched + "\"/>\n<g font-family=\"sans-serif\" font-size=\"12\">\n";
    for (const CanvasText& w : c.words)
        text += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", w.x, w.y + 10, base::escaped(w.text));
    return text + "</g>\n" + spots_text(c) + "</svg>\n";
}

std::vector<Rectangle>& Canvas::of(const Colour& colour) {
    for (auto& [c, rectangles] : layers)
        if (c == colour) return rectangles;
    layers.push_back({colour, {}});
    return layers.back().second;
}

void write_canvas(const std::string& path, const Canvas& canvas, const std::string& comment) {
    const std::string ending = image::ending_of(path);
    if (ending != ".svg" && ending != ".png") base::fail(path, "plots are written to .svg or .png");
    image::write_bytes(path, ending == ".svg" ? svg_text(canvas) : png_of(canvas, comment));
}

}  // namespace display
