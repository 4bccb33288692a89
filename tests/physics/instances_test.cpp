// SPDX-License-Identifier: BSD-3-Clause
// Meshes and instances on every device: where their points lie, which way they face, what their functions see.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <random>

#include "base/vec.h"
#include "flatten/trees.h"
#include "unit/temp_folder.h"

using namespace laws;
using base::Vec3;

namespace {
const render::RenderOptions centre_only = [] {
    render::RenderOptions o = direct_only();
    o.dj = 0;  // the middle of the sun: no noise
    return o;
}();
// A sun of radiance 1000 and half a degree radius; on a surface that faces it, of reflectance .5: L = .5/pi 1000 w.
const double w = 2 * pi * (1 - std::cos(.5 * pi / 180)), facing = .5 / pi * 1000 * w;
std::string sun(double tilt_deg) {
    return "void light sl 0 0 3 1000 1000 1000\nsl source sun 0 0 4 " + std::to_string(std::sin(tilt_deg * pi / 180)) +
           " 0 " + std::to_string(std::cos(tilt_deg * pi / 180)) + " 1\n";
}
// A unit square that shines as bright as its x.
const char* const ramp =
    "void brightfunc pat 2 Px . 0 0\npat glow g 0 0 4 1 1 1 0\ng polygon p 0 0 12 0 0 0 1 0 0 1 1 0 0 1 0\n";
Ray down(double x, double y) { return {{x, y, 50}, {0, 0, -1}}; }
}  // namespace

TEST_CASE("functions inside an instance see its own coordinates") {
    TempFolder folder;
    const std::string in = folder.holding("in.rad", ramp);
    // (x, y) stands at (3 - 2y, 2x)
    expect("void instance i 9 " + in + " -s 2 -rz 90 -t 3 0 0 0 0\n", centre_only, down(2.5, .8), {.4}, 1);
    // within another one: the innermost octree's
    const std::string middle = folder.holding("middle.rad", "void instance i 5 " + in + " -t 0 0 1 0 0\n");
    const std::string outer = "void instance o 4 " + middle + " -mx -s 3 0 0\n";
    expect(outer, centre_only, down(-1.2, 1.5), {.4}, 1);
}

TEST_CASE("a modifier of the instance replaces all inside and sees the coordinates around the instance") {
    TempFolder folder;
    const std::string in = folder.holding("in.rad", ramp);
    const std::string glow = "void brightfunc pat 2 Px+3 . 0 0\npat glow h 0 0 4 1 1 1 0\n";
    const std::string middle = folder.holding("middle.rad", glow + "h instance i 5 " + in + " -t 0 0 1 0 0\n");
    expect("void instance o 3 " + middle + " -s 2 0 0\n", centre_only, down(1.2, .8), {3.6}, 1);
    expect(glow + "h instance o 3 " + middle + " -s 2 0 0\n", centre_only, down(1.2, .8), {4.2}, 1);
    // also where the inner surfaces had none
    const std::string bare = folder.holding("bare.rad", "void ring r 0 0 8 0 0 0 0 0 1 0 1\n");
    expect(glow + "h instance o 1 " + bare + " 0 0\n", centre_only, down(.5, .2), {3.5}, 1);
}

TEST_CASE("a mirrored instance keeps its geometry's sides") {
    TempFolder folder;
    const std::string in = folder.holding("in.rad", ramp);
    expect("void instance i 2 " + in + " -mx 0 0\n", centre_only, down(-.4, .5), {.4}, 1);
    expect("void instance i 2 " + in + " -mz 0 0\n", centre_only, {{.4, .5, -50}, {0, 0, 1}}, {.4}, 1);
    expect("void instance i 2 " + in + " -mz 0 0\n", centre_only, down(.4, .5), {0}, 1);
}

TEST_CASE("an instance looks like its scene put there by xform") {
    TempFolder folder;
    const std::string in = folder.holding(
        "in.rad",
        "void plastic m 0 0 5 .5 .4 .3 .05 .1\nm sphere s 0 0 4 0 0 1 .7\nm cone c 0 0 8 2 0 0 2 0 2 .8 .2\n"
        "m polygon p 0 0 12 -2 -2 0 4 -2 0 4 2 0 -2 2 0\nm ring r 0 0 8 0 3 .5 0 .3 1 .2 1\nm tube t 0 0 7 3 3 0 3 3 2 "
        ".5\n"
        "m polygon q 0 0 15 -2 2.2 .1 0 4.5 1 -1 3 .5 -2 4.5 .3 -3 3 0\n");
    const std::string moves = " -mx -rx 20 -rz 30 -s 1.5 -t 3 2 1";
    const std::string a = sun(30) + "void instance i 12 " + in + moves + " 0 0\n",
                      b = sun(30) + "!xform" + moves + " " + in + "\n";
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer one(scene_of(a), view::View(), 1, 1, centre_only, device, {}),
            two(scene_of(b), view::View(), 1, 1, centre_only, device, {});
        int lit = 0, different = 0, n = 0;
        for (double x = -9; x < 12; x += .7)
            for (double y = -6; y < 12; y += .7) {
                const double o[3] = {x, y, 30}, d[3] = {.1, -.05, -1};
                const auto v = trace_ray(one, o, d, 1), u = trace_ray(two, o, d, 1);
                n++;
                lit += u.mean[0] > 0;
                different += std::abs(v.mean[0] - u.mean[0]) > 1e-3 * u.mean[0] + 1e-6;
            }
        CHECK(lit > n / 20);
        CHECK(different <= n / 500);  // rays that just touch an edge
    }
}

