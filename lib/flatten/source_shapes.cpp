// SPDX-License-Identifier: BSD-3-Clause
// Position and size of a source, by kind (Source of kernels/records.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

#include "base/angle.h"
#include "base/error.h"
#include "flatten/polygon.h"
#include "flatten/sources.h"

namespace flatten {
namespace {
using base::pi;

void shape_sphere(const Reals& r, Vec3 centre, Source& q) {
    q.kind = SK_SPHERE;
    q.centre = packed(vec_at(r, 0) - centre);
    q.radius = float(std::fabs(r[3]));
    q.area = float(pi * r[3] * r[3]);  // of the silhouette
}

void shape_ring(const Reals& r, const std::string& place, Vec3 centre, Source& q) {
    if (std::min(r[6], r[7]) > 0) base::fail(place, "a light ring must have inner radius 0");
    const double radius = std::max(r[6], r[7]);
    const Vec3 n = unit(vec_at(r, 3)), u = unit(std::fabs(n.z) < 0.9 ? cross(n, {0, 0, 1}) : cross(n, {1, 0, 0}));
    q.kind = SK_RING;
    q.centre = packed(vec_at(r, 0) - centre);
    q.u = packed(u * radius);
    q.v = packed(cross(n, u) * radius);
    q.normal = packed(n);
    q.area = float(pi * radius * radius);
    q.radius = float(radius);
}

void shape_cylinder(const Reals& r, const std::string& place, Vec3 centre, Source& q) {
    const Vec3 a = vec_at(r, 0), b = vec_at(r, 3);
    q.kind = SK_CYLINDER;
    q.centre = packed((a + b) * 0.5 - centre);
    q.u = packed((b - a) * 0.5);
    q.area = float(2 * pi * r[6] * length(b - a));
    q.radius = float(r[6]);
    if (r[6] > 0.2 * length(b - a)) base::warn(place, "cylindrical light source is not long and thin");
}

// ---- polygons

// Ear clipping of a simple polygon in its plane; the fan's triangles by vertex index.  Separate from
// scene/triangulate.h, because polygons may have seams, whose corners coincide, and the order of the triangles decides
// which point a sample is.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3>& v, Vec3 n) {
    std::vector<std::array<int, 3>> out;
    std::vector<int> left(v.size());
    for (size_t i = 0; i < v.size(); i++) left[i] = int(i);
    const auto turn = [&](int a, int b, int c) { return dot(cross(v[b] - v[a], v[c] - v[b]), n); };
    while (left.size() > 3) {
        bool clipped = false;
        for (size_t i = 0; i < left.size() && !clipped; i++) {
            const int a = left[(i + left.size() - 1) % left.size()], b = left[i], c = left[(i + 1) % left.size()];
            if (turn(a, b, c) <= 0) continue;
            bool empty = true;
            for (int k : left) {
                if (v[k] == v[a] || v[k] == v[b] || v[k] == v[c]) continue;
                const auto inside = [&](int s, int e) { return dot(cross(v[e] - v[s], v[k] - v[s]), n) >= 0; };
                if (inside(a, b) && inside(b, c) && inside(c, a)) {
                    empty = false;
                    break;
                }
            }
            if (!empty) continue;
            out.push_back({a, b, c});
            left.erase(left.begin() + long(i));
            clipped = true;
        }
        if (!clipped) {  // degenerate: drop a vertex of no area
            left.erase(left.begin());
        }
    }
    out.push_back({left[0], left[1], left[2]});
    return out;
}

// Half vectors of RADIANCE's partition: quadrilaterals as parallelograms, triangles by the edge nearest the centroid,
// others as a square of equal area.
void size_vectors(const std::vector<Vec3>& v, Vec3 mid, Vec3 n, double area, Vec3& u, Vec3& w) {
    if (v.size() == 4) {
        u = (v[1] - v[0]) * 0.5;
        w = (v[3] - v[0]) * 0.5;
        return;
    }
    Vec3 along = unit(v[1] - v[0]);
    double size = std::sqrt(area) / 2;
    if (v.size() == 3) {
        size = 1e30;
        for (int i = 0; i < 3; i++) {
            const Vec3 e = unit(v[(i + 1) % 3] - v[i]);
            const double d = length(cross(mid - v[i], e));
            if (d < size) {
                size = d;
                along = e;
            }
        }
    }
    u = along * size;
    w = cross(n, along) * size;
}

// The triangles of a general polygon; each knows its part of [0,1) by area.
void add_fan(const std::vector<Vec3>& v, const std::vector<std::array<int, 3>>& triangles, Vec3 centre,
             std::vector<FanTriangle>& fans, Source& q) {
    double total = 0, done = 0;
    std::vector<double> area;
    for (const auto& t : triangles) {
        area.push_back(length(cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]])) / 2);
        total += area.back();
    }

    q.fan_at = uint32_t(fans.size());
    q.fan_count = uint32_t(triangles.size());
    q.area = float(total);

    for (size_t i = 0; i < triangles.size(); i++) {
        FanTriangle& triangle = fans.emplace_back();
        const Vec3 a = v[triangles[i][0]] - centre;
        triangle.corner = packed(a);
        triangle.edge1 = packed(v[triangles[i][1]] - centre - a);
        triangle.edge2 = packed(v[triangles[i][2]] - centre - a);
        triangle.from = float(done / total);
        done += area[i];
        triangle.upto = float(done / total);
    }
}

// The shape is the one that is drawn, or shadow rays end behind it.
void shape_polygon(const Reals& r, Vec3 centre, std::vector<FanTriangle>& fans, Source& q) {
    const Polygon polygon(r);
    const Vec3 normal = polygon.normal;
    const std::vector<Vec3> v = polygon.drawn();
    const size_t n = v.size();
    Vec3 mid;
    for (const Vec3& p : v) mid = mid + p * (1.0 / double(n));
    double radius = 0, off_plane = 0;
    for (const Vec3& p : v) {
        radius = std::max(radius, length(p - mid));
        off_plane = std::max(off_plane, std::fabs(dot(p - mid, normal)));
    }
    const bool flat = off_plane <= 1e-7 * radius;

    q.centre = packed(mid - centre);
    q.normal = packed(normal);
    q.area = float(polygon.area);
    q.radius = float(radius);
    if (n == 4 && flat && length(v[0] + v[2] - v[1] - v[3]) <= 1e-4 * radius) {
        q.kind = SK_PARALLELOGRAM;
        q.u = packed((v[1] - v[0]) * 0.5);
        q.v = packed((v[3] - v[0]) * 0.5);
        return;
    }
    q.kind = SK_POLYGON;
    Vec3 u, w;  // RADIANCE's size vectors, for -ds with -dj below 1 (spec shading 4.3)
    size_vectors(v, mid, normal, polygon.area, u, w);
    q.u = packed(u);
    q.v = packed(w);
    add_fan(v, flat ? triangulate(v, normal) : std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}, centre, fans, q);
}

}  // namespace

void shape_source(const scene::Scene& scene, const Object& surface, Vec3 centre, std::vector<FanTriangle>& fans,
                  Source& q) {
    const Reals r = scene.reals(surface);
    const std::string place = scene.place(surface);
    switch (surface.type) {
    case Type::sphere: return shape_sphere(r, centre, q);
    case Type::ring: return shape_ring(r, place, centre, q);
    case Type::cylinder: return shape_cylinder(r, place, centre, q);
    case Type::polygon: return shape_polygon(r, centre, fans, q);
    default: base::fail(place, fmt::format("a {} cannot be a light source", type_name(surface.type)));
    }
}

}  // namespace flatten
