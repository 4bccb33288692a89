// SPDX-License-Identifier: BSD-3-Clause
// Our traversal against Embree's own, ray by ray, in rooms as people model them: the same distance, and the same answer
// whether anything is in the way.  Paths that leave their last hit at random, so that rays begin on surfaces, too.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "flatten/trees.h"
#include "flatten/flatten.h"
#include "flatten/host_tracer.h"
#include "scene/object.h"
#include "unit/embree_scene.h"

namespace {

struct Room {
    std::string folder;
    std::vector<std::string> files;
    base::Vec3 eye;
};

void compare(const Room& room) {
    base::ReadOptions options;
    options.raypath = {"."};
    std::vector<std::string> names;
    for (const std::string& file : room.files) names.push_back(LUXPIPE_TESTS "/" + room.folder + "/" + file);
    base::search_beside(names, options);
    const flatten::FlatScene flat = flatten::flatten(scene::read_scene(names, options), {}, options);
    const flatten::HostTracer ours(flat);
    const std::vector<bvh::Input> inputs = flatten::build_inputs(flat);
    const bvh::EmbreeScene embree(inputs.data(), inputs.size());

    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    int rays = 0, hits = 0, other_closest = 0, other_any = 0;
    for (int path = 0; path < 4000; ++path) {
        base::Vec3 from = room.eye;
        for (int bounce = 0; bounce < 4; ++bounce, ++rays) {
            const base::Vec3 dir = base::unit({normal(random), normal(random), normal(random)});
            const base::Vec3 o = from - flat.centre;
            const float org[] = {float(o.x), float(o.y), float(o.z)}, d[] = {float(dir.x), float(dir.y), float(dir.z)};
            const auto mine = ours.closest(from, dir, 1e-3, 1e30, flatten::HostTracer::all);
            const auto theirs = embree.closest(org, 1e-3f, d, 1e30f, flatten::HostTracer::all);
            const bool they_hit = theirs.prim != 0xffffffff;
            other_closest +=
                they_hit != (mine.t >= 0) || (they_hit && std::fabs(mine.t - double(theirs.t)) > 1e-4 * (1 + mine.t));
            other_any += ours.blocked(from, dir, 1e-3, 1.5, flatten::HostTracer::opaque) !=
                         embree.any(org, 1e-3f, d, 1.5f, flatten::HostTracer::opaque);
            if (mine.t < 0) break;
            ++hits;
            from = from + mine.t * dir;
        }
    }
    CAPTURE(room.folder);
    CAPTURE(rays);
    CHECK(hits > 8000);
    CHECK(other_closest <= rays / 2000);  // rays within an ulp of an edge, or of where they begin
    CHECK(other_any <= rays / 2000);
}

}  // namespace

TEST_CASE("Embree's own traversal finds the same in rooms") {
    compare({"../examples/scenes/office", {"materials.rad", "layout.rad", "blinds.rad"}, {2, 2.7, 1.2}});
    compare({"../examples/scenes/classroom", {"materials.rad", "room.rad", "furniture.rad"}, {6.6, 6.2, 1.2}});
    compare({"../examples/scenes/gallery", {"materials.rad", "room.rad", "objects.rad"}, {1.6, 3, 1.6}});
}