// The normal given to all three corners leans 20 degrees toward +x; mirrored, toward -x.  Lu and Lv run with x and y.
TEST_CASE("a mesh has its corners' normals and its own u and v") {
    TempFolder folder;
    const double a = 20 * pi / 180;
    const std::string normal = std::to_string(std::sin(a)) + " 0 " + std::to_string(std::cos(a));
    const std::string obj = folder.holding("tri.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn " +
                                                          normal + "\nusemtl m\nf 1/1/1 2/2/1 3/3/1\n");
    const std::string white = "void plastic m 0 0 5 .5 .5 .5 0 0\n",
                      lu = "void brightfunc p 2 Lu+10*Lv . 0 0\np plastic m 0 0 5 .5 .5 .5 0 0\n";
    const auto lean = [&](double degrees) { return facing * std::cos(degrees * pi / 180); };
    expect(sun(30) + white + "void mesh t 1 " + obj + " 0 0\n", centre_only, down(.5, .5), {lean(10)}, 1);
    expect(sun(30) + white + "void mesh t 4 " + obj + " -mx -s 3 0 0\n", centre_only, down(-1, 1), {lean(50)}, 1);
    expect(sun(30) + white + "m mesh t 5 " + obj + " -rz 180 -s 3 0 0\n", centre_only, down(-1, -1), {lean(50)}, 1);
    expect(sun(30) + lu + "void mesh t 1 " + obj + " 0 0\n", centre_only, down(.5, .2), {lean(10) * 1.25}, 1);
    expect(sun(30) + lu + "m mesh t 3 " + obj + " -s 4 0 0\n", centre_only, down(2, .8), {lean(10) * 1.25}, 1);
    expect(sun(30) + "void mesh t 1 " + folder.holding("none.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n") + " 0 0\n",
           centre_only, down(.5, .5), {0}, 1);  // without a material it is not there
}

// A white floor under a sky of radiance 1 all around looks like .5 unless its own rays meet it again; 0.01 of them
// would show.
TEST_CASE("surfaces of instances do not shade themselves") {
    TempFolder folder;
    const std::string in =
        folder.holding("in.rad",
                       "void plastic m 0 0 5 .5 .5 .5 0 0\nm polygon p 0 0 12 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n"
                       "m sphere s 0 0 4 0 0 -30 5\n");
    const std::string sky = "void glow k 0 0 4 1 1 1 0\nk source sky 0 0 4 0 0 1 360\n";
    render::RenderOptions options;
    options.ab = 1;
    for (const char* moves :
         {" -rx 31 -ry 17 -rz 70", " -rx 31 -ry 17 -rz 70 -s 20 -t 3000 2000 100", " -mx -ry 40 -s .01 -t .5 .5 .5"}) {
        CAPTURE(moves);
        base::Xform x;
        std::vector<std::string> words;
        for (std::istringstream s(moves); s.good();) {
            words.emplace_back();
            s >> words.back();
        }
        base::parse_xform({words.data(), words.size()}, 0, x, "");
        const Vec3 to = base::point(x, {2, 1, 0}), from = base::point(x, {1, 5, 3}), d = unit(to - from);
        expect(sky + "void instance i " + std::to_string(1 + words.size()) + " " + in + moves + " 0 0\n", options,
               {{from.x, from.y, from.z}, {d.x, d.y, d.z}}, {.5}, 4096);
    }
}

