// SPDX-License-Identifier: BSD-3-Clause
// Traversal in host C++ against a search through all primitives: the same hit, bit for bit, for both kinds of tree.
// Compiled twice: for any processor and for AVX2 (other lane masks); the latter skips (77) where there is none.
#include "unit/avx2_main.h"
#include <string>
#include "base/error.h"
#include "unit/bvh_host.h"
#include "unit/embree_scene.h"

using bvh_scenes::Vec;
using kernels::F3;

static bool same(const kernels::Hit& a, const kernels::Hit& b) {
    return a.prim == b.prim && a.inst == b.inst && (a.prim == NO_HIT || a.t == b.t);
}

TEST_CASE("both trees find what a search through all primitives finds") {
    for (bool instances : {false, true}) {
        for (int count : {0, 1, 5, 300}) {
            const auto scene = bvh_scenes::random_scene(17 + count, count, instances);
            const auto in = scene.input();
            const auto b8 = bvh::build8(in.data(), in.size()), compact = bvh::build_compact(in.data(), in.size());
            const auto t8 = kernels::tables(scene, b8), compact_tables = kernels::tables(scene, compact);
            int hits = 0, wrong8 = 0, wrong_compact = 0, any8 = 0, any_compact = 0, within = 0;
            for (const auto& r : bvh_scenes::random_rays(5, 6000)) {
                const kernels::Ray ray = kernels::ray_of(r);
                for (uint mask : {RAY_OPAQUE, RAY_TRANSPARENT, RAY_ALL}) {
                    const kernels::Hit want = kernels::brute(scene, ray, mask);
                    kernels::Hit h8, compact_hit;
                    kernels::wide::trace_first(&t8, &ray, mask, &h8);
                    kernels::compact::trace_first(&compact_tables, &ray, mask, &compact_hit);
                    const int met = want.prim != NO_HIT;
                    hits += met;
                    within += want.inst != NO_HIT;
                    wrong8 += !same(h8, want);
                    wrong_compact += !same(compact_hit, want);
                    any8 += kernels::wide::trace_any(&t8, &ray, mask) != met;
                    any_compact += kernels::compact::trace_any(&compact_tables, &ray, mask) != met;
                }
            }
            CAPTURE(instances);
            CAPTURE(count);
            CHECK(hits > (count == 0 ? 50 : 200));
            CHECK((within > 0) == instances);
            CHECK(wrong8 == 0);
            CHECK(wrong_compact == 0);
            CHECK(any8 == 0);
            CHECK(any_compact == 0);
        }
    }
}

// Stars of 3 to 40 corners; points at random, at corners, on edges and a hair beside them, which the margin decides.
TEST_CASE("a polygon's edges by eight say what they say one by one") {
    bvh_scenes::Random random(41);
    int inside = 0, wrong = 0, points = 0;
    const float eps = 1e-6f;
    for (uint count = 3; count <= 40; count++) {
        std::vector<float> rows(2 * POLYGON_ROW(count), NAN);
        float *us = rows.data(), *vs = us + POLYGON_ROW(count);
        for (uint i = 1; i <= count; i++) {
            const double angle = 6.283185307179586 * i / count, r = random.in(.2, 3);
            us[i] = float(r * std::cos(angle)), vs[i] = float(r * std::sin(angle));
        }
        us[0] = us[count], vs[0] = vs[count];
        for (int n = 0; n < 3000; n++) {
            const uint edge = uint(random.in(0, count));
            const float along = n % 3 == 0 ? 0.0f : float(random.in(-.1, 1.1)), beside = 3e-6f;
            float u = us[edge] + along * (us[edge + 1] - us[edge]) + float(random.in(-beside, beside));
            float v = vs[edge] + along * (vs[edge + 1] - vs[edge]) + float(random.in(-beside, beside));
            if (n % 3 == 2) u = float(random.in(-3, 3)), v = float(random.in(-3, 3));
            const int want = kernels::polygon_inside(us, count, u, v, eps);
            wrong += kernels::polygon_inside8(us, count, u, v, eps) != want;
            inside += want;
            points++;
        }
    }
    CHECK(wrong == 0);
    CHECK(inside > points / 4);
    CHECK(inside < 3 * points / 4);
}

