// SPDX-License-Identifier: BSD-3-Clause
// ptrace -pixel: its contributions sum to the pixel of the frames, by every sampling, in scenes of every material; and
// surfaces, materials and lights have their names.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <set>

#include "parity/options_of.h"
#include "render/focus.h"
#include "render/pixel_text.h"
#include "unit/renderer.h"
#include "unit/temp_folder.h"

namespace {

constexpr int size = 32;

struct Picture {
    scene::Scene scene;
    std::unique_ptr<render::Renderer> renderer;
};

Picture picture_of(Options opt, const render::Focus& focus = {}) {
    opt.render.names = true;
    Picture p{scene::read_scene(opt.scene_files, opt.files), nullptr};
    const render::RenderView view{opt.views.at(0).render_view.view, size, size, focus};
    p.renderer = std::make_unique<render::Renderer>(p.scene, view, opt.render, "cpu", opt.files);
    return p;
}

// The sum of these frames by Eq. 7, or their mean where frame 0 is not among them.
device::Rgb rendered(const Picture& p, int x, int y, int64_t first, int64_t last) {
    device::Rgb zero{}, rest{};
    const double count = double(last - std::max<int64_t>(first, 1) + 1);
    p.renderer->frames(first, last - first + 1, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        for (size_t c = 0; c < 3; c++) {
            const double value = double(rgb[3 * (size_t(size - 1 - y) * size + size_t(x)) + c]);
            (k == 0 ? zero : rest)[c] += k == 0 ? value : value / count;
        }
        return true;
    });
    for (size_t c = 0; c < 3; c++) zero[c] += rest[c];
    return zero;
}

void expect_sums(const Picture& p, int64_t first, int64_t last, int& lit) {
    for (const auto& place : {std::pair{5, 9}, {16, 16}, {14, 26}}) {
        const int x = place.first, y = place.second;
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(first);
        CAPTURE(last);
        const device::Rgb want = rendered(p, x, y, first, last);
        double magnitude = 0;  // of all that is summed: frames k >= 1 take frame 0's samples away
        render::PixelSums sums;
        p.renderer->explain(p.scene, x, y, first, last, [&](const render::PixelRow& row) {
            sums.add(row);
            for (const double v : row.rgb) magnitude += std::fabs(v);
            if (!row.light.empty() || row.rgb == device::Rgb{}) return;
            FAIL("light without a name");
        });
        for (size_t c = 0; c < 3; c++) CHECK(std::fabs(sums.all[c] - want[c]) <= 1e-5 * magnitude);
        lit += magnitude > 0;
    }
}

}  // namespace

TEST_CASE("the contributions sum to the pixel of the frames") {
    const std::vector<std::array<std::string, 2>> scenes = {
        {"examples/scenes/office", "-vf view.vf -ab 5 materials.rad layout.rad blinds.rad sky_1100.rad"},
        {"examples/scenes/classroom",
         "-vf back_row.vf materials.rad room.rad furniture.rad ceiling_lights.rad outside.rad sky_afternoon.rad"},
        {"examples/scenes/gallery", "-vf east.vf -ab 3 -av .1 .1 .1 materials.rad room.rad objects.rad sky_noon.rad"},
        {"tests/golden/lamps", "-vtv -vp 0 -1.5 1.6 -vd 0 1 -.25 -vh 90 -vv 90 -ab 3 mist.rad"},
        {"tests/golden/lamps", "-vtv -vp 3 1 1.6 -vd .6 1 -.15 -vh 70 -vv 70 -ab 2 -av 1 2 3 -me .1 .1 .1 hall.rad"},
        {"tests/golden/chains", "-vp 3.7 .4 1.6 -vd -.8 .7 -.15 -vh 90 -vv 90 -ab 3 -dj .5 room.rad"},
        {"tests/golden/every", "-vtv -vp 0 -14 10 -vd 0 1 -.7 every.rad"},
        {"tests/golden/suite", "-vf down.vf mirror_box.rad"},
        {"tests/golden/mirrors", "-vta -vp 0 0 1.5 -vd 0 1 0 -vh 180 -vv 180 -ab 2 street.rad"}};
    for (const auto& scene : scenes)
        for (const std::string sampling : {"plain", "portals", "reuse"}) {
            const std::string &folder = scene[0], &arguments = scene[1];
            CAPTURE(folder);
            CAPTURE(arguments);
            CAPTURE(sampling);
            REQUIRE(chdir((LUXPIPE_TESTS "/../" + folder).c_str()) == 0);
            const Picture p = picture_of(parity::options_of("-sampling " + sampling + " " + arguments, size));
            int lit = 0;
            expect_sums(p, 3, 3, lit);
            expect_sums(p, 12, 12, lit);
            expect_sums(p, 36, 36, lit);  // above m = 32
            if (sampling == "reuse") expect_sums(p, 0, 0, lit), expect_sums(p, 30, 34, lit);
            CHECK(lit >= 3);
        }
}

TEST_CASE("with a focus, without noisy pixels, with an odd number of samples in frame 0") {
    REQUIRE(chdir(LUXPIPE_TESTS "/../examples/scenes/office") == 0);
    const Options opt = parity::options_of("-vf view.vf -noisy-share 0 materials.rad layout.rad sky_1100.rad", size);
    render::Focus focus(1);
    focus[0].spp = 4;
    for (uint32_t i = 0; i < size * size / 4; i++) focus[0].pixels.push_back(4 * i);
    int lit = 0;
    expect_sums(picture_of(opt, focus), 0, 4, lit);
    Options odd = opt;
    odd.render.direct_samples = 3;
    expect_sums(picture_of(odd), 0, 5, lit);
    CHECK(lit >= 5);
}

