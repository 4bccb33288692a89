// SPDX-License-Identifier: BSD-3-Clause
// Rows and columns count from the bottom left: of an odd number the top row and the right column are dropped
// (pyramid.h).
#include "glare/pyramid.h"

#include <cmath>

#include "glare/luminance.h"

namespace glare {
namespace {

Level half_of(const Level& from) {
    Level to{from.width / 2, from.height / 2, {}, {}};
    for (int r = 0; r < to.height; ++r) {
        to.row.push_back(to.spans.size());
        const int top = 2 * r + from.height % 2;
        for (size_t a = from.row[top]; a < from.row[top + 1]; ++a)
            for (size_t c = from.row[top + 1]; c < from.row[top + 2]; ++c) {
                const int x0 = std::max(from.spans[a].begin, from.spans[c].begin),
                          x1 = std::min(from.spans[a].end, from.spans[c].end);
                const int p0 = (x0 + 1) / 2, p1 = std::min(x1 / 2, to.width);
                if (p0 < p1) to.spans.push_back({p0, p1});
            }
    }
    to.row.push_back(to.spans.size());
    return to;
}

}  // namespace

double Level::pixels() const {
    double n = 0;
    for (const Span& s : spans) n += s.end - s.begin;
    return n;
}

Pyramid::Pyramid(const Geometry& geometry, RammgArea its_area) : area(its_area) {
    Level level{geometry.width, geometry.height, geometry.spans, geometry.row_spans};
    if (area != RammgArea::view) {
        level.spans.assign(size_t(level.height), {0, level.width});
        for (size_t r = 0; r < level.row.size(); ++r) level.row[r] = r;
    }
    while (std::min(level.width, level.height) > 2 && level.pixels() > 0) {
        levels.push_back(std::move(level));
        level = half_of(levels.back());
    }
}

double Pyramid::contrast_of(double total) const {
    const double scale = cdm2_per_grey / (4 + 2 * std::sqrt(2.0)) / (area == RammgArea::prototype_scale ? 1 : 8);
    return total * scale / double(levels.size());  // 0/0 is nan: the picture is too small
}

}  // namespace glare
