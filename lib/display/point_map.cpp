// SPDX-License-Identifier: BSD-3-Clause
// See point_map.h.
#include "display/point_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "display/point_cells.h"
#include "display/tone.h"

namespace display {
namespace {

constexpr int gap = 12, line = 16, side = 360, tall = 480, largest_cell = 24, bar = 14;  // pixels
constexpr double least_spot = 3;                                                         // pixels of a cell
constexpr int column_width = side + 3 * gap;
constexpr Colour unknown{238, 238, 238}, white{255, 255, 255};

// From the least to the greatest value, without a top: in proportion, or by their logarithm where they span more than a
// decade.
Scale scale_of(const MapColumn& column) {
    if (column.top > 0) return {column.top, 0};
    double low = HUGE_VAL, high = 0;
    for (const std::vector<double>& values : column.values)
        for (const double v : values)
            if (v > 0 && std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    if (!(high > 0)) return {1, 0};
    const double top = round_up_125(high), bottom = 1 / round_up_125(1 / low);
    return {top, top / bottom <= 10 ? 0 : std::min(3., std::log10(top / bottom))};
}

// The pixels of a grid's maps: the cells they show, and where they lie between points.
class Raster {
public:
    explicit Raster(const std::vector<image::Point>& points) : cells_(points) {
        scale_ = std::min({side / cells_.width(), tall / cells_.height(), largest_cell / cells_.cell()});
        if (scale_ * cells_.cell() > 4) scale_ = std::floor(scale_ * cells_.cell()) / cells_.cell();  // even cells
        width = std::max(1, int(std::lround(cells_.width() * scale_)));
        height = std::max(1, int(std::lround(cells_.height() * scale_)));
        places_.resize(size_t(width) * size_t(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                cells_.look((x + .5) / scale_, (height - y - .5) / scale_,
                            places_[size_t(y) * size_t(width) + size_t(x)]);
    }
    int width = 0, height = 0;
    double cell() const { return scale_ * cells_.cell(); }
    int point(int x, int y) const { return at(x, y).point; }
    double between(int x, int y, const std::vector<double>& values) const {
        double sum = 0, weight = 0;
        for (const auto& [k, w] : at(x, y).near)
            if (std::isfinite(values[k])) sum += double(w) * values[k], weight += double(w);
        return weight > 0 ? sum / weight : NAN;
    }

private:
    const PointCells::Place& at(int x, int y) const { return places_[size_t(y) * size_t(width) + size_t(x)]; }
    PointCells cells_;
    double scale_ = 1;  // pixels
    std::vector<PointCells::Place> places_;
};

// Equal pixels as rectangles: runs of a row, which go on below where the next row has the same run.
template <class Class, class Add>
void add_runs(int width, int height, const Class& of, const Add& add) {
    struct Run {
        int x, wide, y;
        long what;
    };
    std::vector<Run> open, now;
    for (int y = 0; y <= height; ++y, open.swap(now)) {
        now.clear();
        for (int x = 0; y < height && x < width;) {
            const long what = of(x, y);
            const int start = x;
            while (x < width && of(x, y) == what) ++x;
            if (what >= 0) now.push_back({start, x - start, y, what});
        }
        for (const Run& above : open) {
            const auto same = std::find_if(now.begin(), now.end(), [&](const Run& r) {
                return r.x == above.x && r.wide == above.wide && r.what == above.what;
            });
            if (same != now.end()) same->y = above.y;
            else add(above.what, Rectangle{above.x, above.y, above.wide, y - above.y});
        }
    }
}

void add_contour(Canvas& c, const Raster& raster, const std::vector<double>& values, double limit, int x0, int y0) {
    const auto above = [&](int x, int y) {
        const double v = raster.point(x, y) < 0 ? NAN : raster.between(x, y, values);
        return std::isnan(v) ? -1 : int(v >= limit);
    };
    const auto crossed = [&](int x, int y) -> long {
        const int here = above(x, y), right = x + 1 < raster.width ? above(x + 1, y) : -1,
                  below = y + 1 < raster.height ? above(x, y + 1) : -1;
        return here >= 0 && ((right >= 0 && right != here) || (below >= 0 && below != here)) ? 0 : -1;
    };
    add_runs(raster.width, raster.height, crossed, [&](long, const Rectangle& r) {
        c.of(black).push_back({x0 + r.x - 1, y0 + r.y - 1, r.width + 2, r.height + 2});
        c.of(white).push_back({x0 + r.x, y0 + r.y, r.width, r.height});
    });
}

void add_map(Canvas& c, const Raster& raster, const MapColumn& column, size_t grid, const ColourTable& table, int x0,
             int y0) {
    const std::vector<double>& values = column.values[grid];
    const auto of = [&](int x, int y) -> long {
        const int k = raster.point(x, y);
        if (k < 0) return -1;
        const double v = values[size_t(k)];
        const size_t colour = std::isfinite(v) ? table.index(v) : table.colours.size();
        return long(2 * colour + size_t(!column.hatched.empty() && column.hatched[grid][size_t(k)]));
    };
    add_runs(raster.width, raster.height, of, [&](long what, const Rectangle& r) {
        const size_t k = size_t(what / 2);
        c.of(k < table.colours.size() ? table.colours[k] : unknown)
            .push_back({x0 + r.x, y0 + r.y, r.width, r.height, what % 2 == 1});
    });
    if (column.limit) add_contour(c, raster, values, *column.limit, x0, y0);
}

void add_spots(Canvas& c, const Raster& raster, size_t grid, const WordsOfPoint& words, int x0, int y0) {
    std::map<long, Spot> spots;
    const auto of = [&](int x, int y) -> long { return raster.point(x, y); };
    add_runs(raster.width, raster.height, of, [&](long point, const Rectangle& r) {
        spots[point].parts.push_back({x0 + r.x, y0 + r.y, r.width, r.height});
    });
    for (auto& [point, spot] : spots) {
        spot.text = words(grid, size_t(point));
        c.spots.push_back(std::move(spot));
    }
}

void add_legend(Canvas& c, const MapColumn& column, const Scale& scale, const ColourTable& table, int x0, int y0) {
    constexpr int step = 4;
    for (int x = 0; x < side; x += step)
        c.of(table.at(scale.value_at((x + step / 2.) / side))).push_back({x0 + x, y0, step, bar});
    int free = x0;
    for (const double tick : ticks(scale)) {
        const std::string text = tick_text(tick);
        const int x = x0 + int(scale.place(tick) * (side - 1) + .5), left = x - 3 * int(text.size());
        if (left < free - gap) continue;
        c.of(black).push_back({x, y0 + bar, 1, 3});
        c.words.push_back({left, y0 + bar + 4, text});
        free = left + 8 * int(text.size()) + gap;
    }
    std::string below = column.unit;
    if (column.limit) below += fmt::format("; line: {:.4g}", *column.limit);
    if (!column.says_hatched.empty()) below += "; " + column.says_hatched;
    c.words.push_back({x0, y0 + bar + 4 + line, below});
    const double at = column.limit ? scale.place(*column.limit) : -1;
    if (at < 0 || at > 1) return;
    c.of(black).push_back({x0 + int(at * side) - 1, y0 - 2, 3, bar + 4});
    c.of(white).push_back({x0 + int(at * side), y0 - 1, 1, bar + 2});
}

}  // namespace

Canvas point_maps(const std::vector<std::string>& names, const std::vector<std::vector<image::Point>>& grids,
                  const std::vector<MapColumn>& columns, const WordsOfPoint& words) {
    Canvas c;
    c.width = gap + int(columns.size()) * column_width;
    c.height = gap;
    std::vector<Scale> scales;
    std::vector<ColourTable> tables;
    for (const MapColumn& column : columns) {
        scales.push_back(scale_of(column));
        ToneOptions smooth;
        smooth.style = ToneOptions::Style::smooth;
        tables.push_back(falsecolor_table(scales.back(), smooth));
    }
    const auto left = [](size_t column) { return gap + int(column) * column_width; };
    for (size_t g = 0; g < grids.size(); ++g) {
        const Raster raster(grids[g]);
        c.words.push_back({gap, c.height, names[g]});
        c.height += line;
        for (size_t k = 0; k < columns.size(); ++k) add_map(c, raster, columns[k], g, tables[k], left(k), c.height);
        if (words && raster.cell() >= least_spot) add_spots(c, raster, g, words, left(0), c.height);
        c.height += raster.height + gap;
    }
    for (size_t k = 0; k < columns.size(); ++k) add_legend(c, columns[k], scales[k], tables[k], left(k), c.height + 4);
    for (size_t k = 1; k < columns.size(); ++k) c.spots_again.push_back(left(k) - left(0));
    c.height += bar + 2 * line + 2 * gap;
    return c;
}

}  // namespace display
