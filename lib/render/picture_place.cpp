// SPDX-License-Identifier: BSD-3-Clause
// See picture_place.h.
#include "render/picture_place.h"

#include <cmath>

#include "base/angle.h"
#include "base/hypot.h"
#include "view/density.h"

namespace render {
using base::Vec3;

namespace {

// A pixel, y from the bottom, across the rim of an angular fisheye's circle of 180 degrees, or next to it: it shows
// what lies ahead of the eye.
bool crosses_rim(const view::Projector& p, int x, int y, int nx, int ny) {
    const view::View& v = p.view();
    const auto centre = p.direction((x + .5) / nx, (y + .5) / ny);
    if (v.type != 'a' || v.vh > 180 || v.vv > 180 || !centre) return false;
    return dot(*centre, p.forward()) > -base::hypot(v.vh / nx, v.vv / ny) / 2 * base::degree;
}

}  // namespace

std::optional<PicturePlace> place_of(const view::Projector& projector, Vec3 dir, int nx, int ny, bool anywhere) {
    double X, Y;
    if (!projector.locate_direction(dir, X, Y)) return {};
    const bool inside = X >= 0 && X < 1 && Y >= 0 && Y < 1;
    if (!inside && !anywhere) return {};
    const double d = view::solid_angle_density(projector, X, Y);
    if (d <= 0) return {};
    PicturePlace out{X, Y, d};
    if (!inside) return out;
    const int column = int(X * nx), row = int(Y * ny);
    const bool behind = dot(dir, projector.forward()) < 0;
    if (!anywhere && behind && crosses_rim(projector, column, row, nx, ny)) return {};
    out.pixel = uint32_t((ny - 1 - row) * nx + column);
    out.right = float(X * nx - column - .5), out.up = float(Y * ny - row - .5);
    return out;
}

}  // namespace render