// Faces in one place and things one behind the other come one by one, each once.
TEST_CASE("hits after a given one come in their order") {
    for (bool instances : {false, true}) {
        const auto scene = bvh_scenes::random_scene(41, 200, instances);
        const auto in = scene.input();
        const auto b8 = bvh::build8(in.data(), in.size()), compact = bvh::build_compact(in.data(), in.size());
        const auto t8 = kernels::tables(scene, b8), compact_tables = kernels::tables(scene, compact);
        int hits = 0, ties = 0, near = 0, wrong = 0;
        for (const auto& r : bvh_scenes::random_rays(43, 8000)) {
            const kernels::Ray ray = kernels::ray_of(r);
            kernels::Look want, wide, narrow;
            kernels::look_along(&ray, &want);
            wide = narrow = want;
            for (int k = 0; k < 20; k++) {
                const float before = want.after;
                kernels::brute_next(scene, ray, RAY_ALL, &want);
                kernels::wide::trace_next(&t8, &ray, RAY_ALL, &wide);
                kernels::compact::trace_next(&compact_tables, &ray, RAY_ALL, &narrow);
                wrong += !same(wide.hit, want.hit) || !same(narrow.hit, want.hit);
                if (want.hit.prim == NO_HIT) break;
                for (const kernels::Look& look : {wide, narrow})
                    wrong += may_coincide(&look) != may_coincide(&want) ||
                             (may_coincide(&look) && look.second != want.second);
                near += may_coincide(&want);
                hits++;
                ties += k > 0 && want.hit.t == before;
                for (kernels::Look* look : {&want, &wide, &narrow}) kernels::look_past(look, ray.tmax);
            }
        }
        CAPTURE(instances);
        CHECK(hits > 2000);
        CHECK(ties > 50);
        CHECK(near > ties);
        CHECK(wrong == 0);
    }
}

// The plane's distance from double coordinates.  Rays begin beside the long edges of thin slats that lie askew, as
// those that leave a slat's neighbouring face do: what lies behind them must not seem to lie before them
// (offset_ray.h).
TEST_CASE("the distance to a triangle is its plane's, however thin it is") {
    bvh_scenes::Random random(47);
    for (double thin : {1e-1, 1e-3, 1e-5}) {
        int hits = 0, wrong = 0;
        for (int k = 0; k < 200; k++) {
            const Vec along = random.direction() * 3, across = unit(cross(along, random.direction())) * (3 * thin);
            const Vec corner = random.point(2), a = corner, b = corner + along, c = corner + along + across;
            const kernels::float3 p[3] = {F3(float(a.x), float(a.y), float(a.z)),
                                          F3(float(b.x), float(b.y), float(b.z)),
                                          F3(float(c.x), float(c.y), float(c.z))};
            const Vec v[3] = {{p[0].x, p[0].y, p[0].z}, {p[1].x, p[1].y, p[1].z}, {p[2].x, p[2].y, p[2].z}};
            const Vec normal = unit(cross(v[1] - v[0], v[2] - v[1]));
            for (int i = 0; i < 200; i++) {
                const Vec beside = random.direction() * (3 * thin * random.in(0, 1));
                const Vec o = v[0] + (v[1] - v[0]) * random.in(0, 1) + beside, d = random.direction();
                const kernels::Ray ray = {F3(float(o.x), float(o.y), float(o.z)), 0,
                                          F3(float(d.x), float(d.y), float(d.z)), 1e30f};
                kernels::WoopRay r;
                kernels::woop_prepare(ray.org, ray.dir, &r);
                float t, u, w;
                if (!kernels::woop_triangle(&r, p[0], p[1], p[2], &t, &u, &w)) continue;
                hits++;
                const Vec from = {ray.org.x, ray.org.y, ray.org.z}, dir = {ray.dir.x, ray.dir.y, ray.dir.z};
                const double off = dot(v[2] - from - dir * t, normal);  // the hit, from the plane; SURFACE_ROUNDING
                wrong += !(std::fabs(off) <= 3 * 5.9604645e-7);
            }
        }
        CAPTURE(thin);
        CHECK(hits > 1000);
        CHECK(wrong == 0);
    }
}