TEST_CASE("lamps inside an instance are seen, and light nothing by themselves") {
    TempFolder folder;
    const std::string lamp = "void light l 0 0 3 7 7 7\nl polygon p 0 0 12 -1 -1 2 -1 1 2 1 1 2 1 -1 2\n";
    const std::string in = folder.holding("lamp.rad", lamp);
    const std::string floor = "void plastic m 0 0 5 .5 .5 .5 0 0\nm ring f 0 0 8 0 0 0 0 0 1 0 9\n";
    render::RenderOptions options;
    options.ab = 1;
    const std::string there = "void instance i 1 " + in + " 0 0\n";
    expect(floor + there, options, {{0, 0, .5}, {0, 0, 1}}, {7}, 1);
    expect(floor + there, options, {{3, 0, 1}, {-3, 0, -1}}, {0}, 64);

    const std::string bare = folder.holding("bare.rad", "void ring r 0 0 8 0 0 2 0 0 -1 0 1\n");
    const std::string lit = "void light l 0 0 3 7 7 7\nl instance i 1 " + bare + " 0 0\n";
    expect(floor + lit, options, {{0, 0, .5}, {0, 0, 1}}, {7}, 1);
    expect(floor + lit, options, {{3, 0, 1}, {-3, 0, -1}}, {0}, 64);
}

TEST_CASE("geometry is kept once, whatever stands how often") {
    TempFolder folder;
    std::string grid;
    const int n = 60;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) grid += "v " + std::to_string(i) + " " + std::to_string(j) + " 0\n";
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) grid += "vn 0 0 1\n";
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const int a = i * (n + 1) + j + 1, b = a + n + 1;
            for (const auto& t : {std::array<int, 3>{a, b, b + 1}, std::array<int, 3>{a, b + 1, a + 1}}) {
                grid += "f";
                for (int v : t) grid += " " + std::to_string(v) + "//" + std::to_string(v);
                grid += "\n";
            }
        }
    const std::string obj = folder.holding("grid.obj", grid);
    const std::string white = "void plastic m 0 0 5 .5 .5 .5 0 0\nvoid plastic m2 0 0 5 .4 .4 .4 0 0\n";
    const auto bytes = [](const flatten::FlatScene& s) {
        return sizeof(kernels::Prim) * s.prims.size() + sizeof(kernels::Instance) * s.instances.size() +
               sizeof(kernels::Corner) * s.corners.size() + sizeof(kernels::Shape) * s.shapes.size() +
               sizeof(kernels::Modifier) * s.modifiers.size() +
               4 * (s.geometry->vertices.size() + s.geometry->triangles.size() + s.geometry->tri_prim.size() +
                    s.geometry->shape_prim.size() + s.u.size() + s.f.size() + s.prim_object.size());
    };
    const auto flat = [&](const std::string& text) { return flatten::flatten(scene_of(white + text), {}, {}); };
    const size_t none = bytes(flat("m sphere s 0 0 4 0 0 0 1\n"));
    const auto one = flat("m mesh a 1 " + obj + " 0 0\n");
    CHECK(one.trees.size() == 2);
    CHECK(one.trees[1].triangle_count == 2 * n * n);
    CHECK((bytes(one) - none) / (2 * n * n) < 100);  // a triangle, with its share of the corners
    const auto two = flat("m mesh a 1 " + obj + " 0 0\nm2 mesh b 5 " + obj + " -t 0 0 1 0 0\n");
    CHECK(two.trees.size() == 2);
    CHECK(bytes(two) - bytes(one) < 400);
    CHECK(two.instance_object == std::vector<uint32_t>{2, 3});
}

// Reading takes a step a primitive, a place ten (base/work_budget.h).
TEST_CASE("an octree is looked through once, however often it is placed") {
    TempFolder folder;
    const int inside = 10000, places = 1000;
    std::string many = "void plastic m 0 0 5 .5 .5 .5 0 0\n", placed;
    for (int i = 0; i < inside; i++) many += "m sphere s 0 0 4 " + std::to_string(3 * i) + " 0 0 1\n";
    const std::string in = folder.holding("in.rad", many);
    for (int i = 0; i < places; i++)
        placed += "void instance i 5 " + in + " -t 0 " + std::to_string(3 * i) + " 0 0 0\n";
    scene::ReadOptions how;
    how.work = std::make_shared<base::WorkBudget>(2 * inside + 20 * places);
    const flatten::FlatScene s = flatten::flatten(scene_of(placed), {}, how);
    CHECK(s.instance_object.size() == places);
    CHECK(s.trees.size() == 2);
}

TEST_CASE("a scene of nothing but instances far from the origin keeps its digits") {
    TempFolder folder;
    const std::string in =
        folder.holding("in.rad",
                       "void brightfunc pat 2 Px-5e6 . 0 0\npat glow g 0 0 4 1 1 1 0\n"
                       "g polygon p 0 0 12 5000000 6000000 0 5000001 6000000 0 5000001 6000001 0 5000000 6000001 0\n");
    const flatten::FlatScene s = flatten::flatten(scene_of("void instance i 5 " + in + " -t 1e6 0 0 0 0\n"), {}, {});
    CHECK(length(s.centre - Vec3{6000000.5, 6000000.5, 0}) < 2);
    for (float v : s.geometry->vertices) CHECK(std::abs(v) < 2);
}
