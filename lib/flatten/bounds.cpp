// SPDX-License-Identifier: BSD-3-Clause
// Extent of the surfaces of a scene.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "flatten/pack.h"
#include "flatten/surfaces.h"

namespace flatten {

constexpr double SLIVER = .25;

void grow(Box& box, Vec3 p) {
    for (int k = 0; k < 3; k++) {
        box.lo[k] = std::min(box.lo[k], p[k]);
        box.hi[k] = std::max(box.hi[k], p[k]);
    }
}

namespace {

constexpr size_t AROUND = 64;

double size_of(const Box& b) { return std::max({b.hi.x - b.lo.x, b.hi.y - b.lo.y, b.hi.z - b.lo.z}); }
double largest(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

double median(std::vector<double>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Vec3 middle_of(const std::vector<Box>& boxes) {
    Vec3 middle;
    std::vector<double> values(boxes.size());
    for (int k = 0; k < 3; k++) {
        for (size_t i = 0; i < boxes.size(); i++) values[i] = (boxes[i].lo[k] + boxes[i].hi[k]) / 2;
        (k == 0 ? middle.x : k == 1 ? middle.y : middle.z) = median(values);
    }
    return middle;
}

// Half of the surfaces lie within this distance, axis by axis.
double spread_of(const std::vector<Box>& boxes, Vec3 middle) {
    std::vector<double> values;
    for (const Box& b : boxes) values.push_back(largest((b.lo + b.hi) * .5 - middle) + size_of(b) / 2);
    return median(values);
}

// Size of the surfaces around a point: the median of those nearest to it.
double size_around(const std::vector<Box>& boxes, Vec3 p) {
    std::vector<std::pair<double, double>> near;  // distance, size
    for (const Box& b : boxes) {
        const double size = size_of(b);
        near.push_back({std::max(0., largest((b.lo + b.hi) * .5 - p) - size / 2), size});
    }
    const size_t count = std::min(AROUND, near.size());
    std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
    std::vector<double> sizes;
    for (size_t i = 0; i < count; i++) sizes.push_back(near[i].second);
    return median(sizes);
}

// In steps of a power of two near `size`, which float holds exactly.
Vec3 rounded(Vec3 p, double size) {
    const double step = std::ldexp(1, std::ilogb(std::max({size, largest(p) * 1e-6, 1e-30})));
    return {std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
}

}  // namespace

Vec3 centre_of(const std::vector<Box>& boxes, const Viewpoint* from) {
    constexpr double near_origin = 16, far_from_eye = 1024, cell = 256, far_from_points = 16;
    if (boxes.empty()) return {};
    const Vec3 middle = middle_of(boxes);
    const double spread = spread_of(boxes, middle);
    const Vec3 centre = largest(middle) <= near_origin * spread ? Vec3{} : rounded(middle, spread);
    if (from == nullptr || !within_reach(from->at)) return centre;
    const double away = largest(from->at - centre);
    if (from->size)
        return away <= far_from_points + *from->size ? centre : rounded(from->at, std::max(1., *from->size));
    const double around = size_around(boxes, from->at);
    return away <= far_from_eye * around ? centre : rounded(from->at, cell * around);
}

double radius_of(const std::vector<Box>& boxes) {
    if (boxes.empty()) return 0;
    Box all;
    for (const Box& b : boxes) grow(all, b.lo), grow(all, b.hi);
    return std::min(length(all.hi - all.lo) / 2, 4 * spread_of(boxes, middle_of(boxes)));
}

uint32_t extent_bits(double length) {
    int exponent = 0;
    std::frexp(length, &exponent);
    return uint32_t(std::clamp(exponent + 127, 1, 254)) << PRIM_EXTENT_SHIFT;
}

Plane::Plane(Vec3 normal, const Vec3* corners, size_t count) {
    double least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        double d = 0;
        for (int k = 0; k < 3; k++) d += double(float(normal[k])) * float(corners[i][k]);
        least = std::min(least, d);
        most = std::max(most, d);
    }
    offset = float((least + most) / 2);
    deviation = (most - least) / 2;
}

// The sheared corners of Woop's test round like the longest edge, and its weights like the square of that over the
// area: where a triangle is a sliver, a point moves along it.
double Plane::extent_of_triangles(const Vec3* corners, size_t count) const {
    double extent = 0;
    for (size_t i = 1; i + 1 < count; i++) {
        const Vec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0], c = b - a;
        const double longest2 = std::max({dot(a, a), dot(b, b), dot(c, c)}), area2 = length(cross(a, b));
        extent = std::max(extent, std::sqrt(longest2) * std::max(1., SLIVER * longest2 / area2));
    }
    return extent + deviation / SURFACE_ROUNDING;
}

size_t surfaces_end(const scene::Scene& s) {
    size_t end = s.objects.size();
    while (end > 0 && (!scene::is_surface(s.objects[end - 1].type) || s.objects[end - 1].type == Type::source)) end--;
    return end;
}

std::vector<Box> surface_boxes(const scene::Scene& s, Box& all) {
    std::vector<Box> boxes;
    size_t count = 0;
    const size_t step = surfaces_end(s) / MOST_BOXES + 1;
    for (const scene::Object& o : s.objects) {
        if (!scene::is_surface(o.type) || o.type == Type::source || o.type == Type::mesh || o.type == Type::instance)
            continue;
        Box box;
        const auto r = s.reals(o);
        const size_t points = o.type == Type::polygon                                                    ? r.size() / 3
                              : o.type == Type::sphere || o.type == Type::bubble || o.type == Type::ring ? 1
                                                                                                         : 2;
        const double round = o.type == Type::polygon || r.size() < 4 ? 0
                             : points == 2          ? std::max(std::fabs(r[6]), r.size() > 7 ? std::fabs(r[7]) : 0)
                             : o.type == Type::ring ? std::max(r[6], r[7])
                                                    : std::fabs(r[3]);
        for (size_t i = 0; i < points && 3 * i + 2 < r.size(); i++) {
            const Vec3 p = vec_at(r, 3 * i), d{round, round, round};
            if (!within_reach(p) || !(round < farthest)) base::fail(s.place(o), "a coordinate is beyond 1e18");
            grow(box, p - d);
            grow(box, p + d);
        }
        if (box.lo.x > box.hi.x) continue;
        grow(all, box.lo);
        grow(all, box.hi);
        if (count++ % step == 0) boxes.push_back(box);
    }
    return boxes;
}

std::vector<Box> surface_boxes(const scene::Mesh& mesh, Box& all) {
    for (const Vec3& p : mesh.positions) grow(all, p);
    std::vector<Box> boxes;
    for (size_t i = 0; i < mesh.triangles.size(); i += mesh.triangles.size() / MOST_BOXES + 1) {
        boxes.push_back({});
        for (uint32_t v : mesh.triangles[i].v) grow(boxes.back(), mesh.positions[v]);
    }
    return boxes;
}

}  // namespace flatten
