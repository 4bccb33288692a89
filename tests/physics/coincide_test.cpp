// SPDX-License-Identifier: BSD-3-Clause
// Surfaces in one place, eyes on surfaces, models in other units, on every device.  Exact values: a floor of
// reflectance p under a sky of 1 looks like p, whatever lies in its plane and does not show.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "base/vec.h"
#include "unit/temp_folder.h"

using namespace laws;
using base::Vec3;

namespace {

// A place for a scene drawn about the origin: turned, then scaled, then moved.
struct Place {
    double scale = 1, tilt_deg = 0;
    Vec3 move = {0, 0, 0};
    double aside = 0;  // along x, before it is turned

    Place beside(int k) const { return {scale, tilt_deg, move, 5.0 * k}; }

    Vec3 turned(Vec3 p) const {
        const double a = tilt_deg * pi / 180, b = .7 * a;
        p = {p.x, p.y * std::cos(a) - p.z * std::sin(a), p.y * std::sin(a) + p.z * std::cos(a)};
        return {p.x * std::cos(b) + p.z * std::sin(b), p.y, p.z * std::cos(b) - p.x * std::sin(b)};
    }
    Vec3 point(Vec3 p) const { return (turned({p.x + aside, p.y, p.z}) + move) * scale; }
    std::string text(Vec3 p) const {
        p = point(p);
        return fmt::format(" {:.9g} {:.9g} {:.9g}", p.x, p.y, p.z);
    }
    // The corners of a square of half side 2 about z, which looks up or down.
    std::string square(const std::string& mod, bool up, double z = 0, double half = 2) const {
        std::string out = mod + " polygon " + mod + "_p 0 0 12";
        for (int k = 0; k < 4; k++) {
            const int i = up ? k : 3 - k;
            out += text({i == 1 || i == 2 ? half : -half, i >= 2 ? half : -half, z});
        }
        return out + "\n";
    }
    std::string ring(const std::string& mod, bool up) const {
        const Vec3 n = turned({0, 0, up ? 1.0 : -1.0});
        return fmt::format("{0} ring {0}_r 0 0 8{1} {2:.9g} {3:.9g} {4:.9g} 0 {5:.9g}\n", mod, text({.1, 0, 0}), n.x,
                           n.y, n.z, 2 * scale);
    }
    Ray ray(Vec3 from, Vec3 dir) const {
        const Vec3 o = point(from), d = turned(dir);
        return {{o.x, o.y, o.z}, {d.x, d.y, d.z}};
    }
};

const std::vector<Place> places = {
    {}, {1, 33, {3.7, -2.1, 1.3}}, {1, 20, {4321, 1234, -77}}, {.001, 57, {.3, -.7, 2.2}}, {1000, 12, {-3, 1, .4}}};

const std::string sky = "void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n";
const std::string sky_and_two =
    sky + "void plastic A 0 0 5 .5 .5 .5 0 0\nvoid plastic B 0 0 5 .2 .2 .2 0 0\nvoid glass G 0 0 3 .5 .5 .5\n";

render::RenderOptions one_bounce() {
    render::RenderOptions options;
    options.ab = 1;
    return options;
}

// Rays into one scene and what they see, on each device.
struct Seen {
    Ray ray;
    double value;
};
void expect_seen(const std::string& text, const std::vector<Seen>& seen, long samples) {
    CAPTURE(text);
    const scene::Scene scene = scene_of(sky_and_two + text);
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer renderer(scene, view::View(), 1, 1, one_bounce(), device, {});
        for (size_t i = 0; i < seen.size(); i++) {
            CAPTURE(i);
            const auto value = trace_ray(renderer, seen[i].ray.origin, seen[i].ray.dir, samples);
            CHECK(std::abs(value.mean[0] - seen[i].value) <= 4 * value.error[0] + 2e-5);
            CHECK(value.error[0] <= .1 * seen[i].value);
        }
    }
}

// Of pairs of surfaces side by side, each from three sides, one of them almost along it.
struct Pair {
    std::function<std::string(const Place&)> text;
    double value;
};
void expect_pairs(const Place& at, const std::vector<Pair>& pairs) {
    std::string text;
    std::vector<Seen> seen;
    for (size_t k = 0; k < pairs.size(); k++) {
        const Place beside = at.beside(int(k));
        text += pairs[k].text(beside);
        for (const Vec3& from : {Vec3{.13, .21, 3}, Vec3{-1.1, .4, .7}, Vec3{1.3, -1.2, .02}})
            seen.push_back({beside.ray(from, Vec3{.31, .17, 0} - from), pairs[k].value});
    }
    expect_seen(text, seen, 64);
}
#define PAIR(...) [&](const Place& p) { return std::string() + __VA_ARGS__; }

