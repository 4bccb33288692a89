// SPDX-License-Identifier: BSD-3-Clause
// Many lamps and their images in a mirror light a floor as the sum of all of them says, on every device; frames do not
// depend on each other.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/core.h>

using namespace laws;

// n x n small balls 3 above the floor, half a unit apart about the origin; a mirror stands at y = 20.  A ball of radius
// r and radiance 1000 gives a point at distance d the irradiance pi 1000 (r/d)^2 cos, its image .8 of that.
namespace {
constexpr double radius = .01, height = 3, mirror = 20, reflectance = .8;
double place(int i, int n) { return .5 * (i - .5 * (n - 1)); }

std::string lamps(int n) {
    std::string text =
        "void plastic grey 0 0 5 .5 .5 .5 0 0\ngrey polygon floor 0 0 12 -50 -50 0 50 -50 0 50 20 0 -50 20 0\n"
        "void mirror m 0 0 3 .8 .8 .8\nm polygon wall 0 0 12 -50 20 0 50 20 0 50 20 50 -50 20 50\n"
        "void light l 0 0 3 1000 1000 1000\n";
    for (int i = 0; i < n * n; i++)
        text += fmt::format("l sphere s{} 0 0 4 {} {} {} {}\n", i, place(i % n, n), place(i / n, n), height, radius);
    return text;
}

// The floor's radiance at (x, y).
double expected(int n, double x, double y) {
    const auto given = [&](double dx, double dy) {
        const double d2 = dx * dx + dy * dy + height * height;
        return pi * 1000 * radius * radius / d2 * height / std::sqrt(d2);
    };
    double sum = 0;
    for (int i = 0; i < n * n; i++) {
        const double dx = place(i % n, n) - x, ly = place(i / n, n);
        sum += given(dx, ly - y) + reflectance * given(dx, 2 * mirror - ly - y);
    }
    return .5 / pi * sum;
}

Ray down(double x, double y) { return {{x, y, 1}, {0, 0, -1}}; }
}  // namespace

TEST_CASE("many lamps light as the sum of all of them") {
    for (int n : {5, 40}) {
        CAPTURE(n);
        for (const double y : {-9., 15.}) expect(lamps(n), direct_only(), down(.2, y), {expected(n, .2, y)}, 4096);
    }
}

TEST_CASE("a frame is the same alone and after others") {
    const scene::Scene scene = scene_of(lamps(12));
    view::View view;
    view.vp = {0, -5, 2};
    view.vd = {0, 1, -.3};
    render::Renderer one(scene, view, 8, 8, {}, "cpu", {}), other(scene, view, 8, 8, {}, "cpu", {});
    std::vector<float> alone, after;
    one.frame(5, alone);
    for (int k = 0; k <= 5; k++) other.frame(k, after);
    CHECK(alone == after);
}