TEST_CASE("rays in packets find what they find alone") {
    using namespace kernels::wide;
    for (bool instances : {false, true}) {
        const auto scene = bvh_scenes::random_scene(29, 300, instances);
        const auto in = scene.input();
        const auto bvh = bvh::build8(in.data(), in.size());
        const auto tables = kernels::tables(scene, bvh);
        bvh_scenes::Random random(31);
        int hits = 0, wrong = 0, wrong_look = 0, kinds = 0, through = 0;
        double spread = .1;
        for (const auto& first : bvh_scenes::random_rays(37, 500)) {
            spread = 1.1 - spread;  // wide ones are given up for single rays
            for (uint mask : {RAY_OPAQUE, RAY_ALL, RAY_TRANSPARENT}) {
                Packet near = {};
                PacketRays look = {}, alone = {};
                kernels::Ray rays[PACKET];
                near.tmin = look.tmin = alone.tmin = first.tmin;
                near.count = look.count = alone.count = 27;
                for (uint i = 0; i < near.count; i++) {
                    rays[i] = kernels::ray_of(first);
                    const Vec o = random.point(0.05), d = random.point(spread);
                    rays[i].org = kernels::add3(rays[i].org, F3(float(o.x), float(o.y), float(o.z)));
                    rays[i].dir = kernels::add3(rays[i].dir, F3(float(d.x), float(d.y), float(d.z)));
                    for (PacketRays* p : {static_cast<PacketRays*>(&near), &look, &alone}) packet_put(*p, i, rays[i]);
                }
                uint panes, panes_alone = 0;
                packet_trace(tables, near, mask);
                const uint open = packet_look(tables, look, packet_all(look), mask, &panes);
                alone.open = packet_all(alone);
                look_alone(tables, alone, mask, &panes_alone);
                kinds += near.open != packet_all(near);
                wrong_look += open != alone.open || panes != panes_alone;
                for (uint i = 0; i < near.count; i++) {
                    kernels::Hit want;
                    trace_first(&tables, &rays[i], mask, &want);
                    hits += want.prim != NO_HIT;
                    wrong +=
                        !same(near.look[i].hit, want) || near.look[i].hit.u != want.u || near.look[i].hit.v != want.v;
                    if (mask != RAY_TRANSPARENT) wrong_look += ((open & ~panes) >> i & 1u) != (want.prim == NO_HIT);
                    through += panes >> i & 1u;
                }
            }
        }
        CAPTURE(instances);
        CHECK(hits > 4000);
        CHECK(kinds > 100);
        CHECK(through > 100);
        CHECK(wrong == 0);
        CHECK(wrong_look == 0);
    }
}

// Embree decides ties its own way and rounds differently: distances agree, and primitives where nothing else is as
// near.
TEST_CASE("Embree's own traversal finds the same") {
    for (bool instances : {false, true}) {
        const auto scene = bvh_scenes::random_scene(23, 200, instances);
        const auto in = scene.input();
        const auto bvh = bvh::build8(in.data(), in.size());
        const auto tables = kernels::tables(scene, bvh);
        const bvh::EmbreeScene embree(in.data(), in.size());
        int hits = 0, other_t = 0, other_prim = 0, other_any = 0;
        for (const auto& r : bvh_scenes::random_rays(9, 20000)) {
            const kernels::Ray ray = kernels::ray_of(r);
            for (uint mask : {RAY_OPAQUE, RAY_TRANSPARENT, RAY_ALL}) {
                kernels::Hit mine;
                kernels::wide::trace_first(&tables, &ray, mask, &mine);
                const auto theirs = embree.closest(r.org, r.tmin, r.dir, r.tmax, mask);
                hits += mine.prim != NO_HIT;
                const bool near = (mine.prim == NO_HIT) == (theirs.prim == NO_HIT) &&
                                  (mine.prim == NO_HIT || std::fabs(mine.t - theirs.t) < 1e-5f * (1 + mine.t));
                other_t += !near;
                const auto one = [](uint prim) { return prim == 201 ? 200 : prim; };  // the two coincident faces
                other_prim += near && (one(mine.prim) != one(theirs.prim) || mine.inst != theirs.inst);
                other_any += embree.any(r.org, r.tmin, r.dir, r.tmax, mask) != (mine.prim != NO_HIT);
            }
        }
        CAPTURE(instances);
        CHECK(hits > 4000);
        CHECK(other_t <= hits / 5000);  // rays within an ulp of an edge
        CHECK(other_any <= hits / 5000);
        CHECK(other_prim <= hits / 5000);
    }
}

