// SPDX-License-Identifier: BSD-3-Clause
// The laws that rays must keep: none escapes from a closed room, none meets the surface that it just left.
// Compiled twice, as kernels_bvh_test.
#include "unit/avx2_main.h"
#include <string>
#include "unit/bvh_host.h"

using bvh_scenes::Vec;

// Paths within a closed sphere of triangles, half of them started exactly toward vertices and edges.
static void paths(const bvh_scenes::Scene& scene, Vec centre, double radius, int count, int bounces, int* leaks,
                  int* self) {
    const auto in = scene.input();
    const auto b8 = bvh::build8(in[0]), compact = bvh::build_compact(in[0]);
    const auto t8 = kernels::tables(scene, b8), compact_tables = kernels::tables(scene, compact);
    const auto corner = [&](size_t tri, int k) {
        const float* v = &scene.vertices[3 * scene.triangles[3 * tri + k]];
        return Vec{v[0], v[1], v[2]};
    };
    bvh_scenes::Random r(11);
    for (int i = 0; i < count; i++) {
        Vec o = centre + r.direction() * (radius * r.in(0, 0.9)), d = r.direction();
        const size_t tri = r.engine() % scene.tri_prim.size();
        const Vec of{float(o.x), float(o.y), float(o.z)};
        if (i % 4 == 0) d = unit(corner(tri, 0) - of);
        if (i % 4 == 1) {
            const double w = r.in(0, 1);
            d = unit(corner(tri, 0) * w + corner(tri, 1) * (1 - w) - of);
        }
        kernels::Ray ray = {F3(float(o.x), float(o.y), float(o.z)), 0, F3(float(d.x), float(d.y), float(d.z)), 1e30f};
        uint from = NO_HIT;
        for (int b = 0; b < bounces; b++) {
            kernels::Hit hit, compact_hit;
            kernels::wide::trace_first(&t8, &ray, RAY_ALL, &hit);
            kernels::compact::trace_first(&compact_tables, &ray, RAY_ALL, &compact_hit);
            if (hit.prim == NO_HIT || compact_hit.prim == NO_HIT) {
                ++*leaks;
                break;
            }
            if (hit.prim == from) {
                ++*self;
                break;
            }
            from = hit.prim;
            const float3 p = kernels::madd3(ray.dir, hit.t, ray.org);
            size_t k = hit.prim;  // the triangle's number is its primitive's here
            Vec n = unit(cross(corner(k, 1) - corner(k, 0), corner(k, 2) - corner(k, 0)));
            if (dot(n, Vec{ray.dir.x, ray.dir.y, ray.dir.z}) > 0) n = n * -1;
            d = unit(n + r.direction() * 0.999);
            ray.org = kernels::offset_ray(p, F3(float(n.x), float(n.y), float(n.z)), hit.t);
            ray.dir = F3(float(d.x), float(d.y), float(d.z));
        }
    }
}

TEST_CASE("a closed sphere leaks nothing, and no ray meets the triangle it left, also 1 km from the origin") {
    for (double away : {0.0, 100.0, 1000.0}) {
        int leaks = 0, self = 0;
        const Vec c{away, -0.3 * away, 0.1 * away};
        paths(bvh_scenes::sphere_mesh(80, 5, c), c, 5, 20000, 5, &leaks, &self);
        CAPTURE(away);
        CHECK(leaks == 0);
        CHECK(self == 0);
    }
}

// Rays that leave what they met: a flat thing, or a convex one on its outside, cannot be met again; from the inside of
// a curved thing of radius r, the chord at an angle with sine s to the surface is 2 r s long (checked: not much
// shorter). `error_scale` is the ray's length or the flat thing's size, whichever is larger, as kernels/geom/surface.h
// has it.
TEST_CASE("no ray meets the ground or the shape it left, whatever its size and the way to it") {
    struct Case {
        std::string name;
        double size;
        int kind;
    };
    const Case cases[] = {{"ground", 100, 0}, {"ground", 1000, 0},   {"polygon", 50, 1},
                          {"ring", 5, 2},     {"sphere", 0.05, 3},   {"sphere", 2, 3},
                          {"sphere", 100, 3}, {"cylinder", 0.02, 4}, {"cylinder", 3, 4}};
    for (const Case& c : cases) {
        bvh_scenes::Scene s;
        const Vec tilt = unit(Vec{0.1, 0.2, 1}), e = unit(cross(tilt, Vec{0, 1, 0})), f = cross(tilt, e), at{3, -2, 1};
        const double z = c.size;
        if (c.kind == 0) s.quad(at - e * z - f * (0.7 * z), e * (2 * z), f * (1.9 * z));
        if (c.kind == 1) s.polygon({at - e * z - f * z, at + e * z - f * z, at + e * z + f * z, at - e * z + f * z});
        if (c.kind == 2) s.ring(at, tilt, 0, z);
        if (c.kind == 3) s.sphere(at, z);
        if (c.kind == 4) s.cone(at - tilt * (10 * z), tilt, 20 * z, z, z);
        s.end_part();
        const auto in = s.input();
        const auto b8 = bvh::build8(in[0]), compact = bvh::build_compact(in[0]);
        const auto t8 = kernels::tables(s, b8), compact_tables = kernels::tables(s, compact);
        bvh_scenes::Random r(41);
        int met = 0, again = 0;
        for (int i = 0; i < 40000; i++) {
            const Vec o = at + r.direction() * (z * std::pow(10, r.in(-2, 2)));
            const Vec goal = at + r.direction() * (z * r.in(0, 0.8));
            const Vec d = unit(goal - o);
            kernels::Ray ray = {F3(float(o.x), float(o.y), float(o.z)), 0, F3(float(d.x), float(d.y), float(d.z)),
                                1e30f};
            kernels::Hit hit;
            kernels::wide::trace_first(&t8, &ray, RAY_ALL, &hit);
            if (hit.prim == NO_HIT) continue;
            met++;
            const float3 p = kernels::madd3(ray.dir, hit.t, ray.org);
            Vec n = tilt;
            const Vec q = Vec{p.x, p.y, p.z} - at;
            if (c.kind == 3) n = unit(q);
            if (c.kind == 4) n = unit(q - tilt * dot(q, tilt));
            const bool inside = dot(n, d) > 0;
            if (inside) n = n * -1;
            const Vec out = unit(n + r.direction() * 0.9999);
            ray.org = kernels::offset_ray(p, F3(float(n.x), float(n.y), float(n.z)),
                                          c.kind <= 2 ? std::max(hit.t, float(2.8 * z)) : hit.t);
            ray.dir = F3(float(out.x), float(out.y), float(out.z));
            kernels::Hit h8, compact_hit;
            kernels::wide::trace_first(&t8, &ray, RAY_ALL, &h8);
            kernels::compact::trace_first(&compact_tables, &ray, RAY_ALL, &compact_hit);
            CHECK(h8.t == compact_hit.t);
            if (h8.prim == NO_HIT) continue;
            const double chord = c.kind >= 3 && inside ? 2 * z * dot(n, out) : 1e30;
            again += h8.t < 0.5 * chord;
        }
        CAPTURE(c.name);
        CAPTURE(c.size);
        CHECK(met > 5000);
        CHECK(again == 0);
    }
}
