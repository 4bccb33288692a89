// SPDX-License-Identifier: BSD-3-Clause
// Patches of sun lie where the window's image falls along the sun's rays, on what it meets first, and only what is lit.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/tempfile.h"
#include "flatten/flatten.h"
#include "flatten/host_tracer.h"
#include "sampling/patches.h"
#include "sampling/targets.h"
#include "kernels/dialect/host.h"
#include "scene/object.h"

namespace {
using base::Vec3;

// A floor z = 0 and a wall x = 0; the sun stands at 45 degrees over x; more may stand in its way.
flatten::FlatScene room(const std::string& more) {
    base::TempFile file((std::filesystem::temp_directory_path() / "luxpipe_patches.rad").string());
    std::ofstream(file.path()) << "void light sunlight 0 0 3 1e6 1e6 1e6\nsunlight source sun 0 0 4 1 0 1 .5\n"
                                  "void plastic paint 0 0 5 .5 .5 .5 0 0\n"
                                  "paint polygon floor 0 0 12 0 -9 0 9 -9 0 9 9 0 0 9 0\n"
                                  "paint polygon wall 0 0 12 0 -9 0 0 9 0 0 9 9 0 -9 9\n"
                               << more;
    flatten::FlatScene scene = flatten::flatten(scene::read_scene({file.path()}, {}), {}, {});
    sampling::find_targets(scene, sampling::find_windows(scene), base::WorkBudget());
    return scene;
}

// At x = 4, from y = -1 to 1 and from z = low to high.
sampling::Target window(double low, double high) {
    return {{4, 0, (low + high) / 2}, {0, 2, 0}, {0, 0, high - low}, {1, 0, 0}};
}

std::vector<sampling::Target> patches(const flatten::FlatScene& scene, const sampling::Target& window,
                                      size_t most = 8) {
    return sampling::find_patches(scene, flatten::HostTracer(scene), {window}, most);
}

void check_at(Vec3 is, Vec3 wanted) {
    CHECK(is.x == doctest::Approx(wanted.x).epsilon(1e-5));
    CHECK(is.y == doctest::Approx(wanted.y).epsilon(1e-5));
    CHECK(is.z == doctest::Approx(wanted.z).epsilon(1e-5));
}

}  // namespace

TEST_CASE("the window's image on the floor") {
    const auto found = patches(room(""), window(1, 3));
    REQUIRE(found.size() == 1);
    check_at(found[0].centre, {2, 0, 0});  // x from 1 to 3
    CHECK(length(cross(found[0].u, found[0].v)) == doctest::Approx(4).epsilon(1e-5));
    check_at(found[0].out, {0, 0, -1});
}

TEST_CASE("what reaches farther is on the wall, the larger part first") {
    const auto found = patches(room(""), window(1, 5));
    REQUIRE(found.size() == 2);
    check_at(found[0].centre, {1.5, 0, 0});  // up to z = 4 of the window: x from 0 to 3
    check_at(found[1].centre, {0, 0, .5});
    check_at(found[1].out, {-1, 0, 0});
    CHECK(patches(room(""), window(1, 5), 1).size() == 1);
}

TEST_CASE("a shade leaves the lit part") {
    // keeps the sun from all of the window above z = 2
    const auto found = patches(room("paint polygon shade 0 0 12 5 -2 3 5 2 3 5 2 9 5 -2 9\n"), window(1, 3));
    REQUIRE(found.size() == 1);
    check_at(found[0].centre, {2.5, 0, 0});
    CHECK(length(cross(found[0].u, found[0].v)) == doctest::Approx(2).epsilon(1e-5));
}

TEST_CASE("a post cuts the patch in two") {
    const auto found = patches(room("paint polygon post 0 0 12 5 -.5 0 5 .5 0 5 .5 9 5 -.5 9\n"), window(1, 3));
    REQUIRE(found.size() == 2);
    for (const sampling::Target& patch : found) CHECK(std::abs(patch.centre.y) == doctest::Approx(.75).epsilon(1e-5));
}

TEST_CASE("a sliver of glass is no window") {
    const std::string pane = "void glass clear 0 0 3 .9 .9 .9\nclear polygon pane 0 0 12 9 -1 1 9 1 1 9 1 3 9 -1 3\n";
    const std::string sliver = "clear polygon sliver 0 0 12 9 3 1 9 5 1 9 5 1.000000000001 9 3 1.000000000001\n";
    const flatten::FlatScene one = room(pane), two = room(pane + sliver);
    CHECK(one.window_count == 1);
    CHECK(two.window_count == 1);
    CHECK(two.portals.size() > 1);
    std::vector<float> numbers(two.portals.size() * sizeof(kernels::Portal) / sizeof(float));
    std::memcpy(numbers.data(), two.portals.data(), numbers.size() * sizeof(float));
    for (const float number : numbers) CHECK(std::isfinite(number));
}

TEST_CASE("a narrow glossy reflector in the sun is aimed at, a wide table has its cone") {
    const std::string pane = "void glass clear 0 0 3 .9 .9 .9\nclear polygon pane 0 0 12 9 -1 1 9 1 1 9 1 3 9 -1 3\n";
    const std::string metal = "void metal brushed 0 0 5 .5 .5 .5 .7 .1\n";
    const std::string sill = "brushed polygon sill 0 0 12 8 -1 1.5 8.05 -1 1.5 8.05 1 1.5 8 1 1.5\n";
    const std::string table = "brushed polygon table 0 0 12 5 -1 .7 6 -1 .7 6 1 .7 5 1 .7\n";
    const auto polished = [](const flatten::FlatScene& scene) {
        int count = 0;
        for (const kernels::Portal& portal : scene.portals) count += portal.gloss2 > 0;
        return count;
    };
    CHECK(polished(room(pane + metal + sill + table)) == 1);
    CHECK(polished(room(pane + metal + table)) == 0);
    CHECK(polished(room(metal + sill)) == 0);  // no window: no portals
}

TEST_CASE("no sun, no patch") {
    CHECK(patches(room("paint polygon shade 0 0 12 5 -9 0 5 9 0 5 9 9 5 -9 9\n"), window(1, 3)).empty());
    sampling::Target away = window(1, 3);
    away.out = {-1, 0, 0};
    CHECK(patches(room(""), away).empty());
}
