// SPDX-License-Identifier: BSD-3-Clause
// See plot.h.
#include "year/plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "display/canvas.h"
#include "year/day_cells.h"
#include "year/shade_maps.h"

namespace year {
namespace {

using display::Canvas;
using display::Rectangle;

constexpr int top = 24, bottom = 40;
constexpr display::Colour night{120, 120, 130}, nothing{238, 238, 238};
constexpr display::Colour classes[4] = {{205, 226, 235}, {250, 220, 110}, {240, 140, 50}, {170, 20, 50}};

DayCells cells_of(const std::vector<View>& views) {
    std::vector<weather::Time> hours;
    for (const View& v : views)
        for (const Hour& h : v.hours) hours.push_back(h.time);
    return DayCells(hours);
}

void add_hours(Canvas& c, const View& view, const DayCells& cells, int y0,
               const std::function<std::string(const Hour&)>& link) {
    c.of(nothing).push_back({DayCells::left, y0, DayCells::days * DayCells::day_width, cells.height()});
    for (const Hour& h : view.hours) {
        if (h.is_missing) continue;
        const bool open = std::any_of(limits.begin(), limits.end(), [&](double limit) { return holds(h, limit); });
        const Rectangle r = cells.at(h.time, y0, open);
        c.of(h.dark ? night : classes[class_of(h.dgp.value)]).push_back(r);
        if (link || !h.shades.empty()) c.spots.push_back({{r}, words_of(h), link ? link(h) : ""});
    }
    cells.add_clock(c, y0);
}

// Months, and how many of their hours are above .40.
void add_months(Canvas& c, const View& view, double alpha, int y) {
    for (int month = 1; month <= 12; ++month) {
        View of_month{"", {}, view.shared};
        for (const Hour& h : view.hours)
            if (h.time.date.month == month) of_month.hours.push_back(h);
        const int x = DayCells::x_of({month, 1});
        c.words.push_back({x, y + 4, weather::day_text({month, 1}).substr(2)});
        if (of_month.hours.empty()) continue;
        const uncertainty::Interval n = hours_above(of_month, limits[1], alpha);
        c.words.push_back(
            {x, y + 20, n.low == n.high ? fmt::format("{:.0f}", n.low) : fmt::format("{:.0f}-{:.0f}", n.low, n.high)});
    }
}

void add_legend(Canvas& c, int wide_days, int y) {
    int x = DayCells::left;
    const auto entry = [&](const display::Colour& colour, const std::string& text, bool hatched = false) {
        c.of(colour).push_back({x, y, 12, 12, hatched});
        c.words.push_back({x + 16, y, text});
        x += 130;
    };
    entry(classes[0], "up to 0.35");
    entry(classes[1], "to 0.40");
    entry(classes[2], "to 0.45");
    entry(classes[3], "above 0.45");
    entry(night, "dark");
    entry(classes[0], "undecided", true);
    c.words.push_back(
        {x, y, "below months: hours above 0.40" + (wide_days > 1 ? fmt::format("; days {} apart", wide_days) : "")});
}

Canvas plot(const std::vector<View>& views, double alpha, const ShadeYear* shades, const LinkOf& link) {
    Canvas c;
    c.width = DayCells::width;
    const DayCells cells = cells_of(views);
    for (size_t k = 0; k < views.size(); ++k) {
        const View& view = views[k];
        c.words.push_back({DayCells::left, c.height + 6, view.name.empty() ? "DGP, standard time" : view.name});
        std::function<std::string(const Hour&)> of_view;
        if (link) of_view = [&](const Hour& h) { return link(k, h); };
        add_hours(c, view, cells, c.height + top, of_view);
        add_months(c, view, alpha, c.height + top + cells.height());
        c.height += top + cells.height() + bottom;
    }
    add_legend(c, cells.wide_days(), c.height + 6);
    c.height += top;
    if (shades) add_shade_maps(c, *shades);
    return c;
}

}  // namespace

std::string time_words(const weather::Time& time) {
    const std::string name = weather::name_of(time);
    return weather::day_text(time.date) + fmt::format(", {}:{}", name.substr(5, 2), name.substr(7));
}

std::string words_of(const Hour& h) {
    return time_words(h.time) + ": " +
           (h.dark ? "dark" : fmt::format("DGP {:.3f} ({:.3f} to {:.3f})", h.dgp.value, h.low(), h.high())) +
           (h.shades.empty() ? "" : "; " + h.shades);
}

void write_plot(const std::string& path, const std::vector<View>& views, double alpha, const ShadeYear* shades) {
    display::write_canvas(path, plot(views, alpha, shades, {}), "vcyear");
}

std::string plot_text(const std::vector<View>& views, double alpha, const ShadeYear* shades, const LinkOf& link) {
    return display::svg_text(plot(views, alpha, shades, link));
}

}  // namespace year
