// SPDX-License-Identifier: BSD-3-Clause
// Regions as a scene shows them, with a scene simple enough to have closed forms: rectangles that face the eye, which
// sits at the origin and looks along y.  Solid angle of a face-on rectangle by its corners: sums of atan(x z / (d r)).
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <vector>
#include "base/error.h"
#include "region/region.h"

using namespace base;

namespace {

struct Panel {
    const char *name, *modifier;
    double x0, x1, z0, z1, y;
    bool through;
};
class Panels : public region::SceneView {
public:
    explicit Panels(std::vector<Panel> p) : p_(std::move(p)) {
        std::sort(p_.begin(), p_.end(), [](const Panel& a, const Panel& b) { return a.y < b.y; });
    }
    unsigned surfaces() const override { return unsigned(p_.size()); }
    std::string surface_name(unsigned s) const override { return p_[s].name; }
    std::vector<std::string> modifier_names(unsigned s) const override { return {p_[s].modifier, "base"}; }
    int look(Vec3 o, Vec3 d, double tmax, region::Crossing* out, int room, bool& closed) const override {
        int n = 0;
        closed = false;
        for (unsigned s = 0; s < p_.size() && !closed && n < room; ++s) {
            double t = (p_[s].y - o.y) / d.y, x = o.x + t * d.x, z = o.z + t * d.z;
            if (t <= 0 || (tmax > 0 && t >= tmax) || x < p_[s].x0 || x > p_[s].x1 || z < p_[s].z0 || z > p_[s].z1)
                continue;
            out[n++] = {t, s};
            closed = !p_[s].through;
        }
        return n;
    }

private:
    std::vector<Panel> p_;
};

double corner(double x, double z, double y) { return std::atan(x * z / (y * std::sqrt(x * x + y * y + z * z))); }
double omega(double x0, double x1, double z0, double z1, double y) {
    return corner(x1, z1, y) - corner(x0, z1, y) - corner(x1, z0, y) + corner(x0, z0, y);
}

// A wall with a post before its middle, a pane of glass before its right half, and a wire.
const Panels ROOM({{"wall", "paint", -3, 3, -2, 2, 4, false},
                   {"post.left", "steel", -.21, 0, -2, 2, 2, false},
                   {"post.right", "steel", 0, .21, -2, 2, 2, false},
                   {"pane", "glass", .5, 2, -1, 1, 3, true},
                   {"wire", "steel", -2, 2, .703, .706, 3.5, false}});

view::View look_along_y() {
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 150;
    return v;
}
region::Extent measured(const std::string& line, int n = 400) {
    view::View v = look_along_y();
    return region::measure(region::rasterize(region::parse("r " + line, "test"), v, n, n, false, &ROOM), v)[0];
}

}  // namespace

TEST_CASE("a surface is where it is seen, through glass too") {
    const double post = omega(-.21, .21, -1, 1, 2);  // hides the wall from z -2 to 2 at twice the distance
    double wire = omega(-2, 2, .703, .706, 3.5) - omega(-.21, .21, .4017142857, .4034285714, 2);
    CHECK(measured("surface wall").omega_sr == doctest::Approx(omega(-3, 3, -2, 2, 4) - post - wire).epsilon(3e-4));
    CHECK(measured("surface pane").omega_sr == doctest::Approx(omega(.5, 2, -1, 1, 3)).epsilon(3e-4));
    CHECK(measured("surface post.*").omega_sr == doctest::Approx(omega(-.21, .21, -2, 2, 2)).epsilon(3e-4));
    CHECK(measured("modifier base & surface pane").omega_sr == doctest::Approx(omega(.5, 2, -1, 1, 3)).epsilon(3e-4));
}

TEST_CASE("a wire of a twentieth of a pixel is followed along its length") {
    // 0.003 at 3.5 is 0.05 degrees; a pixel is 0.375 degrees.  Grid points find a tenth of it at most times: what
    // counts is that no stretch between the found pixels is dropped, so the sum is right within the points' own
    // spacing.
    double expected = omega(-2, 2, .703, .706, 3.5) - omega(-.21, .21, .4017142857, .4034285714, 2);
    CHECK(measured("surface wire", 1000).omega_sr == doctest::Approx(expected).epsilon(.15));
}

TEST_CASE("a region in space is hidden by what stands before it, not by glass, and lies on a surface") {
    const std::string on_wall = "polygon3d -1 4 -1  1.5 4 -1  1.5 4 1  -1 4 1";
    double whole = omega(-1, 1.5, -1, 1, 4), post = omega(-.21, .21, -.5, .5, 2);
    double wire = omega(-1 * 3.5 / 4, 1.5 * 3.5 / 4, .703, .706, 3.5) - omega(-.21, .21, .4017142857, .4034285714, 2);
    CHECK(measured(on_wall).omega_sr == doctest::Approx(whole - post - wire).epsilon(1e-3));
    CHECK(measured(on_wall + " & surface wall").omega_sr == doctest::Approx(whole - post - wire).epsilon(1e-3));
    // Before the post nothing hides it; behind the wall everything does.
    CHECK(measured("polygon3d -.5 1 -.5  .5 1 -.5  .5 1 .5  -.5 1 .5").omega_sr ==
          doctest::Approx(omega(-.5, .5, -.5, .5, 1)).epsilon(3e-4));
    CHECK(measured("box3d -1 4.5 -1  1 5 1").pixels == 0);
    // A ball that stands half in front of the post's plane is seen by its front.
    double ball = 2 * M_PI * (1 - std::sqrt(1 - .25 / 4));
    CHECK(measured("sphere3d 0 2 0 .5").omega_sr == doctest::Approx(ball).epsilon(1e-3));
}

