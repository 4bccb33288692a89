// SPDX-License-Identifier: BSD-3-Clause
// Luminance (cd/m2, 179 lm/W) as colours, logarithmic over some decades or linear: smooth, in bands, or as lines over
// the grey picture; with a legend on the right.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "display/draw.h"
#include "display/tone.h"

namespace display {
namespace {

constexpr int smooth_levels = 256;

// Top of the scale: what all but a thousandth of the lit pixels stay below (the sun must not flatten the room).
double automatic_top(const image::Picture& p) {
    std::vector<double> lit;
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const double l = image::luminance(&p.rgb[i]);
        if (l > 1e-6 && std::isfinite(l)) lit.push_back(l);
    }
    if (lit.empty()) return 1000;
    const auto at = lit.begin() + std::ptrdiff_t(.999 * double(lit.size() - 1));
    std::nth_element(lit.begin(), at, lit.end());
    return round_up_125(*at);
}

Image8 with_legend(const Image8& plain, const Scale& scale, const ColourTable& table) {
    const int size = font_size(plain), line = 9 * size, bar = 16 * size, pad = 6 * size;
    const int beside = pad + bar + 2 * size + text_width("100000", size) + 2 * pad;
    Image8 out = with_margin(plain, beside, 0);
    const int left = plain.width + pad, top = pad + line + pad, bottom = out.height - pad - line / 2;
    draw_text(out, left, pad, "cd/m2", size, ink);
    for (int y = top; y < bottom; ++y) {
        const double place = (bottom - 1 - y) / std::max(1., bottom - 1. - top);
        fill(out, left, y, left + bar, y + 1, table.at(scale.value_at(place)));
    }
    int last = bottom + 2 * line;
    for (const double tick : ticks(scale)) {
        const int y = bottom - 1 - int(scale.place(tick) * (bottom - 1 - top) + .5);
        if (last - y < line) continue;  // no room
        last = y;
        fill(out, left + bar, y, left + bar + 2 * size, y + 1, ink);
        draw_text(out, left + bar + 4 * size, y - 3 * size, tick_text(tick), size, ink);
    }
    return out;
}

// Lines where the band changes toward the right or the lower neighbour, in the colour of the upper band.
void draw_contours(Image8& out, const image::Picture& p, const ColourTable& table) {
    std::vector<size_t> band(size_t(p.width) * size_t(p.height));
    for (size_t i = 0; i < band.size(); ++i) band[i] = table.index(image::luminance(&p.rgb[3 * i]));
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const size_t i = size_t(y) * size_t(p.width) + size_t(x);
            size_t highest = band[i], lowest = band[i];
            for (const size_t j : {x + 1 < p.width ? i + 1 : i, y + 1 < p.height ? i + size_t(p.width) : i}) {
                highest = std::max(highest, band[j]);
                lowest = std::min(lowest, band[j]);
            }
            if (highest != lowest) std::copy_n(table.colours[highest].begin(), 3, out.at(x, y));
        }
}

}  // namespace

double Scale::place(double l) const {
    if (decades <= 0) return l / top;
    return l > 0 ? 1 + std::log10(l / top) / decades : 0;
}

double Scale::value_at(double place) const {
    return decades <= 0 ? top * place : top * std::pow(10, decades * (place - 1));
}

double round_up_125(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double m : {1., 2., 5.})
        if (m * power >= value * (1 - 1e-9)) return m * power;
    return 10 * power;
}

std::vector<double> ticks(const Scale& s) {
    std::vector<double> all;
    if (s.decades <= 0) {
        for (int i = 0; i <= 5; ++i) all.push_back(s.top * i / 5);
        return all;
    }
    const double bottom = s.value_at(0);
    for (int e = int(std::floor(std::log10(bottom))) - 1; e <= int(std::ceil(std::log10(s.top))); ++e)
        for (const double m : {1., 2., 5.})
            if (const double v = m * std::pow(10, e); v >= bottom * .999 && v <= s.top * 1.001) all.push_back(v);
    return all;
}

std::string tick_text(double tick) { return fmt::format(tick >= 1 ? "{:.0f}" : "{:.3g}", tick); }

Scale falsecolor_scale(const image::Picture& p, const ToneOptions& o) {
    return {o.max_cdm2 > 0 ? o.max_cdm2 : automatic_top(p), o.decades};
}

ColourTable falsecolor_table(const Scale& scale, const ToneOptions& o) {
    const int levels = o.style == ToneOptions::Style::smooth ? smooth_levels : o.divisions;
    ColourTable table;
    for (int k = 0; k < levels; ++k) {
        const double t = levels > 1 ? double(k) / (levels - 1) : 1;
        // smooth levels are centred on their colour; bands divide the scale evenly
        const double from = o.style == ToneOptions::Style::smooth ? (k - .5) / (levels - 1) : double(k) / levels;
        if (k > 0) table.thresholds.push_back(scale.value_at(from));
        table.colours.push_back(ramp(t));
    }
    if (o.mask_cdm2 > 0) {  // black below; the colours above keep their places
        const size_t kept = table.index(o.mask_cdm2);
        table.thresholds.erase(table.thresholds.begin(), table.thresholds.begin() + std::ptrdiff_t(kept));
        table.colours.erase(table.colours.begin(), table.colours.begin() + std::ptrdiff_t(kept));
        table.thresholds.insert(table.thresholds.begin(), o.mask_cdm2);
        table.colours.insert(table.colours.begin(), Colour{});
    }
    return table;
}

Image8 falsecolor(const image::Picture& p, const ToneOptions& o) {
    const Scale scale = falsecolor_scale(p, o);
    const ColourTable table = falsecolor_table(scale, o);
    Image8 out;
    if (o.style == ToneOptions::Style::contours) {
        out = grey(p, automatic_exposure(p));
        draw_contours(out, p, table);
    } else {
        out = {p.width, p.height, std::vector<uint8_t>(p.rgb.size())};
        for (size_t i = 0; i + 2 < p.rgb.size(); i += 3)
            std::copy_n(table.at(image::luminance(&p.rgb[i])).begin(), 3, &out.rgb[i]);
    }
    return o.legend ? with_legend(out, scale, table) : out;
}

}  // namespace display
