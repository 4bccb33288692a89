// SPDX-License-Identifier: BSD-3-Clause
// What scenes of different skies share (render/loaded_scene.h): a room is taken where it is the same, and then gives
// the same tables as one that is made anew.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>

#include "base/overlay.h"
#include "render/fingerprint.h"
#include "render/loaded_scene.h"
#include "scene/extent.h"
#include "scene_text.h"

namespace {

using render::LoadedScene, render::RenderOptions;

// A mesh, a window, a mirror, a lamp with a function, a mist that names the sun, a pattern that only skies use.
const std::string room_text =
    "void plastic paint 0 0 5 .5 .5 .5 .05 .1\nvoid glass pane 0 0 3 .9 .9 .9\nvoid mirror silver 0 0 3 .9 .9 .9\n"
    "void brightfunc cloudy 2 1+Dx sky.cal 0 0\nvoid brightfunc uneven 2 uneven lamp.cal 0 0\n"
    "uneven light bulb 0 0 3 9 9 9\nvoid mist fog 1 sun 0 3 .01 .01 .01\n"
    "void mesh box 1 box.obj 0 0\npaint polygon floor 0 0 12 0 0 0 4 0 0 4 4 0 0 4 0\n"
    "silver polygon shiny 0 0 12 0 0 0 0 4 0 0 4 3 0 0 3\nbulb sphere lamp 0 0 4 1 1 2.5 .1\n"
    "fog sphere cloud 0 0 4 2 2 1 .5\npane polygon window 0 0 12 4 0 0 4 4 0 4 4 3 4 0 3\n";
const std::string box = "usemtl paint\nv 2 2 0\nv 3 2 0\nv 3 3 0\nv 2 2 1\nf 1 2 3\nf 1 2 4\n";

std::string sky(double x) {
    return "void light sunlight 0 0 3 1e6 1e6 1e6\nsunlight source sun 0 0 4 " + std::to_string(x) +
           " .1 .8 .5\ncloudy glow haze 0 0 4 1 1 1 0\nhaze source dome 0 0 4 0 0 1 180\n";
}

struct Files : Folder {
    Files() {
        write("box.obj", box);
        write("sky.cal", "nothing = 0;");
        write("lamp.cal", "uneven = 1 + .5*Dz;");
        write("room.rad", room_text);
    }
};

struct Read {
    scene::Scene scene = scene::read_scene({"room.rad"}, {});
    scene::Extent room = scene::extent_of(scene);
};

LoadedScene load(const scene::Scene& scene, const std::shared_ptr<const render::LoadedRoom>& known = nullptr,
                 RenderOptions options = {}, const scene::ReadOptions& how = {}) {
    options.room_text = scene::hash_of_objects(scene, flatten::surfaces_end(scene)).text();
    options.keep_room = true;
    return load_scene(scene, options, how, known);
}

void under(Read& read, const std::string& text) {
    scene::cut(read.scene, read.room);
    Folder::write("sky.rad", text);
    scene::read_more(read.scene, {"sky.rad"}, {});
}

#define SAME_TABLE(type, name) CHECK(base::hash_of(a.tables->name) == base::hash_of(b.tables->name));
void check_same(const LoadedScene& a, const LoadedScene& b) {
    using namespace kernels;
    FLAT_TABLES(SAME_TABLE)
    CHECK(a.geometry.text() == b.geometry.text());
    CHECK(a.tables->window_count == b.tables->window_count);
    CHECK(a.tables->shadow_mode == b.tables->shadow_mode);
    CHECK(a.tables->sky_places == b.tables->sky_places);
    CHECK(a.smooth.planes.size() == b.smooth.planes.size());
}

}  // namespace

TEST_CASE("a room under one sky after another: read, flattened and built once; the tables of a scene of its own") {
    const Files files;
    Read many;
    std::shared_ptr<const render::LoadedRoom> room;
    for (const double x : {.6, -.6, .3}) {
        under(many, sky(x));
        const LoadedScene here = load(many.scene, room);
        if (room) CHECK(here.room == room);
        room = here.room;
        CHECK(here.tables->built.wide == room->surfaces.tables.built.wide);
        Read alone;
        under(alone, sky(x));
        const LoadedScene once = load(alone.scene);
        check_same(here, once);
        REQUIRE(here.tables->portals.size() > 0);
        CHECK(here.tables->sources.size() == (x > 0 ? 4 : 3));  // lamp, sun, images of those that meet the mirror
        CHECK(here.tables->light_sets.size() == 1);
    }
    under(many, "");
    CHECK(load(many.scene, room).room == room);
    CHECK(load(many.scene, room).tables->distant.empty());
}

TEST_CASE("a room is not taken where something of it changed") {
    const Files files;
    Read read;
    under(read, sky(.6));
    const auto room = load(read.scene).room;
    const auto is_taken = [&](const RenderOptions& options = {}, const scene::ReadOptions& how = {}) {
        return load(read.scene, room, options, how).room == room;
    };
    CHECK(is_taken());

    RenderOptions one_sided;
    one_sided.bv = false;
    CHECK(!is_taken(one_sided));
    RenderOptions far;
    far.eye = base::Vec3{1e6, 0, 0};
    CHECK(!is_taken(far));
    far.eye = base::Vec3{1, 1, 1};
    CHECK(is_taken(far));

    scene::ReadOptions edited;
    edited.overlays = base::with_overlay({}, "lamp.cal", "uneven = 2;");
    CHECK(!is_taken({}, edited));
    edited.overlays = base::without_overlay(edited.overlays, "lamp.cal");
    CHECK(edited.overlays.empty());
    CHECK(is_taken({}, edited));
    const std::vector<std::string> read_before = base::paths_of(room->files), noted = base::paths_of(*edited.read);
    for (const std::string& path : read_before)  // noted, though they were not read again
        CHECK(std::count(noted.begin(), noted.end(), path) == 1);
    Folder::write("box.obj", box + "f 1 3 4\n");
    CHECK(!is_taken());
}

TEST_CASE("a sky that has surfaces makes a room of its own") {
    const Files files;
    Read read;
    under(read, sky(.6));
    const auto room = load(read.scene).room;
    for (const char* z : {"-1", "-2"}) {
        under(read, sky(.6) + "paint ring ground 0 0 8 0 0 " + z + " 0 0 1 0 50\n");
        const LoadedScene here = load(read.scene, room);
        CHECK(here.room != room);
        check_same(here, load(read.scene));
    }
}

TEST_CASE("a scene that was cut is the scene before") {
    const Files files;
    Read read;
    const auto hash = [&] { return scene::hash_of_objects(read.scene, read.scene.objects.size()).text(); };
    const std::string before = hash();
    const size_t names = read.scene.definitions.size();
    under(read, sky(.6) + "void plastic paint 0 0 5 .1 .1 .1 0 0\n");
    CHECK(hash() != before);
    scene::cut(read.scene, read.room);
    CHECK(hash() == before);
    CHECK(read.scene.definitions.size() == names);
    CHECK(read.scene.definitions.at("paint").size() == 1);
}

TEST_CASE("a scene whose tables nobody wants any more is given up") {
    const Files files;
    Read read;
    under(read, sky(.6));
    for (const int last : {1, 2, 3}) {
        int looks = 0;
        scene::ReadOptions how;
        how.work = std::make_shared<base::WorkBudget>(base::WorkBudget::usual_limit, [&] {
            if (++looks == last) throw base::GivenUp{};
        });
        CHECK_THROWS_AS(load(read.scene, nullptr, {}, how), base::GivenUp);
        CHECK(looks == last);
    }
}
