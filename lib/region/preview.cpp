// SPDX-License-Identifier: BSD-3-Clause
// The picture by image::photo(); a region's tint mixes in by 45 % of its coverage, pixels on its border (covered by
// half or more beside one that is not) get its colour itself; below, the names in their colours.
#include "region/preview.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include "base/error.h"
#include "image/stream.h"
#include "image/tone.h"

namespace region {
namespace {
using Colour = std::array<uint8_t, 3>;

// Hues by the golden angle: neighbours in the list differ well.
Colour colour(size_t k) {
    double hue = std::fmod(0.08 + double(k) * 0.61803398875, 1) * 6;
    Colour c{};
    for (int i = 0; i < 3; ++i) {
        double ramp = std::clamp(std::fabs(std::fmod(hue + (i == 0 ? 3 : i == 1 ? 1 : 5), 6.0) - 3) - 1, 0.0, 1.0);
        c[size_t(i)] = uint8_t(255 * (ramp * .85 + .15));
    }
    return c;
}

void tint(image::Image8& picture, const std::vector<float>& c, Colour colour) {
    const int nx = picture.width, ny = picture.height;
    auto in = [&](int x, int y) {
        return x < 0 || y < 0 || x >= nx || y >= ny || c[size_t(y) * size_t(nx) + size_t(x)] >= .5f;
    };
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) {
            float covered = c[size_t(y) * size_t(nx) + size_t(x)];
            if (covered <= 0) continue;
            bool border = in(x, y) && !(in(x - 1, y) && in(x + 1, y) && in(x, y - 1) && in(x, y + 1));
            double share = border ? 1 : .45 * double(covered);
            for (size_t k = 0; k < 3; ++k) {
                uint8_t& v = picture.at(x, y)[k];
                v = uint8_t(v + share * (colour[k] - v) + .5);
            }
        }
}

// The names, as many to a row as fit.
image::Image8 with_names(const image::Image8& picture, const image::MaskSet& set) {
    const int scale = std::max(1, std::min(picture.width, picture.height) / 300), line = 11 * scale, gap = 12 * scale;
    struct Place {
        int x, y;
    };
    std::vector<Place> places;
    int x = gap / 2, rows = 1;
    for (const image::Mask& m : set.masks) {
        int wide = image::text_width(m.name, scale);
        if (x > gap / 2 && x + wide > picture.width) x = gap / 2, ++rows;
        places.push_back({x, picture.height + (rows - 1) * line + 2 * scale});
        x += wide + gap;
    }
    image::Image8 out{picture.width, picture.height + rows * line, picture.rgb};
    out.rgb.resize(size_t(out.width) * size_t(out.height) * 3, 24);
    for (size_t m = 0; m < places.size(); ++m)
        image::draw_text(out, places[m].x, places[m].y, set.masks[m].name, scale, colour(m));
    return out;
}

}  // namespace

void write_preview(const std::string& path, const image::Picture& under, const image::MaskSet& set) {
    if (set.width != under.width || set.height != under.height)
        base::fail(path, fmt::format("the picture has {} x {} pixels, the regions {} x {}", under.width, under.height,
                                     set.width, set.height));
    image::Image8 picture = image::photo(under, {});
    for (size_t m = 0; m < set.masks.size(); ++m) tint(picture, set.masks[m].coverage, colour(m));
    image::write_bytes(path, image::png_bytes(with_names(picture, set), ""));
}

}  // namespace region
