// SPDX-License-Identifier: BSD-3-Clause
// Directions and solid angles of pixels (view_geometry.h).
#include "glare/view_geometry.h"
#include <cmath>
#include "base/angle.h"
#include "base/processors.h"
#include "base/threads.h"

namespace glare {
namespace {

using base::pi;

struct Corner {
    Vec3 d;
    bool exists;
};

std::vector<Corner> corner_row(const view::Projector& p, int width, double Y) {
    std::vector<Corner> row(width + 1);
    for (int x = 0; x <= width; ++x) {
        const auto d = p.direction(double(x) / width, Y);
        row[x] = {d ? *d : Vec3{}, d.has_value()};
    }
    return row;
}

// atan(y/x): a series for small positive ratios, else the library.
double angle_of(double y, double x) {
    const double t = y / x;
    if (!(x > 0 && t < 5e-3)) return std::atan2(y, x);
    const double q = t * t;
    return t * (1 - q * (1. / 3 - q * (1. / 5 - q / 7)));
}

// Solid angle of the quadrilateral a b c d as two triangles, tan(O/2) = |a.(b x c)| / (1 + a.b + b.c + c.a) (Van
// Oosterom and Strackee 1983).  Edges are calculated as differences, which keeps all digits of small pixels.
double quadrilateral(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const double ac = dot(a, c);
    const Vec3 diagonal = c - a;
    const double n1 = std::fabs(dot(a, cross(b - a, diagonal))), m1 = 1 + dot(a, b) + dot(b, c) + ac;
    const double n2 = std::fabs(dot(a, cross(diagonal, d - a))), m2 = 1 + ac + dot(c, d) + dot(d, a);
    if (m1 > 0 && m2 > 0 && n1 < m1 && n2 < m2) return 2 * angle_of(n1 * m2 + n2 * m1, m1 * m2 - n1 * n2);
    return 2 * (angle_of(n1, m1) + angle_of(n2, m2));
}

}  // namespace

void in_rows(int height, const std::function<void(int, int)>& work) {
    constexpr size_t rows_a_share = 64;
    base::in_shares(size_t(height), rows_a_share, base::processors(),
                    [&](size_t first, size_t end) { work(int(first), int(end)); });
}

Vec3 ViewGeometry::direction(double X, double Y) const {
    const auto d = projector.direction(X, Y);
    return d ? *d : Vec3{};
}

std::vector<double> ViewGeometry::solid_angles(int width, int height) const {
    std::vector<double> out(size_t(width) * height);
    in_rows(height, [&](int first, int end) {
        std::vector<Corner> low = corner_row(projector, width, double(first) / height), high;
        for (int y = first; y < end; ++y) {
            high = corner_row(projector, width, double(y + 1) / height);
            double* row = &out[size_t(height - 1 - y) * width];
            for (int x = 0; x < width; ++x) {
                const bool all = low[x].exists && low[x + 1].exists && high[x].exists && high[x + 1].exists;
                const double size = all ? quadrilateral(low[x].d, low[x + 1].d, high[x + 1].d, high[x].d) : 0;
                row[x] = size <= 2 * pi ? size : 0;
            }
            low.swap(high);
        }
    });
    return out;
}

}  // namespace glare
