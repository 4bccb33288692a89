// SPDX-License-Identifier: BSD-3-Clause
// Ear clipping in the plane of the two smaller components of the normal; quadratic, so large outlines fall back to a
// fan.
#include "scene/triangulate.h"
#include <cmath>

namespace scene {

namespace {

struct Flat {
    double x, y;
};
double area2(Flat a, Flat b, Flat c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

}  // namespace

std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<base::Vec3>& v) {
    const size_t n = v.size();
    std::vector<std::array<uint32_t, 3>> triangles;
    base::Vec3 normal;
    for (size_t i = 1; i + 1 < n; i++) normal = normal + cross(v[i] - v[0], v[i + 1] - v[0]);
    int axis = 0;
    for (int j = 1; j < 3; j++)
        if (std::fabs(normal[j]) > std::fabs(normal[axis])) axis = j;
    const double sign = normal[axis] < 0 ? -1 : 1;
    std::vector<Flat> p(n);
    std::vector<uint32_t> left(n);
    for (size_t i = 0; i < n; i++) {
        p[i] = {v[i][(axis + 1) % 3], sign * v[i][(axis + 2) % 3]};  // counter-clockwise
        left[i] = uint32_t(i);
    }
    auto ear = [&](size_t i) {
        const size_t m = left.size();
        const uint32_t a = left[(i + m - 1) % m], b = left[i], c = left[(i + 1) % m];
        if (area2(p[a], p[b], p[c]) <= 0) return false;
        for (uint32_t k : left)
            if (k != a && k != b && k != c && area2(p[a], p[b], p[k]) >= 0 && area2(p[b], p[c], p[k]) >= 0 &&
                area2(p[c], p[a], p[k]) >= 0)
                return false;
        return true;
    };
    bool clipping = n <= 2000;
    for (size_t i = 0, tries = 0; left.size() > 3 && clipping;) {
        const size_t m = left.size();
        if (ear(i % m)) {
            triangles.push_back({left[(i + m - 1) % m], left[i % m], left[(i + 1) % m]});
            left.erase(left.begin() + long(i % m));
            tries = 0;
        } else {
            i = (i + 1) % m;
            clipping = ++tries <= m;  // no ear: not a simple polygon
        }
    }
    for (size_t i = 1; i + 1 < left.size(); i++) triangles.push_back({left[0], left[i], left[i + 1]});
    return triangles;
}

}  // namespace scene
