// SPDX-License-Identifier: BSD-3-Clause
// Luminance (cd/m2, 179 lm/W) as colours, logarithmic over some decades or linear, with a legend on the right.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/tone.h"

namespace image {
namespace {

// Top of the scale: what all but a thousandth of the lit pixels stay below (the sun must not flatten the room).
double automatic_top(const Picture& p) {
    std::vector<double> lit;
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const double l = luminance(&p.rgb[i]);
        if (l > 1e-6 && std::isfinite(l)) lit.push_back(l);
    }
    if (lit.empty()) return 1000;
    const auto at = lit.begin() + std::ptrdiff_t(.999 * double(lit.size() - 1));
    std::nth_element(lit.begin(), at, lit.end());
    return round_up_125(*at);
}

struct Scale {
    double top, decades;  // decades 0: linear from 0
    double place(double l) const {
        if (decades <= 0) return l / top;
        return l > 0 ? 1 + std::log10(l / top) / decades : 0;
    }
    std::vector<double> ticks() const {
        std::vector<double> all;
        if (decades <= 0) {
            for (int i = 0; i <= 5; ++i) all.push_back(top * i / 5);
            return all;
        }
        const double bottom = top * std::pow(10, -decades);
        for (int e = int(std::floor(std::log10(bottom))) - 1; e <= int(std::ceil(std::log10(top))); ++e)
            for (const double m : {1., 2., 5.})
                if (const double v = m * std::pow(10, e); v >= bottom * .999 && v <= top * 1.001) all.push_back(v);
        return all;
    }
};

void fill(Image8& image, int x0, int y0, int x1, int y1, std::array<uint8_t, 3> color) {
    for (int y = std::max(y0, 0); y < std::min(y1, image.height); ++y)
        for (int x = std::max(x0, 0); x < std::min(x1, image.width); ++x)
            std::copy(color.begin(), color.end(), image.at(x, y));
}

Image8 with_legend(const Image8& plain, const Scale& scale) {
    const int size = std::max(1, std::min(plain.height, plain.width) / 300);  // of a font dot
    const int line = 9 * size, bar = 16 * size, pad = 6 * size;
    const std::array<uint8_t, 3> ink{235, 235, 235}, ground{24, 24, 24};
    Image8 out;
    out.width = plain.width + pad + bar + 2 * size + text_width("100000", size) + 2 * pad;
    out.height = plain.height;
    out.rgb.resize(3 * size_t(out.width) * out.height);
    fill(out, 0, 0, out.width, out.height, ground);
    for (int y = 0; y < plain.height; ++y)
        std::copy(plain.at(0, y), plain.at(0, y) + 3 * size_t(plain.width), out.at(0, y));
    const int left = plain.width + pad, top = pad + line + pad, bottom = out.height - pad - line / 2;
    draw_text(out, left, pad, "cd/m2", size, ink);
    for (int y = top; y < bottom; ++y)
        fill(out, left, y, left + bar, y + 1, ramp((bottom - 1 - y) / std::max(1., bottom - 1. - top)));
    int last = bottom + 2 * line;
    for (const double tick : scale.ticks()) {
        const int y = bottom - 1 - int(scale.place(tick) * (bottom - 1 - top) + .5);
        if (last - y < line) continue;  // no room
        last = y;
        fill(out, left + bar, y, left + bar + 2 * size, y + 1, ink);
        draw_text(out, left + bar + 4 * size, y - 3 * size,
                  tick >= 1 ? fmt::format("{:.0f}", tick) : fmt::format("{:.3g}", tick), size, ink);
    }
    return out;
}

}  // namespace

std::array<uint8_t, 3> ramp(double t) {
    static const double stops[][3] = {{16, 8, 40},   {44, 30, 130},  {36, 88, 180},  {20, 140, 160},
                                      {60, 178, 92}, {180, 196, 60}, {250, 190, 70}, {255, 222, 210}};
    constexpr int last = int(sizeof stops / sizeof stops[0]) - 1;
    t = t > 0 ? std::min(t, 1.0) * last : 0;  // also NaN
    const int i = std::min(int(t), last - 1);
    std::array<uint8_t, 3> c{};
    for (size_t k = 0; k < 3; ++k) c[k] = uint8_t(stops[i][k] + (t - i) * (stops[i + 1][k] - stops[i][k]) + .5);
    return c;
}

double round_up_125(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double m : {1., 2., 5.})
        if (m * power >= value * (1 - 1e-9)) return m * power;
    return 10 * power;
}

Image8 falsecolor(const Picture& p, const ToneOptions& options) {
    const Scale scale{options.max_cdm2 > 0 ? options.max_cdm2 : automatic_top(p), options.decades};
    Image8 out{p.width, p.height, std::vector<uint8_t>(p.rgb.size())};
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const auto c = ramp(scale.place(luminance(&p.rgb[i])));
        std::copy(c.begin(), c.end(), &out.rgb[i]);
    }
    return options.legend ? with_legend(out, scale) : out;
}

}  // namespace image
