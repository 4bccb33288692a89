// SPDX-License-Identifier: BSD-3-Clause
// Solid angles of regions against closed forms, 512 pixels, every projection: sum of coverage * pixel solid angle.
//   disc of radius r at distance D, face on:  2 pi (1 - D / sqrt(D^2 + r^2))
//   rectangle 2a x 2b at distance D, face on: 4 atan(a b / (D sqrt(a^2 + b^2 + D^2)))
//   spherical polygon:                        sum of its angles - (n - 2) pi  (Girard)
// A parallel view has no solid angles; there the areas in world units are compared.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cmath>
#include <fmt/format.h>
#include "region/region.h"

using namespace base;

namespace {

view::View make_view(char type, double size) {
    view::View v;
    v.type = type;
    v.vp = {1, 2, 3};
    v.vd = {0.3, 1, -0.2};
    v.vh = v.vv = size;
    return v;
}
const struct {
    char type;
    double size;
} VIEWS[] = {{'v', 90}, {'a', 180}, {'h', 170}, {'s', 150}, {'c', 120}, {'a', 300}};

// Frame of the view: where the tests put their shapes.
struct Axes {
    Vec3 d, h, u, eye;
    explicit Axes(const view::View& v) : d(unit(v.vd)), h(unit(cross(d, v.vu))), u(cross(h, d)), eye(v.vp) {}
    Vec3 direction(double x, double y) const { return unit(d + x * h + y * u); }
};

std::string text(Vec3 v) { return fmt::format(" {:.17g} {:.17g} {:.17g}", v.x, v.y, v.z); }

region::Extent measured(const std::string& line, const view::View& v, int n = 512) {
    auto set = region::rasterize(region::parse("r " + line, "test"), v, n, n, false);
    return region::measure(set, v)[0];
}

// Girard's excess; corners counterclockwise seen from the eye or not, convex or not.
double excess(const std::vector<Vec3>& c) {
    double sum = 0;
    size_t n = c.size();
    for (size_t i = 0; i < n; ++i) {
        Vec3 b = c[i], a = c[(i + n - 1) % n], e = c[(i + 1) % n];
        Vec3 to_a = unit(a - b * dot(a, b)), to_e = unit(e - b * dot(e, b));
        double angle = std::atan2(dot(b, cross(to_e, to_a)), dot(to_e, to_a));
        sum += angle < 0 ? angle + 2 * M_PI : angle;
    }
    double area = sum - (double(n) - 2) * M_PI;
    return std::min(area, 4 * M_PI - area);
}

}  // namespace

TEST_CASE("discs in space, face on and off the axis") {
    for (auto w : VIEWS) {
        view::View v = make_view(w.type, w.size);
        Axes at(v);
        for (double radius : {0.15, 0.4, 0.7})
            for (auto where : {at.direction(0, 0), at.direction(-.2, .15)}) {
                Vec3 centre = at.eye + 2.0 * where;
                double expected = 2 * M_PI * (1 - 2 / std::sqrt(4 + radius * radius));
                double got = measured("disc3d" + text(centre) + text(where) + fmt::format(" {}", radius), v).omega_sr;
                CAPTURE(w.type);
                CAPTURE(radius);
                CHECK(std::fabs(got / expected - 1) < 1e-4);
            }
    }
}

TEST_CASE("discs seen at a slant are the limit of their inscribed polygons") {
    for (auto w : VIEWS) {
        view::View v = make_view(w.type, w.size);
        Axes at(v);
        Vec3 centre = at.eye + 2.0 * at.direction(.1, -.1), normal = unit(at.d + 1.5 * at.h),
             e1 = unit(cross(normal, at.u)), e2 = cross(normal, e1);
        const double radius = .5;
        std::vector<Vec3> rim;
        for (int i = 0; i < 20000; ++i) {
            double phi = 2 * M_PI * i / 20000;
            rim.push_back(unit(centre + radius * (std::cos(phi) * e1 + std::sin(phi) * e2) - at.eye));
        }
        // The excess of so many corners loses digits: fan of triangles (Van Oosterom and Strackee 1983) instead.
        double expected = 0;
        Vec3 c = unit(centre - at.eye);
        for (size_t i = 0; i < rim.size(); ++i) {
            Vec3 a = rim[i], b = rim[(i + 1) % rim.size()];
            expected += 2 * std::atan2(dot(c, cross(a, b)), 1 + dot(a, b) + dot(b, c) + dot(c, a));
        }
        double got = measured("disc3d" + text(centre) + text(normal) + fmt::format(" {}", radius), v).omega_sr;
        CAPTURE(w.type);
        CHECK(std::fabs(got / std::fabs(expected) - 1) < 1e-4);
    }
}

