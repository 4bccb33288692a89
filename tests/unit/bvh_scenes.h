// SPDX-License-Identifier: BSD-3-Clause
// Scenes and rays for the tests and the measurement of traversal, made from a seed.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>
#include "bvh/build.h"

namespace bvh_scenes {

struct Vec {
    double x, y, z;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }
inline kernels::Packed3 packed(Vec a) { return {float(a.x), float(a.y), float(a.z)}; }

struct Random {
    std::mt19937 engine;
    explicit Random(unsigned seed) : engine(seed) {}
    double in(double a, double b) { return a + (b - a) * (engine() / 4294967296.0); }
    Vec point(double r) { return {in(-r, r), in(-r, r), in(-r, r)}; }
    Vec direction() {
        const double z = in(-1, 1), a = in(0, 6.283185307179586), s = std::sqrt(1 - z * z);
        return {s * std::cos(a), s * std::sin(a), z};
    }
};

struct Ray {
    float org[3], tmin, dir[3], tmax;
};

constexpr uint32_t transparent = 0x80000000u;  // ID_TRANSPARENT

// A scene under construction; input() is a view of it, `tree` its part.
struct Scene {
    std::vector<float> vertices, polygon_uv;
    std::vector<kernels::Shape> shapes;
    std::vector<kernels::Instance> instances;
    std::vector<uint32_t> triangles, tri_prim, shape_prim;
    struct Part {
        size_t triangle, triangles, shape, shapes;
    };
    std::vector<Part> parts;
    uint32_t next_prim = 0;