TEST_CASE("the parts of each light sum to the variance inside the pixel") {
    int uneven = 0, drawn = 0;
    for (const auto& [folder, arguments] : std::vector<std::array<std::string, 2>>{
             {"examples/scenes/gallery", "-vf east.vf materials.rad room.rad objects.rad sky_noon.rad"},
             {"tests/golden/lamps", "-vtv -vp 3 1 1.6 -vd .6 1 -.15 -vh 70 -vv 70 -ab 2 hall.rad"}}) {
        REQUIRE(chdir((LUXPIPE_TESTS "/../" + folder).c_str()) == 0);
        const Picture p = picture_of(parity::options_of(arguments, size));
        const image::Moments moments = p.renderer->moments();
        std::vector<size_t> some;
        for (size_t i = 0; i < size * size; i++)
            if ((*moments)[image::moment_numbers * i] > 0) some.push_back(i);
        for (size_t k = 0; k < some.size(); k += 1 + some.size() / 8) {
            CAPTURE(some[k]);
            const float* want = &(*moments)[image::moment_numbers * some[k]];
            const render::MomentReport got =
                p.renderer->explain_moments(p.scene, int(some[k] % size), size - 1 - int(some[k] / size));
            double sum = 0, magnitude = 0;
            for (const auto& [light, v] : got.variance_by_light) sum += v, magnitude += std::fabs(v);
            CHECK(std::fabs(sum - double(want[image::moment_variance])) <= 1e-5 * magnitude);
            for (size_t i = 0; i < image::moment_numbers; i++) CHECK(got.moments[i] == double(want[i]));
            uneven++, drawn += int(got.variance_by_light.count("drawn by area"));
        }
    }
    CHECK(uneven > 10);
    CHECK(drawn < uneven);
}

TEST_CASE("surfaces, materials and lights are named with their places") {
    TempFolder folder;
    const std::string obj = folder.holding(
                          "box.obj", "v -1 0 0\nv 1 0 0\nv 0 0 1\nv 0 0 -1\nusemtl red\nf 1 2 3\ng foot\nf 1 4 2\n"),
                      inner = folder.holding("inner.rad",
                                             "void plastic inside 0 0 5 .5 .5 .5 0 0\n"
                                             "inside polygon part 0 0 9 -1 0 0 1 0 0 0 0 1\n"),
                      rad = folder.holding("scene.rad",
                                           "void glow bright 0 0 4 1 1 1 0\n"
                                           "bright source dome 0 0 4 0 0 1 360\n"
                                           "void plastic red 0 0 5 .5 .1 .1 0 0\n"
                                           "void mirror silver 0 0 3 .9 .9 .9\n"
                                           "red polygon wall 0 0 12 -9 3 -9 -5 3 -9 -5 3 9 -9 3 9\n"
                                           "\n"
                                           "red sphere ball\n0 0 4 -3 3 0 1\n"
                                           "void mesh figure 1 " +
                                               obj +
                                               " 0 0\n"
                                               "void instance chair 5 " +
                                               inner +
                                               " -t 4 2 0 0 0\n"
                                               "silver polygon glass 0 0 12 6 3 -9 9 3 -9 9 3 9 6 3 9\n");
    Options opt = parity::options_of("-vtl -vp 0 -20 0 -vd 0 1 0 -vh 16 -vv 16 " + rad, size);
    const Picture p = picture_of(opt);
    struct Seen {
        int x;  // pixel, half a unit each
        std::string surface, material, place, next;
        int y = 16;
    };
    for (const Seen& want : {Seen{4, "wall", "red", rad + ":5", ""}, Seen{10, "ball", "red", rad + ":7", ""},
                             Seen{16, "figure", "red", rad + ":9", ""}, Seen{16, "foot", "red", obj + ":7", "", 15},
                             Seen{24, "part", "inside", inner + ":2", ""},
                             Seen{30, "glass", "silver", rad + ":11", "dome"}, Seen{20, "", "", "", ""}}) {
        CAPTURE(want.x);
        std::vector<render::PixelRow> rows;
        p.renderer->explain(p.scene, want.x, want.y, 0, 0, [&](const render::PixelRow& row) { rows.push_back(row); });
        REQUIRE(!rows.empty());
        CHECK(rows[0].surface == want.surface);
        CHECK(rows[0].material == want.material);
        CHECK(rows[0].place == want.place);
        if (want.surface.empty()) {
            CHECK(rows[0].light == "dome");
            continue;
        }
        CHECK(std::abs(rows[0].point[0] - ((want.x + .5) / 2 - 8)) < .2501);  // in the pixel
        if (want.next.empty()) continue;
        CHECK(rows[0].lobe == "mirror");
        CHECK(rows[0].weight[0] == doctest::Approx(1. / 32));
        CHECK(rows[1].light == "dome");
        CHECK(rows[1].weight[0] == doctest::Approx(.9 / 32));
        CHECK(rows[1].rgb[0] == doctest::Approx(.9 / 32));
    }
}
