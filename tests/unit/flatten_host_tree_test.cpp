// SPDX-License-Identifier: BSD-3-Clause
// A scene's tree on this machine is built once: windows, highlights, drawn sources and the CPU device share it.  Of ten
// million triangles each further one took a third of the time to begin.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "base/processors.h"
#include "base/tempfile.h"
#include "flatten/flatten.h"
#include "flatten/host_rays.h"
#include "flatten/host_tracer.h"
#include "flatten/trees.h"
#include "scene/object.h"

namespace {

// A floor that shines in the sun, behind a window: both searches for where light comes from have something to find.
flatten::FlatScene sunny_room(const std::string& more = "", const flatten::Options& options = {}) {
    base::TempFile file((std::filesystem::temp_directory_path() / "luxpipe_host_tree.rad").string());
    std::ofstream(file.path()) << "void light sunlight 0 0 3 1e6 1e6 1e6\nsunlight source sun 0 0 4 .6 0 .8 .5\n"
                                  "void plastic floor_paint 0 0 5 .5 .5 .5 .05 .1\nvoid glass pane 0 0 3 .9 .9 .9\n"
                                  "floor_paint polygon floor 0 0 12 0 0 0 4 0 0 4 4 0 0 4 0\n"
                                  "floor_paint polygon roof 0 0 12 0 0 3 0 4 3 2 4 3 2 0 3\n"
                                  "pane polygon window 0 0 12 4 0 0 4 4 0 4 4 3 4 0 3\n"
                               << more;
    return flatten::flatten(scene::read_scene({file.path()}, {}), options, {});
}

}  // namespace

TEST_CASE("all who trace rays on this machine share one tree") {
    const flatten::FlatScene flat = sunny_room();
    const auto tree = flat.built.wide;
    CHECK(tree.use_count() == 2);  // the scene's and ours
    {
        const flatten::HostTracer one(flat), other(flat);
        CHECK(tree.use_count() == 4);
    }
    const flatten::FlatScene copy = flat;
    CHECK(copy.built.wide == tree);
}

TEST_CASE("what no kernel reads is given back, and rays meet the same") {
    flatten::FlatScene flat = sunny_room();
    const base::Vec3 eye = {1, 1, 1}, down = {.1, .2, -1};
    const auto found = [&] { return flatten::HostTracer(flat).closest(eye, down, 0, 1e30, flatten::HostTracer::all); };
    const flatten::HostTracer::Found before = found();
    CHECK(before.t > 0);
    flat.keep_tables_only();
    CHECK(flat.geometry == nullptr);
    CHECK(flat.prim_object.capacity() == 0);
    CHECK(found().t == before.t);
    CHECK(found().prim == before.prim);
}

TEST_CASE("both builds of the traversal meet the same") {
    if (!base::has_avx2()) return;
    using namespace kernels;
    const flatten::FlatScene flat =
        sunny_room("floor_paint sphere s 0 0 4 1 1 1 .5\nfloor_paint ring r 0 0 8 2 3 1 0 1 1 0 .7\n");
    SceneTables tables{};
#define POINT_AT_BVH(type, name) tables.name = flat.built.wide->name.data();
#define POINT_AT_SCENE(type, name) tables.name = flat.name.data();
    BVH_TABLES(POINT_AT_BVH)
    FLAT_TABLES(POINT_AT_SCENE)
    std::mt19937 random(1);
    std::uniform_real_distribution<float> at(-1, 5);
    int met = 0;
    for (int k = 0; k < 20000; k++) {
        const Ray ray = {F3(at(random), at(random), at(random)), 0, F3(at(random), at(random), at(random)), 1e30f};
        for (const uint32_t mask : {1u, 2u, 3u}) {
            Hit one{}, other{};
            flatten::host_rays_baseline.closest(&tables, &ray, mask, &one);
            flatten::host_rays_avx2.closest(&tables, &ray, mask, &other);
            met += one.prim != NO_HIT;
            CHECK(std::memcmp(&one, &other, sizeof one) == 0);
            CHECK(flatten::host_rays_baseline.any(&tables, &ray, mask) ==
                  flatten::host_rays_avx2.any(&tables, &ray, mask));
        }
    }
    CHECK(met > 1000);
}

TEST_CASE("the tree of another scene serves one of the same surfaces, and no other") {
    flatten::Options options;
    options.known = sunny_room().built;
    CHECK(sunny_room("void glow g 0 0 4 1 1 1 0\n", options).built.wide == options.known.wide);
    const flatten::FlatScene more = sunny_room("floor_paint sphere s 0 0 4 1 1 1 .2\n", options);
    CHECK(more.built.wide != options.known.wide);
    CHECK(more.built.inputs != options.known.inputs);
}

TEST_CASE("who waits for a tree is told how far it is") {
    flatten::Draft flat;
    const size_t n = 50000;
    flat.trees.push_back({0, 3 * n, 0, n, 0, 0});
    for (size_t k = 0; k < n; k++) {
        const float x = float(k % 200), y = float(k) / 200;
        flat.vertices.insert(flat.vertices.end(), {x, y, 0, x + 1, y, 0, x, y + 1, 0});
        for (size_t corner = 0; corner < 3; corner++) flat.triangles.push_back(uint32_t(3 * k + corner));
        flat.tri_prim.push_back(uint32_t(k));
    }
    std::vector<double> told;
    flatten::Options options;
    options.tell_tree = [&](double share) { told.push_back(share); };
    build_trees(std::move(flat).finished(), options, base::WorkBudget());
    REQUIRE(told.size() > 1);
    CHECK(told.front() < .9);
    for (double share : told) CHECK((share > 0 && share <= 1));
}
