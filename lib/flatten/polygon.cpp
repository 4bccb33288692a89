// SPDX-License-Identifier: BSD-3-Clause
// See polygon.h.
#include "flatten/polygon.h"

#include <algorithm>
#include "flatten/pack.h"

namespace flatten {

using base::Vec3;

Polygon::Polygon(const base::Span<double>& reals) : corners(reals.size() / 3) {
    constexpr double same = 1e-6;  // FTINY of the reference
    std::vector<Vec3>& v = corners;
    for (size_t i = 0; i < v.size(); i++) v[i] = vec_at(reals, 3 * i);
    if (v.size() > 3 && length(v[0] - v.back()) <= same) v.pop_back();
    Vec3 sum;  // Newell
    for (size_t i = 1; i + 1 < v.size(); i++) sum = sum + cross(v[i] - v[0], v[i + 1] - v[0]);
    const double area2 = length(sum);
    area = area2 / 2;
    if (area2 != 0) normal = sum * (1 / area2);
}

bool Polygon::is_triangles() const {
    const std::vector<Vec3>& v = corners;
    if (v.size() != 4) return v.size() == 3;
    for (size_t i = 0; i < 4; i++)
        if (!(dot(cross(v[(i + 1) % 4] - v[i], v[(i + 2) % 4] - v[(i + 1) % 4]), normal) > 0)) return false;
    const double flat = 1e-5 * std::max(1.0, length(v[2] - v[0]));
    for (size_t i = 1; i < 4; i++)
        if (!(std::fabs(dot(v[i] - v[0], normal)) <= flat)) return false;
    return true;
}

int Polygon::axis() const {
    const double a[3] = {std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
    return a[0] > a[1] ? (a[0] > a[2] ? 0 : 2) : (a[1] > a[2] ? 1 : 2);
}

double Polygon::offset(Vec3 origin) const {
    double sum = 0;
    for (const Vec3& v : corners) sum += dot(v - origin, normal);
    return sum / double(corners.size());
}

std::vector<Vec3> Polygon::drawn() const {
    std::vector<Vec3> out = corners;
    if (is_triangles()) return out;
    const int k = axis();
    const double mean = offset(corners[0]);
    for (Vec3& v : out) v[k] += (mean - dot(v - corners[0], normal)) / normal[k];
    return out;
}

}  // namespace flatten