    uint32_t vertex(Vec p) {
        vertices.insert(vertices.end(), {float(p.x), float(p.y), float(p.z)});
        return uint32_t(vertices.size() / 3 - 1);
    }
    void triangle(uint32_t a, uint32_t b, uint32_t c, uint32_t id) {
        triangles.insert(triangles.end(), {a, b, c});
        tri_prim.push_back(id);
    }
    void triangle(Vec a, Vec b, Vec c, uint32_t flag = 0) {
        const uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
        triangle(i, j, k, next_prim++ | flag);
    }
    void quad(Vec corner, Vec u, Vec v, uint32_t flag = 0) {
        const uint32_t a = vertex(corner), b = vertex(corner + u), c = vertex(corner + u + v), d = vertex(corner + v);
        triangle(a, b, c, next_prim | flag);
        triangle(a, c, d, next_prim++ | flag);
    }
    void box(Vec lo, Vec size, uint32_t flag = 0) {
        const Vec x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
        quad(lo, x, y, flag);
        quad(lo, y, z, flag);
        quad(lo, z, x, flag);
        quad(lo + z, x, y, flag);
        quad(lo + x, y, z, flag);
        quad(lo + y, z, x, flag);
    }
    kernels::Shape& shape(uint32_t kind, uint32_t flag) {
        shape_prim.push_back(next_prim++ | flag);
        shapes.push_back({});
        shapes.back().kind = kind;
        return shapes.back();
    }
    void sphere(Vec c, double r, uint32_t flag = 0) {
        kernels::Shape& s = shape(SHAPE_SPHERE, flag);
        s.centre = packed(c);
        s.radius = float(r);
    }
    void cone(Vec p0, Vec axis, double length, double r0, double r1, uint32_t flag = 0) {
        kernels::Shape& s = shape(SHAPE_CONE, flag);
        s.centre = packed(p0);
        s.normal = packed(unit(axis));
        s.length = float(length);
        s.radius = float(r0);
        s.other_radius = float(r1);
    }
    void ring(Vec c, Vec n, double r0, double r1, uint32_t flag = 0) {
        kernels::Shape& s = shape(SHAPE_RING, flag);
        s.centre = packed(c);
        s.normal = packed(unit(n));
        s.radius = float(r1);
        s.other_radius = float(r0);
    }
    // The polygon of the given vertices (any number of loops joined by seams), as RADIANCE projects it.
    void polygon(const std::vector<Vec>& p, uint32_t flag = 0) {
        Vec n{0, 0, 0};
        for (size_t i = 1; i + 1 < p.size(); i++) n = n + cross(p[i] - p[0], p[i + 1] - p[0]);
        n = unit(n);
        double offset = 0;
        for (Vec v : p) offset += dot(v, n) / double(p.size());
        const double ax = std::fabs(n.x), ay = std::fabs(n.y), az = std::fabs(n.z);
        const uint32_t axis = ax > ay && ax > az ? 0 : ay > az ? 1 : 2;
        kernels::Shape& s = shape(SHAPE_POLYGON, flag);
        s.normal = packed(n);
        s.offset = float(offset);
        s.dropped_axis = axis;
        s.uv_at = uint32_t(polygon_uv.size());
        s.corners = uint32_t(p.size());
        double size = 0;
        for (Vec v : p) size = std::max({size, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
        s.margin = float(5e-7 * size);
        for (const auto coordinate : {axis == 0 ? &Vec::y : &Vec::x, axis == 2 ? &Vec::y : &Vec::z}) {
            const size_t row = polygon_uv.size();
            polygon_uv.push_back(float(p.back().*coordinate));
            for (Vec v : p) polygon_uv.push_back(float(v.*coordinate));
            polygon_uv.resize(row + (p.size() + 7) / 8 * 8 + 1, NAN);
        }
    }
    // An instance of part `tree`: world = rows (3x3, orthogonal times scale) local + move.
    void instance(uint32_t tree, const double rows[9], double scale, Vec move, uint32_t forced = 0) {
        kernels::Instance& one = instances.emplace_back();
        const double m[3] = {move.x, move.y, move.z};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) one.to_tree[4 * i + j] = float(rows[3 * j + i] / scale);
            one.to_tree[4 * i + 3] = float(m[i]);
        }
        one.tree = tree;
        one.forced = forced;
    }
    void end_part() {
        const size_t t0 = parts.empty() ? 0 : parts.back().triangle + parts.back().triangles;
        const size_t s0 = parts.empty() ? 0 : parts.back().shape + parts.back().shapes;
        parts.push_back({t0, tri_prim.size() - t0, s0, shape_prim.size() - s0});
    }
    // Tree k of the inputs is parts[k].
    std::vector<bvh::Input> input() const {
        std::vector<bvh::Input> in;
        for (const Part& p : parts) {
            bvh::Input t;
            t.vertices = vertices.data();
            t.vertex_count = vertices.size() / 3;
            t.triangles = triangles.data() + 3 * p.triangle;
            t.tri_prim = tri_prim.data() + p.triangle;
            t.triangle_count = p.triangles;
            t.shapes = shapes.data();
            t.shape_prim = shape_prim.data();
            t.first_shape = p.shape;
            t.shape_count = p.shapes;
            t.polygon_uv = polygon_uv.data();
            in.push_back(t);
        }
        in[0].instances = instances.data();
        in[0].instance_count = instances.size();
        return in;
    }
};

// `count` things of every kind within a cube of half side 2, a third of them transparent.
inline void add_things(Scene& s, Random& r, int count) {
    for (int i = 0; i < count; i++) {
        const uint32_t flag = r.engine() % 3 == 0 ? transparent : 0;
        const Vec c = r.point(2), d = r.direction(), e = unit(cross(d, r.direction())), f = cross(d, e);
        const double size = std::pow(10, r.in(-1.5, -0.2));
        switch (r.engine() % 8) {
        case 0: s.sphere(c, size, flag); break;
        case 1: s.cone(c, d, 2 * size, size * 0.5, size * 0.5, flag); break;
        case 2: s.cone(c, d, 2 * size, r.engine() % 2 ? 0 : size, size * 0.3, flag); break;
        case 3: s.ring(c, d, r.engine() % 2 ? 0 : size * 0.5, size, flag); break;
        case 4: {  // a square with a square hole, joined by a seam
            const auto at = [&](double x, double y) { return c + e * (x * size) + f * (y * size); };
            s.polygon({at(-1, -1), at(1, -1), at(1, 1), at(-1, 1), at(-1, -1), at(-.5, -.5), at(-.5, .5), at(.5, .5),
                       at(.5, -.5), at(-.5, -.5)},
                      flag);
            break;
        }
        case 5: {  // a star
            std::vector<Vec> p;
            for (int k = 0; k < 10; k++) {
                const double a = 0.6283185307 * k, q = size * (k % 2 ? 0.4 : 1);
                p.push_back(c + e * (q * std::cos(a)) + f * (q * std::sin(a)));
            }
            s.polygon(p, flag);
            break;
        }
        case 6: s.quad(c, e * size, f * (size * 0.7), flag); break;
        default: s.triangle(c, c + d * size, c + e * size, flag); break;
        }
    }
}

// All kinds of things, coincident faces, and, if asked, instances of two other trees (rotated, scaled, mirrored).
inline Scene random_scene(unsigned seed, int count, bool instances) {
    Scene s;
    Random r(seed);
    add_things(s, r, count);
    s.quad({-1, -1, 0.5}, {2, 0, 0}, {0, 2, 0});  // two coincident faces: the lower number wins
    s.quad({-0.5, -0.5, 0.5}, {2, 0, 0}, {0, 2, 0}, transparent);
    if (instances) {
        for (int i = 0; i < 20; i++) {
            const Vec x = r.direction(), y = unit(cross(x, r.direction())), z = cross(x, y) * (i % 3 == 0 ? -1 : 1);
            const double rows[9] = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
            s.instance(i % 2 + 1, rows, r.in(0.1, 0.4), r.point(2), i % 5 == 0 ? 2 : i % 7 == 0 ? 1 : 0);
        }
    }
    s.end_part();
    if (instances) {
        add_things(s, r, 60);
        s.end_part();
        s.sphere({0, 0, 0}, 0.5);
        s.end_part();
    }
    return s;
}

// Rays between random points, some of limited length, some parallel to axes, some in coordinate planes.
inline std::vector<Ray> random_rays(unsigned seed, int count) {
    Random r(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; i++) {
        Vec o = r.point(i % 10 == 0 ? 30 : 3), d = i % 10 == 0 ? unit(r.point(2) - o) : r.direction();
        if (i % 16 == 1) d = {0, 0, i % 32 == 1 ? 1.0 : -1.0};
        if (i % 16 == 2) d = unit({d.x, 0, d.z});
        rays.push_back({{float(o.x), float(o.y), float(o.z)},
                        i % 3 == 0 ? 1e-6f : 0.0f,
                        {float(d.x), float(d.y), float(d.z)},
                        i % 4 == 0 ? 1.0f : 1e30f});
    }
    return rays;
}

// A closed sphere of (2 n^2) triangles with shared vertices, about c.
inline Scene sphere_mesh(int n, double radius, Vec c, double bump = 0, bool finish = true, Scene start = Scene()) {
    Scene s = std::move(start);
    const int m = 2 * n;
    const auto at = [&](int i, int j) {
        const double th = 3.14159265358979 * i / n, ph = 3.14159265358979 * j / n;
        const double q = radius * (1 + bump * std::sin(9 * th) * std::cos(11 * ph) * std::sin(th));
        return c + Vec{q * std::sin(th) * std::cos(ph), q * std::sin(th) * std::sin(ph), q * std::cos(th)};
    };
    std::vector<uint32_t> v((n + 1) * m);
    const uint32_t top = s.vertex(at(0, 0)), bottom = s.vertex(at(n, 0));
    for (int i = 0; i <= n; i++)
        for (int j = 0; j < m; j++) v[i * m + j] = i == 0 ? top : i == n ? bottom : s.vertex(at(i, j));
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < m; j++) {
            const uint32_t a = v[i * m + j], b = v[(i + 1) * m + j], d = v[i * m + (j + 1) % m],
                           e = v[(i + 1) * m + (j + 1) % m];
            if (i < n - 1) s.triangle(a, b, e, s.next_prim++);
            if (i > 0) s.triangle(a, e, d, s.next_prim++);
        }
    }
    if (finish) s.end_part();
    return s;
}

}  // namespace bvh_scenes