// A picture of the floor, whose rays go in packets, from -ab 1: its mean.
double picture(const std::string& text, const std::string& device, render::Sampling sampling) {
    render::RenderOptions options = one_bounce();
    options.sampling = sampling;
    view::View view;
    view.vp = {.13, .21, 3};
    view.vd = {.02, .03, -1};
    view.vu = {0, 1, 0};
    view.vh = view.vv = 12;
    render::Renderer renderer(scene_of(text), view, 16, 16, options, device, {});
    double sum = 0;
    renderer.frames(0, 9, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        for (float v : rgb) sum += k == 0 ? v : v / 8;
        return true;
    });
    return sum / (16 * 16 * 3);
}

}  // namespace

TEST_CASE("of two faces in one place the opaque one, then the one toward the ray, then the later modifier shows") {
    for (const Place& at : places) {
        CAPTURE(at.scale);
        CAPTURE(at.tilt_deg);
        expect_pairs(at, {{PAIR(p.square("A", true) + p.square("B", false)), .5},
                          {PAIR(p.square("B", false) + p.square("A", true)), .5},
                          {PAIR(p.square("A", true) + p.square("B", true)), .2},
                          {PAIR(p.square("B", true) + p.square("A", true)), .2},
                          {PAIR(p.square("A", false) + p.square("B", true)), .2},
                          {PAIR(p.square("G", true) + p.square("A", true)), .5},
                          {PAIR(p.square("A", false) + p.square("G", true)), .5},
                          {PAIR(p.ring("A", true) + p.square("B", true)), .2},
                          {PAIR(p.ring("B", false) + p.square("A", true)), .5}});
    }
}

TEST_CASE("a ground of two kilometres and a rug in its plane") {
    const Place at;
    expect_pairs(at, {{PAIR(p.square("A", true, 0, 1000) + p.square("B", true)), .2}});
    expect_pairs(at, {{PAIR(p.square("B", true, 0, 1000) + p.square("A", false)), .2}});
}

TEST_CASE("curved surfaces, meshes and instances in one place") {
    TempFolder folder;
    const std::string mesh = folder.holding("m.obj", "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nusemtl A\nf 1 2 3 4\n");
    const std::string a = folder.holding("a.rad", "void plastic I 0 0 5 .5 .5 .5 0 0\n" + Place{}.square("I", true));
    const auto placed = [](const std::string& what, const std::string& file, const std::string& turn, const Place& p) {
        const size_t words = turn.empty() ? 0 : size_t(std::count(turn.begin(), turn.end(), ' ')) + 1;
        return fmt::format("{} k {} {} {} -t{} 0 0\n", what, words + 5, file, turn, p.text({0, 0, 0}));
    };
    expect_pairs({}, {{PAIR(placed("void mesh", mesh, "", p) + p.square("B", true)), .2},
                      {PAIR(placed("void mesh", mesh, "", p) + p.square("B", false)), .5},
                      {PAIR(placed("void instance", a, "-rx 180", p) + p.square("B", true)), .2},
                      {PAIR(placed("void instance", a, "-mz", p) + p.square("B", true)), .2},
                      {PAIR(placed("void instance", a, "-mx -rz 30", p) + p.square("B", false)), .5},
                      {PAIR(placed("B instance", a, "", p) + p.square("A", true)), .2},
                      {PAIR(placed("A instance", a, "", p) + p.square("B", true)), .2},
                      {PAIR(placed("A instance", a, "", p) + placed("G instance", a, "", p)), .5},
                      {PAIR(placed("G instance", a, "", p) + p.square("A", false)), .5}});
    const Ray above{{.1, .2, 3}, {0, 0, -1}};
    expect_seen("A sphere s 0 0 4 0 0 -1 1\nB sphere t 0 0 4 0 0 -1 1\n", {{above, .2}}, 64);
    expect_seen("A tube s 0 0 7 0 -9 -1 0 9 -1 1\nB cylinder t 0 0 7 0 -9 -1 0 9 -1 1\n", {{above, .2}}, 64);
}

TEST_CASE("the same in packets, and with path reuse") {
    const Place at;
    for (const std::string& device : devices()) {
        CAPTURE(device);
        for (const render::Sampling s : {render::Sampling::plain, render::Sampling::reuse}) {
            const double noise = s == render::Sampling::plain ? 1e-4 : .01;  // relative
            CHECK(picture(sky_and_two + at.square("A", true) + at.square("B", true), device, s) ==
                  doctest::Approx(.2).epsilon(noise));
            CHECK(picture(sky_and_two + at.square("A", true) + at.square("G", true) + at.square("B", false), device,
                          s) == doctest::Approx(.5).epsilon(noise));
        }
    }
}

