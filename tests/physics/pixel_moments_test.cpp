// SPDX-License-Identifier: BSD-3-Clause
// Moments of the light inside of each pixel (pixel_moments.h): closed forms of what lies in a pixel, and what is random
// at a single place of it, which is noise and no structure.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include "image/grey.h"
#include "image/picture.h"

using namespace laws;

namespace {

constexpr int side = 64;

// A square perspective view along +y from the origin; pixels of a plane at distance 1 are 1/64 wide.
view::View straight_on() {
    view::View v;
    v.type = 'v';
    v.vd = {0, 1, 0}, v.vu = {0, 0, 1};
    v.vh = v.vv = 2 * std::atan(.5) * 180 / pi;
    return v;
}

struct Seen {
    std::vector<float> mean, moments;  // grey of frame 0; as image::Picture has them
    double variance(int x, int y) const { return moments[image::moment_numbers * at(x, y)]; }
    double number(int x, int y, size_t k) const { return moments[image::moment_numbers * at(x, y) + k]; }
    // The share of the pixel that light of one luminance fills.
    double filled(int x, int y) const {
        const double m = mean[at(x, y)], v = variance(x, y);
        return m * m / (m * m + v);
    }
    static size_t at(int x, int y) { return size_t(side - 1 - y) * side + size_t(x); }  // y from the bottom
};

Seen seen(const std::string& text, const view::View& view = straight_on(), uint64_t seed = 1) {
    render::RenderOptions options = direct_only();
    options.seed = seed;
    render::Renderer renderer(scene_of(text), view, side, side, options, "cpu", {});
    std::vector<float> rgb;
    renderer.frame(0, rgb);
    return {image::grey_of(rgb), *renderer.moments()};
}

const std::string sky = "void glow sky_light 0 0 4 20 20 20 0\nsky_light source sky 0 0 4 0 1 0 360\n";

// Mean share filled of a block of pixels.
double mean_filled(const Seen& s, int from, int to) {
    double sum = 0;
    for (int y = from; y < to; ++y)
        for (int x = from; x < to; ++x) sum += s.filled(x, y) / ((to - from) * (to - from));
    return sum;
}

}  // namespace

// A glow of radiance 100 from x = 0.3 pixels right of a pixel's left edge on: a share c = .7 of pixel 40.
TEST_CASE("an edge across a pixel: c (1 - c) L^2") {
    const double from = (40.3 - 32) / side;
    const Seen s = seen("void glow bright 0 0 4 100 100 100 -1\nbright polygon half 0 0 12 " + std::to_string(from) +
                        " 1 -2  2 1 -2  2 1 2  " + std::to_string(from) + " 1 2\n");
    double sum = 0;
    for (int y = 0; y < side; ++y) {
        CHECK(s.variance(40, y) == doctest::Approx(.21 * 1e4).epsilon(.05));
        sum += s.variance(40, y) / side;
        CHECK(s.variance(39, y) == 0);
        CHECK(s.variance(41, y) == 0);
        CHECK(s.filled(41, y) == 1);
        CHECK(std::abs(s.number(40, y, image::moment_difference)) < .1 * 2100);
    }
    CHECK(sum == doctest::Approx(.21 * 1e4).epsilon(.01));
}

// Through a pane light is transmitted or mirrored by chance.
TEST_CASE("a pane before a sky fills its pixels") {
    const Seen s =
        seen(sky + "void glass clear 0 0 3 .96 .96 .96\nclear polygon pane 0 0 12 -2 1 -2 2 1 -2 2 1 2 -2 1 2\n");
    CHECK(mean_filled(s, 0, side) == doctest::Approx(1).epsilon(.001));
}

// An emitter of one by one above a plate throws the soft shadow of a beam on a floor; each sample takes one place of
// it.
TEST_CASE("a penumbra fills its pixels") {
    const Seen s = seen(
        "void light lamp 0 0 3 500 500 500\n"
        "lamp polygon ceiling 0 0 12 -1 .5 3 -1 2.5 3 1 2.5 3 1 .5 3\n"
        "void plastic grey 0 0 5 .5 .5 .5 0 0\n"
        "grey polygon floor 0 0 12 -9 .2 -.5 9 .2 -.5 9 9 -.5 -9 9 -.5\n"
        "grey polygon beam 0 0 12 -9 1 1.2 -9 1.4 1.2 9 1.4 1.2 9 1 1.2\n");
    CHECK(mean_filled(s, 12, 24) == doctest::Approx(1).epsilon(.01));
}

TEST_CASE("a rough metal before a sky fills its pixels") {
    const Seen s = seen(sky +
                        "void metal rough 0 0 5 .7 .7 .7 .9 .2\n"
                        "rough polygon plate 0 0 12 -2 1.5 -2 2 1 -2 2 1 2 -2 1.5 2\n");
    CHECK(mean_filled(s, 0, side) == doctest::Approx(1).epsilon(.01));
}

// A pane that scatters light by measured data: which way light comes through it is chosen by chance.
TEST_CASE("a BSDF before a sky fills its pixels") {
    for (const std::string name : {"klemsq", "peak", "tt3", "tt4"}) {
        CAPTURE(name);
        const std::string file = LUXPIPE_TESTS "/golden/vectors/" + name + ".xml";
        const Seen s = seen(sky + "void BSDF data 6 0 " + file + " 0 0 1 . 0 0\n" +
                            "data polygon pane 0 0 12 -2 1 -2 2 1 -2 2 1 2 -2 1 2\n");
        CHECK(s.mean[Seen::at(32, 32)] > .1);
        CHECK(mean_filled(s, 0, side) == doctest::Approx(1).epsilon(.001));
    }
}

// The disc of a sun of half a degree, a tenth of a pixel of a fisheye: c (1 - c) L^2, all of its light in one pixel, at
// its place there.
TEST_CASE("the sun in a pixel") {
    view::View v;
    v.type = 'a';
    v.vd = {0, 1, 0}, v.vu = {0, 0, 1};
    v.vh = v.vv = 180;
    const double pixel = pi / side;  // rad
    for (const double place : {.5, .3}) {
        const double right = 10 + place, up = .5, away = std::hypot(right, up), angle = away * pixel, L = 1e5,
                     half = .25 * pi / 180;
        const std::string dir = std::to_string(std::sin(angle) * right / away) + " " + std::to_string(std::cos(angle)) +
                                " " + std::to_string(std::sin(angle) * up / away);
        const Seen s = seen("void light sun 0 0 3 1e5 1e5 1e5\nsun source disc 0 0 4 " + dir + " .5\n", v);
        // an angular fisheye makes a pixel at that angle smaller by sin(angle)/angle
        const double c = pi * half * half / (pixel * pixel * std::sin(angle) / angle);
        const double m = s.mean[Seen::at(42, 32)];
        CHECK(m == doctest::Approx(c * L).epsilon(.005));
        CHECK(s.filled(42, 32) == doctest::Approx(c).epsilon(.005));
        CHECK(s.number(42, 32, image::moment_right) == doctest::Approx(place - .5).epsilon(.02));
        CHECK(std::abs(s.number(42, 32, image::moment_up)) < .02);
    }
}

TEST_CASE("frames do not depend on whether moments were asked for") {
    const scene::Scene scene = scene_of(sky);
    render::Renderer a(scene, straight_on(), 32, 32, {}, "cpu", {}), b(scene, straight_on(), 32, 32, {}, "cpu", {});
    for (const int k : {0, 1, 9}) {
        std::vector<float> first, second;
        a.frame(k, first);
        b.moments();
        b.frame(k, second);
        CHECK(first == second);
    }
}
