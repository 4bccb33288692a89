// SPDX-License-Identifier: BSD-3-Clause
// See plot.h.
#include "year/plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "display/canvas.h"

namespace year {
namespace {

using display::Canvas;
using display::Rectangle;

constexpr int day_width = 3, hour_height = 12, left = 40, top = 24, bottom = 40, days = 366;
constexpr display::Colour night{120, 120, 130}, nothing{238, 238, 238};
constexpr display::Colour classes[4] = {{205, 226, 235}, {250, 220, 110}, {240, 140, 50}, {170, 20, 50}};

// From the first hour that any day has to the last.
struct Rows {
    int first = 24, last = 0;
    explicit Rows(const View& view) {
        for (const Hour& h : view.hours)
            first = std::min(first, int(h.time.hour)), last = std::max(last, int(h.time.hour));
    }
    int height() const { return (last - first + 1) * hour_height; }
};

int x_of(const weather::Date& date) { return left + (date.in_leap_year() - 1) * day_width; }

// The fewest days from one to the next that has hours: as many are a column's width, so that single days are seen.
int days_apart(const std::vector<View>& views) {
    std::vector<bool> has(days + 1);
    for (const View& view : views)
        for (const Hour& h : view.hours) has[size_t(h.time.date.in_leap_year())] = true;
    int least = days, before = -1;
    for (int day = 1; day <= days; ++day) {
        if (!has[size_t(day)]) continue;
        if (before > 0) least = std::min(least, day - before);
        before = day;
    }
    return least == days ? 1 : least;
}

void add_hours(Canvas& c, const View& view, const Rows& rows, int wide_days, int y0,
               const std::function<std::string(const Hour&)>& link) {
    const int width = wide_days * day_width, end = left + days * day_width;
    c.of(nothing).push_back({left, y0, days * day_width, rows.height()});
    for (const Hour& h : view.hours) {
        if (h.is_missing) continue;
        const bool open = std::any_of(limits.begin(), limits.end(), [&](double limit) { return holds(h, limit); });
        const int x = x_of(h.time.date) - (width - day_width) / 2, x0 = std::max(left, x),
                  x1 = std::min(end, x + width);
        const Rectangle r{x0, y0 + (int(h.time.hour) - rows.first) * hour_height, x1 - x0, hour_height, open};
        c.of(h.dark ? night : classes[class_of(h.dgp.value)]).push_back(r);
        if (link) c.spots.push_back({{r}, words_of(h), link(h)});
    }
    for (int hour = rows.first; hour <= rows.last; hour += 2)
        c.words.push_back({8, y0 + (hour - rows.first) * hour_height - 5, fmt::format("{}", hour)});
}

// Months, and how many of their hours are above .40.
void add_months(Canvas& c, const View& view, double alpha, int y) {
    for (int month = 1; month <= 12; ++month) {
        View of_month{"", {}, view.shared};
        for (const Hour& h : view.hours)
            if (h.time.date.month == month) of_month.hours.push_back(h);
        const int x = x_of({month, 1});
        c.words.push_back({x, y + 4, weather::day_text({month, 1}).substr(2)});
        if (of_month.hours.empty()) continue;
        const uncertainty::Interval n = hours_above(of_month, limits[1], alpha);
        c.words.push_back(
            {x, y + 20, n.low == n.high ? fmt::format("{:.0f}", n.low) : fmt::format("{:.0f}-{:.0f}", n.low, n.high)});
    }
}

void add_legend(Canvas& c, int wide_days, int y) {
    int x = left;
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

Canvas plot(const std::vector<View>& views, double alpha, const LinkOf& link) {
    Canvas c;
    c.width = left + days * day_width + 8;
    const int wide_days = days_apart(views);
    for (size_t k = 0; k < views.size(); ++k) {
        const View& view = views[k];
        const Rows rows(view);
        c.words.push_back({left, c.height + 6, view.name.empty() ? "DGP, standard time" : view.name});
        std::function<std::string(const Hour&)> of_view;
        if (link) of_view = [&](const Hour& h) { return link(k, h); };
        add_hours(c, view, rows, wide_days, c.height + top, of_view);
        add_months(c, view, alpha, c.height + top + rows.height());
        c.height += top + rows.height() + bottom;
    }
    add_legend(c, wide_days, c.height + 6);
    c.height += top;
    return c;
}

}  // namespace

std::string words_of(const Hour& h) {
    const std::string name = weather::name_of(h.time);
    return weather::day_text(h.time.date) + fmt::format(", {}:{}: ", name.substr(5, 2), name.substr(7)) +
           (h.dark ? "dark" : fmt::format("DGP {:.3f} ({:.3f} to {:.3f})", h.dgp.value, h.low(), h.high()));
}

void write_plot(const std::string& path, const std::vector<View>& views, double alpha) {
    display::write_canvas(path, plot(views, alpha, {}), "vcyear");
}

std::string plot_text(const std::vector<View>& views, double alpha, const LinkOf& link) {
    return display::svg_text(plot(views, alpha, link));
}

}  // namespace year