TEST_CASE("a decal .1 mm above a desk stays on top") {
    expect_pairs({}, {{PAIR(p.square("A", true, 1e-4, .8) + p.square("B", true)), .5},
                      {PAIR(p.square("A", false, 1e-4, .8) + p.square("B", true)), .5}});
}

// Two panes in one place are one; one on an opaque floor is none.
TEST_CASE("shadow rays count surfaces in one place once") {
    const Place at;
    const std::string sun = "void light sl 0 0 3 1000 1000 1000\nsl source sun 0 0 4 .1 .2 1 1\n";
    const std::string floor = sun + "void plastic A 0 0 5 .5 .5 .5 0 0\n" + at.square("A", true, -1, 9);
    const std::string glass = "void glass G 0 0 3 .5 .5 .5\nvoid glass H 0 0 3 .8 .8 .8\n";
    const Ray ray{{.1, .3, -.5}, {.1, .1, -1}};
    for (const std::string& device : devices()) {
        CAPTURE(device);
        const auto value = [&](const std::string& panes) {
            const scene::Scene scene = scene_of(floor + glass + panes);
            render::Renderer renderer(scene, view::View(), 1, 1, direct_only(), device, {});
            return trace_ray(renderer, ray.origin, ray.dir, 64).mean[0];
        };
        const double one = value(at.square("H", true));
        CHECK(one > 0);
        CHECK(value(at.square("G", true) + at.square("H", true)) == one);
        CHECK(value(at.square("H", false) + at.square("G", false)) == one);
        CHECK(value(at.square("H", true) + "G polygon on 0 0 12 -2 -2 -1 2 -2 -1 2 2 -1 -2 2 -1\n") == one);
    }
}

// A mixture is of an opaque type, also where it is void: it hides a wall in its place, and light passes the void.
TEST_CASE("shadow rays do not meet a wall that a net in its place hides") {
    TempFolder folder;
    const std::string sun = "void light sl 0 0 3 1000 1000 1000\nsl source sun 0 0 4 .1 .2 1 1\n";
    const std::string A = "void plastic A 0 0 5 .5 .5 .5 0 0\n", N = "void mixfunc N 4 A void 0 .\n0 0\n";
    const std::string square = " polygon p 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n", ball = " sphere s 0 0 4 0 0 1 1\n",
                      tube = " cylinder c 0 0 7 0 -9 1 0 9 1 1\n", ring = " ring r 0 0 8 0 0 0 0 0 1 0 2\n",
                      below = " polygon b 0 0 12 -2 2 0 2 2 0 2 -2 0 -2 -2 0\n";
    const std::string inside = folder.holding("both.rad", A + N + "A" + square + "N" + square);
    const Ray ray{{.1, .1, -.5}, {0, .02, -1}};
    const auto value = [&](const std::string& text, const std::string& device) {
        const std::string floor = "void plastic F 0 0 5 .5 .5 .5 0 0\n" + Place{}.square("F", true, -1, 9);
        const scene::Scene scene = scene_of(sun + floor + text);
        render::Renderer renderer(scene, view::View(), 1, 1, direct_only(), device, {});
        return trace_ray(renderer, ray.origin, ray.dir, 64).mean[0];
    };
    for (const std::string& device : devices()) {
        CAPTURE(device);
        const double open = value("", device);
        CHECK(open > 0);
        for (const std::string& text : {A + N + "A" + square + "N" + square, A + N + "N" + square + "A" + square,
                                        A + N + "A" + ring + "N" + square, A + N + "A" + ball + "N" + ball,
                                        A + N + "A" + tube + "N" + tube, "void instance i 1 " + inside + " 0 0\n"}) {
            CAPTURE(text);
            CHECK(value(text, device) == open);
        }
        const std::string N_first = "void plastic B 0 0 5 .5 .5 .5 0 0\nvoid mixfunc N 4 B void 0 .\n0 0\n";
        CHECK(value(N_first + A + "A" + square + "N" + square, device) == 0);  // the wall's modifier is the later
        CHECK(value(A + N + "A" + below + "N" + square, device) == 0);         // it faces the ray
        CHECK(value(A + N + "A" + square + "N" + below, device) == open);
    }
}

