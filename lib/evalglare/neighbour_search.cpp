// SPDX-License-Identifier: BSD-3-Clause
// The reach of a search: the smallest cosine that is near, and a bound on the rows.
#include "evalglare/neighbour_search.h"
#include "base/angle.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace evalglare {
namespace {

using base::pi;

}  // namespace

NeighbourSearch::NeighbourSearch(const Geometry& geometry) : geometry_(geometry), direction_(geometry.omega.size()) {
    for (size_t i = 0; i < direction_.size(); ++i) direction_[i] = geometry.direction(i);
}

AngularRadius NeighbourSearch::radius(double opening) const {
    AngularRadius out{-2, geometry_.height};
    if (opening / 2 >= pi) return out;
    // The smallest cosine that evalglare, which compares angles, takes for near.
    const auto near = [&](double cosine) { return 2 * std::acos(cosine) <= opening; };
    out.lowest = std::cos(opening / 2);
    while (out.lowest > -1 && near(out.lowest)) out.lowest = std::nextafter(out.lowest, -2.0);
    while (out.lowest <= 1 && !near(out.lowest)) out.lowest = std::nextafter(out.lowest, 2.0);
    const double rows = rows_per_radian(opening / 2) * (opening / 2) + 1;
    if (rows < geometry_.height) out.rows = int(rows);
    return out;
}

// A bound: the largest stretch of the projection anywhere within `reach` of a pixel that counts.
double NeighbourSearch::rows_per_radian(double reach_rad) const {
    const view::View& v = geometry_.projector.view();
    const double none = std::numeric_limits<double>::infinity(), vv = v.vv * pi / 180, size = geometry_.height;
    if (v.type == 'h') return size / (2 * std::sin(vv / 2));
    if (v.type == 'a') {
        const double farthest = pi / 2 + reach_rad;
        return farthest < pi ? size / vv * farthest / std::sin(farthest) : none;
    }
    double widest = 0, highest = 0;  // of the picture's corners: angles from the view direction, and above its plane
    for (const double x : {0., 1.})
        for (const double y : {0., 1.}) {
            const auto d = geometry_.projector.direction(x, y);
            if (!d) return none;
            widest = std::max(widest, std::acos(std::clamp(dot(*d, geometry_.projector.forward()), -1.0, 1.0)));
            highest = std::max(highest, std::asin(std::min(std::fabs(dot(*d, geometry_.projector.up())), 1.0)));
        }
    const double farthest = widest + reach_rad;
    switch (v.type) {
    case 'v': return size / (2 * std::tan(vv / 2)) / std::pow(std::cos(widest), 2);
    case 'c': return size / (2 * std::tan(vv / 2)) / std::pow(std::cos(highest), 2);
    case 's': return farthest < pi ? size / (4 * std::tan(vv / 4)) / std::pow(std::cos(farthest / 2), 2) : none;
    default: return none;
    }
}

}  // namespace evalglare