TEST_CASE("a ray that is not of numbers meets nothing, in Embree too") {
    const auto scene = bvh_scenes::random_scene(23, 200, false);
    const auto in = scene.input();
    const auto bvh = bvh::build8(in.data(), in.size());
    const auto tables = kernels::tables(scene, bvh);
    const bvh::EmbreeScene embree(in.data(), in.size());
    for (const float spoiled : {NAN, INFINITY, -INFINITY, 3e38f})
        for (int place = 0; place < 6; place++) {
            bvh_scenes::Ray row = bvh_scenes::random_rays(9, 1)[0];
            (place < 3 ? row.org : row.dir)[place % 3] = spoiled;
            const kernels::Ray ray = kernels::ray_of(row);
            kernels::Hit mine;
            kernels::wide::trace_first(&tables, &ray, RAY_ALL, &mine);
            CAPTURE(spoiled);
            CAPTURE(place);
            CHECK(mine.prim == NO_HIT);
            CHECK(embree.closest(row.org, row.tmin, row.dir, row.tmax, RAY_ALL).prim == NO_HIT);
            CHECK(!embree.any(row.org, row.tmin, row.dir, row.tmax, RAY_ALL));
        }
}

TEST_CASE("an empty scene has no hits") {
    bvh_scenes::Scene scene;
    scene.end_part();
    const auto in = scene.input();
    const auto b8 = bvh::build8(in[0]), compact = bvh::build_compact(in[0]);
    const auto t8 = kernels::tables(scene, b8), compact_tables = kernels::tables(scene, compact);
    for (const auto& r : bvh_scenes::random_rays(5, 100)) {
        const kernels::Ray ray = kernels::ray_of(r);
        kernels::Hit hit;
        kernels::wide::trace_first(&t8, &ray, RAY_ALL, &hit);
        CHECK(hit.prim == NO_HIT);
        kernels::compact::trace_first(&compact_tables, &ray, RAY_ALL, &hit);
        CHECK(hit.prim == NO_HIT);
        CHECK(kernels::wide::trace_any(&t8, &ray, RAY_ALL) == 0);
        CHECK(kernels::compact::trace_any(&compact_tables, &ray, RAY_ALL) == 0);
    }
}

TEST_CASE("a coordinate that is not a number is refused") {
    bvh_scenes::Scene scene;
    scene.triangle({0, 0, 0}, {1, 0, 0}, {0, NAN, 0});
    scene.end_part();
    CHECK_THROWS_AS(bvh::build8(scene.input()[0]), base::Error);
}