// An emitter in the plane of a ceiling lights nothing where the ceiling shows: of modifiers the later one.
TEST_CASE("an emitter that a ceiling hides is dark") {
    const std::string lamp = "void light L 0 0 3 1 1 1\n", ceiling = "void plastic C 0 0 5 .5 .5 .5 0 0\n";
    const std::string rest =
        "L ring l 0 0 8 0 0 2 0 0 -1 0 1\nC polygon c 0 0 12 -5 -5 2 -5 5 2 5 5 2 5 -5 2\n"
        "C polygon f 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n";
    const double seen = .5 * 1 / (1 + 4.0);  // p sin^2 of the half angle
    expect(ceiling + lamp + rest, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {seen}, 16384);
    expect(lamp + ceiling + rest, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {0});

    // A mixture is of an opaque type, also where it is void; a ray that goes on through it has the lamp behind it.
    const std::string net = "void mixfunc M 4 C void .5 .\n0 0\n";
    const std::string covered =
        "L ring l 0 0 8 0 0 2 0 0 -1 0 1\nM polygon m 0 0 12 -5 -5 2 -5 5 2 5 5 2 5 -5 2\n"
        "C polygon f 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n";
    expect(ceiling + net + lamp + covered, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {seen}, 16384);
    expect(lamp + ceiling + net + covered, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {0});

    // So does a mixture that is void everywhere.
    const std::string nothing = "void mixfunc M 4 void void .5 .\n0 0\n";
    expect(ceiling + nothing + lamp + covered, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {seen}, 16384);
    expect(lamp + ceiling + nothing + covered, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {0});

    // An illum, through which shadow rays pass, is hidden like a lamp.
    const std::string illum = "void illum L 0 0 3 1 1 1\n";
    expect(ceiling + illum + rest, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {seen}, 16384);
    expect(illum + ceiling + rest, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {0});

    // Round lamps likewise.
    for (const std::string shape : {"sphere s 0 0 4 0 0 2 .5\n", "cylinder s 0 0 7 -1 0 2 1 0 2 .5\n"}) {
        CAPTURE(shape);
        const std::string round = "L " + shape + "M " + shape + "C polygon f 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n";
        expect(lamp + ceiling + net + round, direct_only(), {{0, 0, 1}, {0, 0, -1}}, {0});
    }
}

TEST_CASE("a surface that the eye lies on does not hide what is before it") {
    for (const Place& at : places) {
        CAPTURE(at.scale);
        CAPTURE(at.tilt_deg);
        const std::string desk = at.square("A", true) + at.square("B", false);
        std::vector<Seen> seen;
        for (const Vec3& dir : {Vec3{.1, .2, 1}, Vec3{.7, .3, .001}, Vec3{1, .2, .3}, Vec3{.1, .2, -1}})
            seen.push_back({at.ray({.1, .3, 0}, dir), 1});
        expect_seen(desk, seen, 16);
    }
}

TEST_CASE("the same in pictures, of a sun too") {
    const std::string floor =
        sky + "void light sl 0 0 3 10 10 10\nsl source sun 0 0 4 .1 .2 1 20\n" +
        "void plastic A 0 0 5 .5 .5 .5 0 0\nA polygon p 0 0 12 -2 -2 .76 2 -2 .76 2 2 .76 -2 2 .76\n";
    view::View view;
    view.type = 'h';
    view.vd = {0, 0, 1};
    view.vu = {0, 1, 0};
    view.vh = view.vv = 180;
    for (const std::string& device : devices()) {
        CAPTURE(device);
        double sum[2] = {0, 0};
        for (int on = 0; on < 2; on++) {
            view.vp = {.1, .3, on ? .76 : 1};
            render::Renderer renderer(scene_of(floor), view, 32, 32, direct_only(), device, {});
            renderer.frames(0, 1, [&](int64_t, const std::vector<float>& rgb, const image::Moments&) {
                for (float v : rgb) sum[on] += v;
                return true;
            });
        }
        CHECK(sum[1] == doctest::Approx(sum[0]).epsilon(.05));  // the sun by its area, and by samples
        CHECK(sum[1] > .7 * 32 * 32 * 3);
    }
}

// A plate 1 cm above the floor, seen from between: no sun there, also in kilometres and millimetres.
TEST_CASE("rays start as near to a surface as the model is small") {
    const std::string sun =
        "void light sl 0 0 3 1000 1000 1000\nsl source sun 0 0 4 .1 .2 1 1\nvoid plastic A 0 0 5 .5 .5 .5 0 0\n";
    for (double scale : {1.0, .001, 1000.0}) {
        CAPTURE(scale);
        const Place at{scale, 0, {0, 0, 0}, 0};
        expect(sun + at.square("A", true) + at.square("A", true, .01), direct_only(),
               at.ray({.3, .2, .005}, {.1, .1, -1}), {0}, 64);
    }
}
