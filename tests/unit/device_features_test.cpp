// SPDX-License-Identifier: BSD-3-Clause
// What a scene has, so that a GPU's kernels leave out the rest (kernels/features.h).  One feature too many costs time,
// one too few costs light: a scene that has nothing to leave in, then one thing at a time.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/tempfile.h"
#include "flatten/flatten.h"
#include "scene/object.h"
#include "device/features.h"
#include "render/scene_params.h"

namespace {

using namespace kernels;

constexpr const char* room =
    "void light sunlight 0 0 3 1e6 1e6 1e6\nsunlight source sun 0 0 4 .6 0 .8 .5\n"
    "void brightfunc clouds 2 .5 .\n0 0\nclouds glow sky_light 0 0 4 1 1 1 0\nsky_light source sky 0 0 4 0 0 1 "
    "180\n"
    "void plastic wall_paint 0 0 5 .5 .5 .5 .05 .1\nvoid metal steel 0 0 5 .5 .5 .5 .9 0\nvoid glass pane 0 0 3 .9 .9 "
    ".9\n"
    "void light bulb 0 0 3 1 1 1\nvoid brightfunc stripes 2 .5 .\n0 0\n"
    "wall_paint polygon floor 0 0 12 0 0 0 4 0 0 4 4 0 0 4 0\nsteel sphere ball 0 0 4 2 2 1 .5\n"
    "pane polygon window 0 0 12 4 0 0 4 4 0 4 4 3 4 0 3\nbulb sphere lamp 0 0 4 1 1 2 .1\n";

// Of the room with something more in it.
uint32_t features_with(const std::string& more, render::RenderOptions options = {}) {
    base::TempFile file((std::filesystem::temp_directory_path() / "luxpipe_features.rad").string());
    std::ofstream(file.path()) << room << more;
    const flatten::FlatScene flat = flatten::flatten(scene::read_scene({file.path()}, {}), {}, {});
    return device::features_of_scene(flat) | device::features_of_pass(render::params_of(flat, options));
}

}  // namespace

TEST_CASE("plain surfaces under a sky of functions have nothing special") { CHECK(features_with("") == 0); }

TEST_CASE("patterns, of a surface, an emitter and an alternate material") {
    CHECK(features_with("stripes plastic cloth 0 0 5 .5 .5 .5 0 0\ncloth sphere ball2 0 0 4 3 3 1 .5\n") ==
          FEATURE_PATTERNS);
    CHECK(features_with("stripes light tube 0 0 3 1 1 1\ntube sphere lamp2 0 0 4 3 3 2 .1\n") == FEATURE_PATTERNS);
    CHECK((features_with("void mirror silver 1 wall_paint 0 3 .9 .9 .9\n"
                         "silver polygon looking_glass 0 0 9 0 0 1 0 1 1 0 0 2\n") &
           FEATURE_PATTERNS) != 0);
    CHECK(features_with("void mixfunc worn 4 steel wall_paint .5 .\n0 0\nworn sphere ball2 0 0 4 3 3 1 .5\n") ==
          FEATURE_PATTERNS);
}

TEST_CASE("materials of functions") {
    CHECK(features_with("void plastic2 satin 4 1 0 0 .\n0 6 .5 .5 .5 .05 .1 .2\nsatin sphere ball2 0 0 4 3 3 1 .5\n") ==
          FEATURE_FUNCTIONS);
}

TEST_CASE("what lies between surfaces") {
    CHECK(features_with("void dielectric crystal 0 0 5 1 1 1 1.5 0\ncrystal sphere ball2 0 0 4 3 3 1 .5\n") ==
          FEATURE_SOLIDS);
    render::RenderOptions fog;
    fog.me[0] = .1;
    CHECK(features_with("", fog) == FEATURE_SOLIDS);
    CHECK((features_with("void mirror silver 0 0 3 .9 .9 .9\n"
                         "silver polygon looking_glass 0 0 9 0 0 1 0 1 1 0 0 2\n") &
           FEATURE_SOLIDS) != 0);
}
