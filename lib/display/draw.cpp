// SPDX-License-Identifier: BSD-3-Clause
// See draw.h.
#include "display/draw.h"

#include <algorithm>
#include <cmath>

namespace display {

int font_size(const Image8& picture) { return std::max(1, std::min(picture.height, picture.width) / 300); }

void fill(Image8& image, int x0, int y0, int x1, int y1, Colour colour) {
    for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y)
        for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x)
            std::copy(colour.begin(), colour.end(), image.at(x, y));
}

Image8 with_margin(const Image8& picture, int right, int below) {
    Image8 out{picture.width + right, picture.height + below, {}};
    out.rgb.resize(3 * size_t(out.width) * size_t(out.height));
    fill(out, 0, 0, out.width, out.height, ground);
    for (int y = 0; y < picture.height; ++y)
        std::copy(picture.at(0, y), picture.at(0, y) + 3 * size_t(picture.width), out.at(0, y));
    return out;
}

Colour list_colour(size_t k) {
    const double hue = std::fmod(0.08 + double(k) * 0.61803398875, 1) * 6;
    Colour c{};
    for (int i = 0; i < 3; ++i) {
        const double ramp = std::clamp(std::fabs(std::fmod(hue + (i == 0   ? 3
                                                                  : i == 1 ? 1
                                                                           : 5),
                                                           6.0) -
                                                 3) -
                                           1,
                                       0.0, 1.0);
        c[size_t(i)] = uint8_t(255 * (ramp * .85 + .15));
    }
    return c;
}

void draw_area(Image8& image, const std::vector<float>& coverage, Colour colour, double opacity) {
    const int nx = image.width, ny = image.height;
    const auto in = [&](int x, int y) {
        return x < 0 || y < 0 || x >= nx || y >= ny || coverage[size_t(y) * size_t(nx) + size_t(x)] >= .5f;
    };
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            const float covered = coverage[size_t(y) * size_t(nx) + size_t(x)];
            if (covered <= 0) continue;
            const bool border = in(x, y) && !(in(x - 1, y) && in(x + 1, y) && in(x, y - 1) && in(x, y + 1));
            const double mixed = border ? 1 : opacity * double(covered);
            for (size_t k = 0; k < 3; ++k) {
                uint8_t& v = image.at(x, y)[k];
                v = uint8_t(v + mixed * (colour[k] - v) + .5);
            }
        }
}

Image8 with_labels(const Image8& picture, const std::vector<Label>& labels) {
    const int scale = font_size(picture), line = 11 * scale, gap = 12 * scale;
    std::vector<std::pair<int, int>> places;
    int x = gap / 2, rows = 1;
    for (const Label& l : labels) {
        const int wide = text_width(l.text, scale);
        if (x > gap / 2 && x + wide > picture.width) x = gap / 2, ++rows;
        places.emplace_back(x, picture.height + (rows - 1) * line + 2 * scale);
        x += wide + gap;
    }
    Image8 out = with_margin(picture, 0, rows * line);
    for (size_t k = 0; k < labels.size(); ++k)
        draw_text(out, places[k].first, places[k].second, labels[k].text, scale, labels[k].colour);
    return out;
}

}  // namespace display
