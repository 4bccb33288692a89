// SPDX-License-Identifier: BSD-3-Clause
// See page_figures.h.
#include "report/page_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/printable.h"
#include "glare/columns.h"

namespace report {

using base::escaped;

namespace {

std::string path_of(const Page::Outline& outline) {
    std::string out;
    for (const auto& ring : outline.rings) {
        for (size_t k = 0; k < ring.size(); ++k)
            out += fmt::format("{}{:.1f} {:.1f}", k ? 'L' : 'M', ring[k][0], ring[k][1]);
        out += 'Z';
    }
    return out;
}

// Names above their places, a line higher or lower where another one stands: the middle of the base line.
std::vector<std::array<double, 2>> places_of_names(const Page& page, double size) {
    std::vector<std::array<double, 2>> out;
    const auto half = [&](size_t k) { return .31 * size * double(page.outlines[k].name.size()); };
    for (size_t k = 0; k < page.outlines.size(); ++k) {
        const Page::Outline& o = page.outlines[k];
        const double x = std::clamp(double(o.x), half(k), std::max(half(k), page.width - half(k)));
        const auto is_free = [&](double y) {
            for (size_t i = 0; i < k; ++i)
                if (std::fabs(out[i][1] - y) < size && std::fabs(out[i][0] - x) < half(i) + half(k)) return false;
            return y >= size && y <= page.height;
        };
        double y = std::max(double(o.y) - .3 * size, size);
        for (int step = 1; step < 12 && !is_free(y); ++step) {
            const double up = double(o.y) - (.3 + step) * size, down = double(o.y) + (.7 + step) * size;
            y = is_free(up) ? up : down;
        }
        out.push_back({x, y});
    }
    return out;
}

}  // namespace

std::string drawing(const Page& page, const Page::Drawing& d) {
    const double size = std::max(page.width, page.height) / 32.;
    std::string out = fmt::format(
        "<figure><svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\" "
        "style=\"font-size:{3:.2f}px;stroke-width:{4:.2f}\"><image width=\"{0}\" height=\"{1}\" "
        "href=\"data:image/png;base64,{5}\"/>\n",
        page.width, page.height, escaped(d.caption), size, .11 * size, base::base64(d.png));
    const auto kind = [](const Page::Outline& o) { return o.is_source ? "source" : "region"; };
    for (const Page::Outline& o : page.outlines)
        out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind(o), path_of(o));
    const auto places = places_of_names(page, size);
    for (size_t k = 0; k < places.size(); ++k)
        out += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", kind(page.outlines[k]),
                           places[k][0], places[k][1], escaped(page.outlines[k].name));
    return out + "</svg><figcaption>" + escaped(d.caption) + "</figcaption></figure>\n";
}

// DGP from .2 to .6 as a bar with its classes, the interval and the value.
std::string dgp_bar(const Page::Number& dgp) {
    const auto x = [](double v) { return 600 * (std::clamp(v, .2, .6) - .2) / .4; };
    const double ends[] = {.2, glare::dgp_limits[0], glare::dgp_limits[1], glare::dgp_limits[2], .6};
    std::string out = "<svg class=\"bar\" viewBox=\"0 0 600 46\" aria-hidden=\"true\">";
    for (int k = 0; k < 4; ++k)
        out += fmt::format(
            "<rect class=\"class{}\" x=\"{:.1f}\" y=\"14\" width=\"{:.1f}\" height=\"16\"/>"
            "<text x=\"{:.1f}\" y=\"42\">{}</text>",
            k, x(ends[k]), x(ends[k + 1]) - x(ends[k]), (x(ends[k]) + x(ends[k + 1])) / 2, glare::dgp_classes[k]);
    for (int k = 1; k < 4; ++k) out += fmt::format("<text x=\"{:.1f}\" y=\"10\">{:.2f}</text>", x(ends[k]), ends[k]);
    if (std::isfinite(dgp.low) && std::isfinite(dgp.high))
        out += fmt::format("<rect class=\"interval\" x=\"{:.1f}\" y=\"18\" width=\"{:.1f}\" height=\"8\"/>", x(dgp.low),
                           std::max(1., x(dgp.high) - x(dgp.low)));
    return out + fmt::format("<path class=\"value\" d=\"M{0:.1f} 12v20\"/></svg>\n", x(dgp.value));
}

std::string legend(const Page::Legend& l) {
    std::string out =
        "<svg class=\"legend\" viewBox=\"0 0 600 30\" role=\"img\" aria-label=\"scale\">"
        "<defs><linearGradient id=\"scale\">";
    for (size_t k = 0; k < l.colours.size(); ++k)
        out += fmt::format("<stop offset=\"{:.4f}\" stop-color=\"{}\"/>", double(k) / double(l.colours.size() - 1),
                           l.colours[k]);
    out += "</linearGradient></defs><rect x=\"20\" width=\"520\" height=\"12\" fill=\"url(#scale)\"/>";
    for (const auto& [place, text] : l.ticks)
        out += fmt::format("<path class=\"tick\" d=\"M{0:.1f} 12v4\"/><text x=\"{0:.1f}\" y=\"27\">{1}</text>",
                           20 + 520 * place, escaped(text));
    return out + "<text x=\"574\" y=\"12\">cd/m²</text></svg>\n";
}

// As a picture, whose text has no say in the page, and which no pointer reaches: its points need no words.
std::string plan_maps(const std::string& svg) {
    const size_t words = svg.find("<g id=\"points\""), end = svg.rfind("</svg>");
    return "<img class=\"plan\" alt=\"Illuminance at the points, with a line at the limit, and half of the intervals\" "
           "src=\"data:image/svg+xml;base64," +
           base::base64(words < end ? svg.substr(0, words) + svg.substr(end) : svg) + "\">\n";
}

}  // namespace report