TEST_CASE("rectangles in space") {
    for (auto w : VIEWS) {
        view::View v = make_view(w.type, w.size);
        Axes at(v);
        for (double a : {.1, .5, .9}) {
            double b = .6 * a, D = 1.5;
            Vec3 c = at.eye + D * at.d;
            std::string line = "polygon3d" + text(c - a * at.h - b * at.u) + text(c + a * at.h - b * at.u) +
                               text(c + a * at.h + b * at.u) + text(c - a * at.h + b * at.u);
            double expected = 4 * std::atan(a * b / (D * std::sqrt(a * a + b * b + D * D)));
            CAPTURE(w.type);
            CAPTURE(a);
            CHECK(std::fabs(measured(line, v).omega_sr / expected - 1) < 1e-4);
        }
    }
}

TEST_CASE("spherical polygons, convex and not, and the same as polygons in space") {
    for (auto w : VIEWS) {
        view::View v = make_view(w.type, w.size);
        Axes at(v);
        const double star[][2] = {{-.4, -.3}, {.1, -.35}, {.35, .2}, {.05, -.05}, {-.15, .45}};
        std::vector<Vec3> corners;
        std::string dirs = "polygon direction", points = "polygon3d";
        for (auto& s : star) {
            corners.push_back(at.direction(s[0], s[1]));
            dirs += text(corners.back());
            points += text(at.eye + 3.0 * (at.d + s[0] * at.h + s[1] * at.u));
        }
        double expected = excess(corners);
        CAPTURE(w.type);
        CHECK(std::fabs(measured(dirs, v).omega_sr / expected - 1) < 1e-4);
        CHECK(std::fabs(measured(points, v).omega_sr / expected - 1) < 1e-4);
    }
}

TEST_CASE("circles of directions, spheres and boxes") {
    for (auto w : VIEWS) {
        view::View v = make_view(w.type, w.size);
        Axes at(v);
        CAPTURE(w.type);
        for (double full : {8.0, 25.0, 50.0}) {
            double expected = 2 * M_PI * (1 - std::cos(full / 2 * M_PI / 180));
            Vec3 axis = at.direction(.1, .05);
            CHECK(std::fabs(measured("circle" + text(axis) + fmt::format(" {}", full), v).omega_sr / expected - 1) <
                  1e-4);
            double radius = 2 * std::sin(full / 2 * M_PI / 180);
            CHECK(std::fabs(
                      measured("sphere3d" + text(at.eye + 2.0 * axis) + fmt::format(" {:.17g}", radius), v).omega_sr /
                          expected -
                      1) < 1e-4);
        }
        // A box is the union of its faces: as large as the six polygons together, seen as their outline.
        Vec3 lo = at.eye + 2.0 * at.d, hi = lo + Vec3{.7, .5, .6};
        auto corner = [&](int k) { return Vec3{k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z}; };
        const int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
        double both = 0;  // front and back faces cover the outline once each
        for (auto& f : faces) {
            std::vector<Vec3> c;
            for (int k : f) c.push_back(unit(corner(k) - at.eye));
            both += excess(c);
        }
        CHECK(std::fabs(measured("box3d" + text(lo) + text(hi), v).omega_sr / (both / 2) - 1) < 1e-4);
    }
}

TEST_CASE("a parallel view: areas") {
    view::View v = make_view('l', 4);
    Axes at(v);
    double pixel = (4.0 / 512) * (4.0 / 512);
    Vec3 c = at.eye + 5.0 * at.d + .3 * at.h;
    CHECK(measured("disc3d" + text(c) + text(at.d) + " .8", v).pixels * pixel ==
          doctest::Approx(M_PI * .64).epsilon(1e-4));
    Vec3 slant = unit(at.d + at.h);
    CHECK(measured("disc3d" + text(c) + text(slant) + " .8", v).pixels * pixel ==
          doctest::Approx(M_PI * .64 * std::sqrt(.5)).epsilon(1e-4));
    CHECK(measured("sphere3d" + text(c) + " .8", v).pixels * pixel == doctest::Approx(M_PI * .64).epsilon(1e-4));
    std::string line = "polygon3d" + text(c) + text(c + at.h) + text(c + at.h + .7 * at.u) + text(c + .7 * at.u);
    CHECK(measured(line, v).pixels * pixel == doctest::Approx(.7).epsilon(1e-4));
    CHECK_THROWS(measured("circle 0 1 0 20", v));
}
