// SPDX-License-Identifier: BSD-3-Clause
// Directions, solid angles and runs of valid pixels of a view and size (geometry.h).
#include "glare/geometry.h"
#include "base/angle.h"
#include <algorithm>
#include <cmath>
#include <limits>

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

// atan(y/x) of a small positive ratio by its series, else by the library.
double angle_of(double y, double x) {
    const double t = y / x;
    if (!(x > 0 && t < 5e-3)) return std::atan2(y, x);
    const double q = t * t;
    return t * (1 - q * (1. / 3 - q * (1. / 5 - q / 7)));
}

// Solid angle of the quadrilateral a b c d: two triangles, tan(O/2) = |a.(b x c)| / (1 + a.b + b.c + c.a)
// (Van Oosterom and Strackee 1983); edges are taken as differences, which keeps all digits of small pixels.
double quadrilateral(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const double ac = dot(a, c);
    const Vec3 diagonal = c - a;
    const double n1 = std::fabs(dot(a, cross(b - a, diagonal))), m1 = 1 + dot(a, b) + dot(b, c) + ac;
    const double n2 = std::fabs(dot(a, cross(diagonal, d - a))), m2 = 1 + ac + dot(c, d) + dot(d, a);
    if (m1 > 0 && m2 > 0 && n1 < m1 && n2 < m2) return 2 * angle_of(n1 * m2 + n2 * m1, m1 * m2 - n1 * n2);
    return 2 * (angle_of(n1, m1) + angle_of(n2, m2));
}

}  // namespace

Geometry::Geometry(const view::View& v, int w, int h, bool evalglare_slips)
    : width(w), height(h), projector(v), omega(size_t(w) * h), omega_cos(size_t(w) * h) {
    if (evalglare_slips) slips_.emplace(v);
    solid_angles();
    const Vec3 forward = line_of_sight();
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const size_t i = index(x, y);
            if (!(omega[i] > 0)) continue;
            const Vec3 d = direction(x, y);
            if (dot(d, d) == 0) {
                omega[i] = 0;
                continue;
            }
            const double c = dot(forward, d);
            if (v.type == 'a' && c < 0) {
                omega[i] = -omega[i];
                continue;
            }
            omega_cos[i] = omega[i] * (slips_ ? c : std::max(c, 0.0));
        }
    find_spans();
}

void Geometry::solid_angles() {
    if (slips_) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) omega[index(x, y)] = slips_->omega(x, y, width, height);
        return;
    }
    std::vector<Corner> low = corner_row(projector, width, 0), high;
    for (int y = 0; y < height; ++y) {
        high = corner_row(projector, width, double(y + 1) / height);
        double* row = &omega[index(0, y)];
        for (int x = 0; x < width; ++x) {
            const bool all = low[x].exists && low[x + 1].exists && high[x].exists && high[x + 1].exists;
            const double size = all ? quadrilateral(low[x].d, low[x + 1].d, high[x + 1].d, high[x].d) : 0;
            row[x] = size <= 2 * pi ? size : 0;
        }
        low.swap(high);
    }
}

void Geometry::find_spans() {
    for (int r = 0; r < height; ++r) {
        row_spans.push_back(spans.size());
        const double* row = &omega[size_t(r) * width];
        for (int x = 0; x < width; ++x) {
            if (!(row[x] > 0)) continue;
            const int begin = x;
            double sum = 0;
            for (; x < width && row[x] > 0; ++x) sum += row[x];
            omega_sum += sum;
            valid_count += x - begin;
            spans.push_back({begin, x});
        }
    }
    row_spans.push_back(spans.size());
}

Vec3 Geometry::line_of_sight() const { return slips_ ? slips_->line_of_sight() : projector.forward(); }

Vec3 Geometry::direction(int x, int y) const {
    Vec3 exact;
    if (slips_)
        return slips_->direction((x + 0.5) / width, (y + 0.5) / height, slips_->forward(), exact) ? exact : Vec3{};
    const auto d = projector.direction((x + 0.5) / width, (y + 0.5) / height);
    return d ? *d : Vec3{};
}

Vec3 Geometry::seen_direction(int x, int y) const {
    Vec3 exact;
    if (!slips_) return direction(x, y);
    return slips_->direction((x + 0.5) / width, (y + 0.5) / height, slips_->line_of_sight(), exact) ? exact : Vec3{};
}

// The largest stretch of each projection, angle per picture plane length:
// perspective and cylinder at the centre, planispheric at the centre, angular at 90 degrees (theta / sin theta = pi/2).
double Geometry::pitch_bound() const {
    const view::View& v = projector.view();
    const double vh = v.vh * pi / 180, vv = v.vv * pi / 180;
    switch (v.type) {
    case 'v': return 2 * std::max(std::tan(vh / 2) / width, std::tan(vv / 2) / height);
    case 'a': return pi / 2 * std::max(vh / width, vv / height);
    case 's': return 4 * std::max(std::tan(vh / 4) / width, std::tan(vv / 4) / height);
    case 'c': return std::max(vh / width, 2 * std::tan(vv / 2) / height);
    default: return std::numeric_limits<double>::infinity();
    }
}

double Geometry::share_of_light() const {
    double sum = 0;
    for (const double each : omega_cos) sum += each;
    return sum / base::pi;
}

}  // namespace glare