TEST_CASE("within takes the points inside a volume") {
    CHECK(measured("surface wall within box3d -2 3.9 -1  -1 4.1 .5").omega_sr ==
          doctest::Approx(omega(-2, -1, -1, .5, 4)).epsilon(1e-3));
    double disc =
        2 * M_PI *
        (1 - 3 / std::sqrt(9.09));  // a ball of radius .3 around a point of the pane, off the axis: compare with a disc
    double got = measured("modifier glass within sphere3d 1.2 3 0 .3").omega_sr;
    CHECK(got < disc);
    CHECK(got == doctest::Approx(measured("disc3d 1.2 3 0 0 1 0 .3").omega_sr).epsilon(1e-3));
}

TEST_CASE("with -centre each pixel is what its centre's ray says") {
    view::View v = look_along_y();
    const int n = 150;
    auto r = region::parse(
        "a surface post.*\nb polygon3d -1 4 -1  1.5 4 -1  1.5 4 1  -1 4 1\nc b - surface pane within box3d 0 0 0 1 9 "
        "9\n",
        "test");
    auto set = region::rasterize(r, v, n, n, true, &ROOM);
    view::Projector p(v);
    int wrong = 0;
    for (int i = 0; i < n * n; ++i) {
        auto ray = p.ray((i % n + .5) / n, (n - 1 - i / n + .5) / n);
        bool in[3] = {};
        if (ray) {
            region::Crossing c[8];
            bool closed;
            int k = ROOM.look(ray->origin, ray->dir, 0, c, 8, closed);
            bool pane = false;
            for (int m = 0; m < k; ++m) {
                std::string name = ROOM.surface_name(c[m].surface);
                Vec3 q = ray->dir * c[m].t;
                in[0] = in[0] || name.find("post") == 0;
                in[1] = in[1] || (name == "wall" && q.x >= -1 && q.x <= 1.5 && std::fabs(q.z) <= 1);
                pane = pane || (name == "pane" && q.x >= -1e-6 && q.x <= 1 + 1e-6 && q.z >= -1e-6);
            }
            in[2] = in[1] && !pane;
        }
        for (int m = 0; m < 3; ++m) wrong += in[m] != (set.masks[size_t(m)].coverage[size_t(i)] > 0);
    }
    CHECK(wrong == 0);
}

TEST_CASE("coverage on the edge of a post is right to 1/64") {
    view::View v = look_along_y();
    const int n = 90;
    auto plane =
        region::rasterize(region::parse("a surface post.left\n", "test"), v, n, n, false, &ROOM).masks[0].coverage;
    view::Projector p(v);
    double worst = 0;
    int tested = 0;
    for (int i = 0; i < n * n; i += 1) {
        if (plane[size_t(i)] <= 0 || plane[size_t(i)] >= 1 || ++tested > 60) continue;
        int in = 0;
        const int side = 64;
        for (int s = 0; s < side * side; ++s) {
            auto ray = p.ray((i % n + (s % side + .5) / side) / n, (n - 1 - i / n + (s / side + .5) / side) / n);
            region::Crossing c[8];
            bool closed;
            if (ray && ROOM.look(ray->origin, ray->dir, 0, c, 8, closed))
                in += ROOM.surface_name(c[0].surface) == "post.left";
        }
        worst = std::max(worst, std::fabs(double(in) / (side * side) - plane[size_t(i)]));
    }
    CHECK(tested > 50);
    CHECK(worst < 1.0 / 64);
}

TEST_CASE("names that the scene does not have come with those it has") {
    view::View v;
    auto fails = [&](const std::string& text) {
        region::rasterize(region::parse(text, "test"), v, 20, 20, false, &ROOM);
    };
    CHECK_THROWS_WITH(fails("\na surface wal"),
                      doctest::Contains("test:2: no surface of the scene is called \"wal\" (did you mean \"wall\"?)"));
    CHECK_THROWS_WITH(fails("a modifier glas"), doctest::Contains("\"glass\""));
}

TEST_CASE("the same bytes on every run") {
    view::View v = look_along_y();
    auto r = region::parse("a surface wire\nb modifier steel & circle view 40\nc sphere3d 0 2 0 .5\n", "test");
    auto one = region::rasterize(r, v, 200, 200, false, &ROOM), two = region::rasterize(r, v, 200, 200, false, &ROOM);
    for (size_t m = 0; m < 3; ++m) CHECK(one.masks[m].coverage == two.masks[m].coverage);
}
