// SPDX-License-Identifier: BSD-3-Clause
// Light does not depend on where a model stands, nor on its unit: closed forms and a room at the origin, far from it
// with and without something at the origin, in instances, in kilometres and millimetres, on every device.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <fmt/core.h>

#include "base/vec.h"
#include "flatten/flatten.h"
#include "unit/temp_folder.h"

using namespace laws;
using base::Vec3;

namespace {

const std::string sky = "void glow g 0 0 4 1 1 1 0\ng source sky 0 0 4 0 0 1 360\n";
const std::string stray =
    "void plastic stray 0 0 5 .2 .2 .2 0 0\nstray polygon stray_p 0 0 12 0 0 0 .1 0 0 .1 .1 0 0 .1 0\n";

struct Place {
    double scale;
    Vec3 move;
    Vec3 point(Vec3 p) const { return p * scale + move; }
    Ray ray(Vec3 from, Vec3 dir) const {
        const Vec3 o = point(from);
        return {{o.x, o.y, o.z}, {dir.x, dir.y, dir.z}};
    }
    std::string xform() const { return fmt::format("-s {} -t {} {} {}", scale, move.x, move.y, move.z); }
};
const std::vector<Place> places = {{1, {0, 0, 0}},          {1, {700, 700, 0}},
                                   {1, {10000, 10000, 30}}, {1, {450000, 5400000, 0}},
                                   {.001, {.7, -1.2, 0}},   {1000, {7e5, -1.2e6, 3e4}}};

void everywhere(TempFolder& folder, const std::string& model, const render::RenderOptions& options, Vec3 from, Vec3 dir,
                double exact, long samples) {
    const std::string file = folder.holding("model.rad", model);
    for (const Place& place : places)
        for (const std::string& placed : {fmt::format("!xform {} {}\n", place.xform(), file),
                                          stray + fmt::format("!xform {} {}\n", place.xform(), file),
                                          stray + fmt::format("void instance i 7 {} {} 0 0\n", file, place.xform())}) {
            CAPTURE(placed);
            expect(sky + placed, options, place.ray(from, dir), {exact}, samples);
        }
}

}  // namespace

// T and R of a pane of index 1.52: from between the panes every way out gives T / (1 - R).
TEST_CASE("two panes 16 mm apart under a sky of 1") {
    TempFolder folder;
    const std::string panes =
        "void glass pane 0 0 3 .5 .5 .5\npane polygon a 0 0 12 -1 0 0 1 0 0 1 0 2 -1 0 2\n"
        "pane polygon b 0 0 12 -1 .016 0 1 .016 0 1 .016 2 -1 .016 2\n";
    const double r = std::pow(.52 / 2.52, 2), t = .5, once = (1 - r) * (1 - r) * t / (1 - r * r * t * t);
    const double back = r * (1 + (1 - 2 * r) * t * t) / (1 - r * r * t * t);
    everywhere(folder, panes, direct_only(), {.1, -1, 1.1}, {0, 1, 0}, back + once * once / (1 - back), 2048);
}

TEST_CASE("a closed room is dark, whatever the brightness outside") {
    TempFolder folder;
    const std::string room =
        "void plastic white 0 0 5 .9 .9 .9 0 0\n!genbox white room 4 3 2.7 -i\n!genbox white desk 1 1 .7 | xform -t 1 "
        "1 "
        "0\n";
    render::RenderOptions options;
    options.ab = 4;
    everywhere(folder, room, options, {2, .5, 1.2}, {.1, 1, -.2}, 0, 512);
}

// A lamp 2 km away, with a lid 2 cm before it.
TEST_CASE("a lid near a lamp far away hides it") {
    const std::string text =
        "void light l 0 0 3 1e6 1e6 1e6\nl polygon lamp 0 0 12 0 0 2000 0 1 2000 1 1 2000 1 0 2000\n"
        "void plastic p 0 0 5 .5 .5 .5 0 0\np polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n";
    const std::string lid = "p polygon lid 0 0 12 -1 -1 1999.98 2 -1 1999.98 2 2 1999.98 -1 2 1999.98\n";
    const double lit = .5 / pi * 1e6 / (2000. * 2000);
    expect(text, direct_only(), {{.4, .3, 1}, {0, .1, -1}}, {lit}, 4096);
    expect(text + lid, direct_only(), {{.4, .3, 1}, {0, .1, -1}}, {0}, 4096);
}

TEST_CASE("the origin of the tables lies where most surfaces are, or near an eye that is far from them") {
    const auto centre = [](const std::string& text, const Vec3* eye) {
        flatten::Options options;
        if (eye != nullptr) options.eye = *eye;
        return flatten::flatten(scene_of("void plastic p 0 0 5 .5 .5 .5 0 0\n" + text), options, {}).centre;
    };
    const std::string room = "!genbox p room 4 3 2.7 -i\n",
                      far = "!genbox p f 4 3 2.7 -i | xform -t 450000 5400000 0\n";
    CHECK(centre(room, nullptr) == Vec3{0, 0, 0});
    CHECK(length(centre(far, nullptr) - Vec3{450002, 5400001.5, 1.35}) < 4);
    CHECK(centre(far + stray, nullptr) == centre(far, nullptr));
    const Vec3 there{450002, 5400001, 1}, here{1, 1, 1};
    CHECK(length(centre(room + room + far, &there) - there) < 1024);
    CHECK(centre(room + room + far, &here) == Vec3{0, 0, 0});
    std::string city;
    for (int i = 0; i < 16; i++)
        city += fmt::format("!genbox p b{} 40 40 30 | xform -t {} {} 0\n", i, i % 4 * 1000 - 2000, i / 4 * 1000 - 2000);
    const Vec3 desk{1701, 1701, 1};
    std::string details;  // enough of the size of a room
    for (int i = 0; i < 12; i++) details += fmt::format("!genbox p d{} .5 .5 .5 | xform -t {} 1700 0\n", i, 1700 + i);
    CHECK(length(centre(city + details, &desk) - desk) < 200);
    CHECK(centre(city + details, &here) == Vec3{0, 0, 0});
}
