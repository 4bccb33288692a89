// SPDX-License-Identifier: BSD-3-Clause
// See drawing.h.
#include "drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "display/draw.h"
#include "display/file.h"
#include "display/outline.h"
#include "glare/formulas.h"
#include "region/open.h"
#include "report/page.h"

namespace {

constexpr display::Colour source_colour{255, 160, 40};

// Text centred above the place, inside the picture, with a dark border.
void write_above(display::Image8& image, Place place, const std::string& text, display::Colour colour) {
    const int scale = display::font_size(image), wide = display::text_width(text, scale);
    const int x = std::clamp(place.x - wide / 2, scale, std::max(scale, image.width - wide - scale));
    const int y = std::clamp(place.y - 9 * scale, scale, std::max(scale, image.height - 8 * scale));
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        display::draw_text(image, x + scale * dx, y + scale * dy, text, scale, {});
    display::draw_text(image, x, y, text, scale, colour);
}

struct Name {
    Place place;
    std::string text;
    display::Colour colour;
};

}  // namespace

std::vector<float> area_of(const glare::Measurement& m, const glare::Geometry& g, const glare::GlareSource& source) {
    std::vector<float> pixels(size_t(g.width) * size_t(g.height));
    for (const glare::Run& run : m.runs)
        if (run.group == source.group)
            std::fill_n(pixels.begin() + std::ptrdiff_t(run.start), std::ptrdiff_t(run.length), 1.f);
    return pixels;
}

Place top_of(const std::vector<float>& area, int width) {
    int left = width, right = 0, top = -1;
    for (size_t i = 0; i < area.size(); ++i) {
        if (area[i] < .5f) continue;
        if (top < 0) top = int(i) / width;
        left = std::min(left, int(i) % width), right = std::max(right, int(i) % width);
    }
    return {(left + right) / 2, top};
}

image::MaskSet regions_in(const Options& o, const image::Picture& p) {
    if (o.regions_file.empty()) return {};
    image::DrawRegions draw;
    image::MaskSet masks = region::open(o.regions_file, draw, region::Check::none, true);
    return draw ? draw(o.view ? *o.view : *p.header.view, p.width, p.height) : masks;
}

std::string source_outline(const glare::Measurement& m, const glare::Geometry& g, const glare::GlareSource& source) {
    return display::rings_text(display::outlines(area_of(m, g, source), g.width, g.height));
}

void draw_measured(const Options& o, const image::Picture& picture, const RunState& run, const glare::Measurement& m) {
    display::Image8 image = display::tone(picture, {});
    std::vector<Name> names;  // above all outlines
    const image::MaskSet regions = regions_in(o, picture);
    for (size_t k = 0; k < regions.masks.size(); ++k) {
        const image::Mask& region = regions.masks[k];
        display::draw_area(image, region.coverage, display::list_colour(k), 0);
        names.push_back({top_of(region.coverage, image.width), region.name, display::list_colour(k)});
    }
    const std::vector<double> shares = glare::dgp_shares(glare::terms_of(m.sources), o.settings.constants);
    for (size_t k = 0; k < shares.size(); ++k) {
        display::draw_area(image, area_of(m, run.reading.geometry(), m.sources[k]), source_colour, 0);
        if (shares[k] < report::speck) continue;
        const Place centre{int(m.sources[k].x), image.height - 1 - int(m.sources[k].y)};
        names.push_back({centre, fmt::format("{}: {:.0f} %", k + 1, 100 * shares[k]), source_colour});
    }
    for (const Name& n : names) write_above(image, n.place, n.text, n.colour);
    std::vector<display::Label> below;
    for (const glare::Column& c : run.plan.columns)
        if (c.printed && !c.words && !c.printed_unbiased && !std::isnan(c.value(m)))
            below.push_back({fmt::format("{} {:.4g}", c.name, c.value(m))});
    display::write_png(o.over_file, display::with_labels(image, below), "");
}
