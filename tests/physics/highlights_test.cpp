// SPDX-License-Identifier: BSD-3-Clause
// The sun's highlight on a polished floor lights a wall: aiming at it takes noise away and moves no mean, and every
// device does the same.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include "physics/blocks.h"
#include "physics/seeds.h"

using namespace laws;

namespace {

const std::string scene_text =
    "void light sun_light 0 0 3 1e4 1e4 1e4\nsun_light source sun 0 0 4 .2 -.6 1 .5333\n"
    "void plastic polished 0 0 5 .2 .2 .2 .05 .04\npolished polygon floor 0 0 12 -3 -3 0 3 -3 0 3 3 0 -3 3 0\n"
    "void plastic white 0 0 5 .7 .7 .7 0 0\nwhite polygon wall 0 0 12 -3 3 0 3 3 0 3 3 3 -3 3 3\n"
    "white polygon shade 0 0 12 -1 -1 1 -1 1 1 1 1 1 1 -1 1\n";

// A window, and inside it a narrow sill of rough metal, in which the sun is mirrored to the ceiling and the far wall.
const std::string sill_text =
    "void light sun_light 0 0 3 1e5 1e5 1e5\nsun_light source sun 0 0 4 .1 -.9 .35 .5333\n"
    "void plastic white 0 0 5 .7 .7 .7 0 0\nwhite polygon wall 0 0 12 -3 3 0 3 3 0 3 3 3 -3 3 3\n"
    "white polygon floor 0 0 12 -3 -3 0 3 -3 0 3 3 0 -3 3 0\nwhite polygon ceiling 0 0 12 -3 -3 3 3 -3 3 3 3 3 -3 3 3\n"
    "white polygon left 0 0 12 -3 -3 0 -3 3 0 -3 3 3 -3 -3 3\nwhite polygon right 0 0 12 3 -3 0 3 3 0 3 3 3 3 -3 3\n"
    "white polygon below 0 0 12 -3 -3 0 3 -3 0 3 -3 1 -3 -3 1\nwhite polygon above 0 0 12 -3 -3 2.5 3 -3 2.5 3 -3 3 -3 "
    "-3 3\n"
    "white polygon beside 0 0 12 -3 -3 1 -1 -3 1 -1 -3 2.5 -3 -3 2.5\n"
    "white polygon beside2 0 0 12 1 -3 1 3 -3 1 3 -3 2.5 1 -3 2.5\n"
    "void glass clear 0 0 3 .96 .96 .96\nclear polygon pane 0 0 12 -1 -3 1 1 -3 1 1 -3 2.5 -1 -3 2.5\n"
    "void metal brushed 0 0 5 .6 .6 .6 .7 .12\nbrushed polygon sill 0 0 12 -1 -3 1.001 1 -3 1.001 1 -2.95 1.001 -1 "
    "-2.95 1.001\n";

view::View toward_wall() {
    view::View view;
    view.vp = {0, -2, 1.5};
    view.vd = {0, 1, 0};
    view.vh = view.vv = 70;
    return view;
}

constexpr int size = 16, blocks = 16, seeds = 16, frames = 64;

// Means of frames 1 .. 64, of each block of 4 x 4 pixels and, last, of the picture.
Means means_of(const scene::Scene& scene, render::Sampling sampling) {
    return over_seeds(seeds, blocks + 1, [&](uint64_t seed) {
        render::RenderOptions options;
        options.sampling = sampling;
        options.seed = seed;
        options.ab = 2;
        options.direct_samples = (1 << 20) + 1;  // odd: frames of the diffuse class alone
        options.more_if_small = false;
        render::Renderer renderer(scene, toward_wall(), size, size, options, "cpu", {});
        return block_means(renderer, size, 4, 1, frames);
    });
}

}  // namespace

TEST_CASE("aiming at highlights takes noise away and moves no mean") {
    const scene::Scene scene = scene_of(scene_text);
    const Means plain = means_of(scene, render::Sampling::plain);
    const Means aimed = means_of(scene, render::Sampling::portals);
    for (size_t i = 0; i <= blocks; i++) {
        CAPTURE(i);
        CHECK(std::abs(aimed.mean[i] - plain.mean[i]) <= 4.5 * std::sqrt(aimed.variance[i] + plain.variance[i]));
    }
    CHECK(aimed.variance[blocks] < .3 * plain.variance[blocks]);
    CHECK(std::sqrt(aimed.variance[blocks]) < .01 * aimed.mean[blocks]);
}

TEST_CASE("aiming at a polished sill takes noise away and moves no mean") {
    const scene::Scene scene = scene_of(sill_text);
    const Means plain = means_of(scene, render::Sampling::plain), aimed = means_of(scene, render::Sampling::portals);
    double before = 0, now = 0;
    for (size_t i = 0; i <= blocks; i++) {
        CAPTURE(i);
        CHECK(std::abs(aimed.mean[i] - plain.mean[i]) <= 4.5 * std::sqrt(aimed.variance[i] + plain.variance[i]));
        before += plain.variance[i];
        now += aimed.variance[i];
    }
    CHECK(now < .5 * before);  // with windows and patches alone it is what it was
}

TEST_CASE("every device aims alike") {
    const scene::Scene scene = scene_of(scene_text);
    std::vector<float> first, other;
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer renderer(scene, toward_wall(), size, size, {}, device, {});
        renderer.frame(3, first.empty() ? first : other);
        if (!other.empty()) CHECK(first == other);
    }
}
