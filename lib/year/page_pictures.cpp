// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a page (page.h).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/hypot.h"
#include "base/printable.h"
#include "display/file.h"
#include "report/page_figures.h"
#include "year/page.h"
#include "year/plot.h"

namespace year {
namespace {

std::string image_data(const display::Image8& image) {
    return "data:image/png;base64," + base::base64(display::png_bytes(image, ""));
}

// Of views without a name: the only one there is.
const view::View* eye_of(const Page& page, const std::string& name) {
    for (const view::NamedView& eye : page.eyes)
        if (eye.name == name || (page.views.size() == 1 && page.eyes.size() == 1)) return &eye.view;
    return nullptr;
}

report::Page::Legend legend_of(const display::Scale& scale) {
    report::Page::Legend legend;
    for (int k = 0; k <= 16; ++k) {
        const display::Colour c = display::ramp(k / 16.);
        legend.colours.push_back(fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]));
    }
    for (const double tick : display::ticks(scale))
        legend.ticks.emplace_back(scale.place(tick), fmt::format("{:g}", tick));
    return legend;
}

}  // namespace

std::string place_of(size_t view, const weather::Time& time) {
    return fmt::format("v{}_{}", view, weather::name_of(time));
}

const image::Picture* picture_of(const Page& page, const std::string& view, const weather::Time& time) {
    for (const image::Picture& p : page.pictures)
        if (p.header.view_name == view && p.header.sky_name == weather::name_of(time)) return &p;
    return nullptr;
}

namespace {

// North, and how long some metres are, over a plan of so many pixels a metre; north: the y axis in the picture.
std::string scale_of_plan(const image::Picture& p, double metre, std::pair<double, double> north, double size) {
    const auto [x, y] = north;
    const double length = base::hypot(x, y), right = p.width - 1.2 * size, top = 1.4 * size;
    double metres = 1;
    for (const double m : {1., 2., 5., 10., 20., 50.})
        if (m * metre < p.width / 3.) metres = m;
    std::string out = fmt::format(
        "<g class=\"scale\"><path stroke-width=\"{:.1f}\" d=\"M{:.1f} {:.1f}v{:.1f}h{:.1f}v-{:.1f}\"/><text "
        "font-size=\"{:.1f}\" x=\"{:.1f}\" y=\"{:.1f}\">{:g} m</text>",
        size / 16, size / 2, p.height - .8 * size, .3 * size, metres * metre, .3 * size, size / 2, size / 2,
        p.height - .9 * size, metres);
    if (length > 0) {
        const double dx = x / length, dy = y / length;
        out += fmt::format(
            "<path stroke-width=\"{:.1f}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}m{:.1f} {:.1f}L{:.1f} {:.1f}l{:.1f} "
            "{:.1f}\"/><text font-size=\"{:.1f}\" x=\"{:.1f}\" y=\"{:.1f}\">N</text>",
            size / 12, right - dx * size / 2, top - dy * size / 2, right + dx * size / 2, top + dy * size / 2,
            (-dx + dy) * size / 4, (-dy - dx) * size / 4, right + dx * size / 2, top + dy * size / 2,
            (-dx - dy) * size / 4, (-dy + dx) * size / 4, size / 2, right + dx * size * .75 - size / 6,
            top + dy * size * .75 + size / 6);
    }
    return out + "</g>\n";
}

}  // namespace

std::string plan_figure(const Page& page) {
    if (!page.plan) return "";
    const image::Picture& p = *page.plan;
    if (!p.header.view || p.header.view->type != 'l') base::fail("-plan", "is no parallel view (ptrace -vtl)");
    const view::Projector down(*p.header.view);
    const view::View& v = down.view();
    const double arrow = std::max(p.width, p.height) / 12.;
    std::string out = fmt::format(
        "<figure class=\"room\" style=\"max-width:{3:.0f}mm\"><svg viewBox=\"0 0 {0} {1}\" role=\"img\" "
        "aria-label=\"plan\"><image href=\"{2}\" width=\"{0}\" height=\"{1}\" opacity=\".6\"/>\n",
        p.width, p.height, image_data(display::tone(p, {})), std::min(110., 95. * p.width / p.height));
    const auto along = [&](const base::Vec3& d) {
        return std::pair(base::dot(d, down.right()) / v.vh * p.width, -base::dot(d, down.up()) / v.vv * p.height);
    };
    out += scale_of_plan(p, p.width / v.vh, along({0, 1, 0}), arrow);
    for (size_t k = 0; k < page.views.size(); ++k) {
        const view::View* eye = eye_of(page, page.views[k].name);
        if (!eye) continue;
        const auto [x0, y0] = along(eye->vp - v.vp);
        const auto [dx, dy] = along(eye->vd);
        const double x = x0 + (.5 - v.vs) * p.width, y = y0 + (.5 + v.vl) * p.height,
                     length = std::max(1e-9, base::hypot(dx, dy));
        const Verdict& of = page.verdicts[k];
        out += fmt::format(
            "<g class=\"arrow class{}\"><circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/><path "
            "stroke-width=\"{:.1f}\" "
            "d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}\"/><text font-size=\"{:.1f}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>\n",
            of.worst, x, y, arrow / 6, arrow / 8, x, y, dx / length * arrow, dy / length * arrow, arrow / 2,
            x + dx / length * arrow, y + dy / length * arrow + arrow / 2, base::escaped(of.view));
    }
    return out +
           "</svg><figcaption>From above: where the views look, in the colour of their class</figcaption></figure>\n";
}

std::string hour_figures(const Page& page) {
    display::ToneOptions colours;
    colours.kind = display::ToneOptions::Kind::falsecolor, colours.legend = false;
    for (const image::Picture& p : page.pictures)  // one scale
        colours.max_cdm2 = std::max(colours.max_cdm2, display::falsecolor_scale(p, {}).top);
    std::string out;
    for (size_t k = 0; k < page.views.size(); ++k)
        for (const Hour& h : page.views[k].hours) {
            const image::Picture* p = picture_of(page, page.views[k].name, h.time);
            if (!p) continue;
            const std::string name = page.views[k].name,
                              drawn = p->header.state.empty() ? "" : "; drawn: " + p->header.state;
            out += fmt::format(
                "<figure id=\"{}\"><img alt=\"luminance\" src=\"{}\"><figcaption>{}{}</figcaption></figure>\n",
                place_of(k, h.time), image_data(display::tone(*p, colours)),
                base::escaped(name.empty() ? "" : name + ", "), base::escaped(words_of(h) + drawn));
        }
    if (out.empty()) return "";
    const display::Scale scale = display::falsecolor_scale(page.pictures[0], colours);
    return "<div class=\"hours\">\n" + out + "</div>\n" + report::legend(legend_of(scale));
}

}  // namespace year