// What makes builders split badly: everything in one place, sizes over many orders of magnitude, with and without
// instances.
TEST_CASE("crowded and lopsided scenes fit the stacks") {
    for (int kind = 0; kind < 3; kind++) {
        bvh_scenes::Scene s;
        const double rows[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        if (kind == 2) {
            for (int i = 0; i < 5000; i++) s.instance(1, rows, 1, {0, 0, 0});
            s.end_part();
        }
        for (int i = 0; i < 20000; i++) {
            const double x = std::pow(1.003, i % 10000) * 1e-6;
            if (kind == 0) s.triangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
            else s.triangle({x, 0, 0}, {x, x, 0}, {x, 0, x});
        }
        s.end_part();
        const auto in = s.input();
        const auto b8 = bvh::build8(in.data(), in.size()), compact = bvh::build_compact(in.data(), in.size());
        const auto t8 = kernels::tables(s, b8), compact_tables = kernels::tables(s, compact);
        CAPTURE(kind);
        for (int back : {1, -1}) {  // from either end, through everything
            const kernels::Ray ray = {F3(back > 0 ? -1.0f : 2e7f, 1e-8f, 1e-8f), 0, F3(float(back), 0, 0), 1e30f};
            const kernels::Hit want = kind == 2 ? kernels::Hit() : kernels::brute(s, ray, RAY_ALL);
            kernels::Hit h8, compact_hit;
            kernels::wide::trace_first(&t8, &ray, RAY_ALL, &h8);
            kernels::compact::trace_first(&compact_tables, &ray, RAY_ALL, &compact_hit);
            CHECK(h8.prim != NO_HIT);
            CHECK(same(h8, compact_hit));
            if (kind != 2) CHECK(same(h8, want));
        }
    }
}

// Shapes against their closed forms, seen from near and far.
TEST_CASE("distances to analytic shapes") {
    bvh_scenes::Scene s;
    s.sphere({0, 0, 0}, 0.5);
    s.cone({3, 0, 0}, {0, 0, 1}, 2, 0.5, 0.5);
    s.cone({6, 0, 0}, {0, 0, 1}, 1, 1, 0);
    s.ring({9, 0, 1}, {0, 0, 1}, 0.25, 1);
    s.polygon({{11, -1, 1}, {13, -1, 1}, {13, 1, 1}, {11, 1, 1}});
    s.end_part();
    const auto in = s.input();
    const auto bvh = bvh::build8(in[0]);
    const auto tables = kernels::tables(s, bvh);
    const auto first = [&](double x, double y, double z, double dx, double dy, double dz) {
        const kernels::Ray ray = {F3(float(x), float(y), float(z)), 0, F3(float(dx), float(dy), float(dz)), 1e30f};
        kernels::Hit hit;
        kernels::wide::trace_first(&tables, &ray, RAY_ALL, &hit);
        return hit.prim == NO_HIT ? -1.0 : double(hit.t);
    };
    for (double far : {2.0, 1000.0, 100000.0}) {
        CAPTURE(far);
        CHECK(first(0, -far, 0, 0, 1, 0) == doctest::Approx(far - 0.5).epsilon(1e-6));
        CHECK(first(0, -far, 0.3, 0, 1, 0) == doctest::Approx(far - 0.4).epsilon(1e-6));
        CHECK(first(0, -far, 0.51, 0, 1, 0) == -1);
        CHECK(first(3.3, -far, 1, 0, 1, 0) == doctest::Approx(far - 0.4).epsilon(1e-6));
        CHECK(first(3.3, -far, 2.01, 0, 1, 0) == -1);
        CHECK(first(6, -far, 0.5, 0, 1, 0) == doctest::Approx(far - 0.5).epsilon(1e-6));
        CHECK(first(6.25, 0, far, 0, 0, -1) == doctest::Approx(far - 0.75).epsilon(1e-6));
        CHECK(first(9.5, 0, far, 0, 0, -1) == doctest::Approx(far - 1).epsilon(1e-6));
        CHECK(first(9.1, 0, far, 0, 0, -1) == -1);
        CHECK(first(12, 0.5, -far, 0, 0, 1) == doctest::Approx(far + 1).epsilon(1e-6));
    }
    CHECK(first(0, 0, 0, 1, 0, 0) == doctest::Approx(0.5));  // from inside
    CHECK(first(3, 0, 1, 0, 0.6, 0.8) == doctest::Approx(0.5 / 0.6));
    CHECK(first(3, 0, 1, 0, 0, 1) == -1);     // open ends
    CHECK(first(9.25, 0, 2, 0, 0, -1) == 1);  // edges belong to the shape
    CHECK(first(10, 0, 2, 0, 0, -1) == 1);
    CHECK(first(11, -1, 2, 0, 0, -1) == 1);
    CHECK(first(13, 1, 2, 0, 0, -1) == 1);
    CHECK(first(8, 0, 1, 1, 0, 0) == -1);  // in the plane of ring and polygon
}
