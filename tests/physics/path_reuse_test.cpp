// SPDX-License-Identifier: BSD-3-Clause
// Path reuse (-sampling reuse): every pixel has its sample, the expectation is that of plain sampling for suffix
// vertices of every material, and a suffix vertex whose radiance depends on the direction is not reused.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"

#include <numeric>
#include <set>

#include "physics/blocks.h"
#include "physics/seeds.h"

using namespace laws;

namespace {

constexpr int size = 32, blocks = 16;

// A room in the sun, behind a pane; all that light can come from over one bounce: matt, polished and mirrored
// surfaces, some of them only half there or bent by textures, a lit panel, the ground and the sky behind the pane.
const char* const room =
    "void light sun_light 0 0 3 2e4 2e4 2e4\nsun_light source sun 0 0 4 .3 -1 .8 .5333\n"
    "void glow bright 0 0 4 9 9 12 0\nbright source sky 0 0 4 0 0 1 180\n"
    "void plastic matt 0 0 5 .7 .6 .5 0 0\nvoid plastic polished 0 0 5 .3 .3 .4 .05 .1\n"
    "void plastic shiny 0 0 5 .3 .5 .3 .06 0\nvoid metal steel 0 0 5 .6 .6 .6 .9 .1\n"
    "void trans paper 0 0 7 .6 .6 .6 0 0 .5 .2\nvoid glass pane 0 0 3 .8 .9 .8\n"
    "void mixfunc half 4 matt void .5 .\n0 0\n"
    "void texfunc bumps 4 .1*cos(9*Px) 0 .1*cos(9*Py) .\n0 0\nbumps plastic rough_plaster 0 0 5 .5 .5 .6 0 0\n"
    "void brightfunc looks 2 .5+.5*abs(Rdot) .\n0 0\nlooks plastic velvet 0 0 5 .6 .3 .3 0 0\n"
    "void glow panel 0 0 4 3 3 2 0\nvoid glow near_panel 0 0 4 5 5 5 2\n"
    "matt polygon ground 0 0 12 -20 -20 -.1 20 -20 -.1 20 20 -.1 -20 20 -.1\n"
    "polished polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n"
    "matt polygon ceiling 0 0 12 -2 -2 3 -2 2 3 2 2 3 2 -2 3\n"
    "velvet polygon left 0 0 12 -2 -2 0 -2 2 0 -2 2 3 -2 -2 3\n"
    "rough_plaster polygon right 0 0 12 2 -2 0 2 -2 3 2 2 3 2 2 0\n"
    "matt polygon back 0 0 12 -2 2 0 2 2 0 2 2 3 -2 2 3\n"
    "matt polygon sill 0 0 12 -2 -2 0 -2 -2 1 2 -2 1 2 -2 0\n"
    "pane polygon window 0 0 12 -2 -2 1 -2 -2 3 2 -2 3 2 -2 1\n"
    "panel polygon screen 0 0 12 -1.9 1 1 -1.9 1.5 1 -1.9 1.5 1.5 -1.9 1 1.5\n"
    "near_panel polygon lamp 0 0 12 1.9 1 2 1.9 1.5 2 1.9 1.5 2.5 1.9 1 2.5\n"
    "shiny polygon table 0 0 12 -1 0 .7 1 0 .7 1 1.5 .7 -1 1.5 .7\n"
    "paper polygon sheet 0 0 12 .5 0 1 .5 1 1 .5 1 1.6 .5 0 1.6\n"
    "half polygon net 0 0 12 -1.2 -1 1 -.2 -1 1 -.2 -1 2 -1.2 -1 2\n"
    "steel sphere ball 0 0 4 -.6 .6 1 .3\n";

view::View into_room() {
    view::View view;
    view.vp = {0, -1.5, 1.6};
    view.vd = {0, 1, -.25};
    view.vh = view.vv = 90;
    return view;
}

// Means of frames 1 .. n, of each of 4 x 4 blocks and, last, of the picture.
Means means_of(const scene::Scene& scene, render::Sampling sampling, int frames) {
    return over_seeds(16, blocks + 1, [&](uint64_t seed) {
        render::RenderOptions options;
        options.sampling = sampling;
        options.seed = seed + (sampling == render::Sampling::reuse ? 100 : 0);
        options.direct_samples = (1 << 20) + 1;  // odd: frames of the diffuse class alone
        options.more_if_small = false;
        options.noisy_share = 0;  // and of one sample each
        render::Renderer renderer(scene, into_room(), size, size, options, "cpu", {});
        return block_means(renderer, size, 4, 1, frames);
    });
}

// Mean over pixels of the squared difference of two seeds' frames, over the squared mean.
double noise_of(const scene::Scene& scene, render::Sampling sampling) {
    std::vector<float> a, b;
    double squares = 0, sum = 0;
    render::RenderOptions options;
    options.noisy_share = 0;
    options.sampling = sampling;
    render::Renderer one(scene, into_room(), size, size, options, "cpu", {});
    options.seed = 2;
    render::Renderer two(scene, into_room(), size, size, options, "cpu", {});
    for (int64_t k = 1; k <= 8; k++) {
        one.frame(k, a);
        two.frame(k, b);
        for (size_t i = 1; i < a.size(); i += 3) {
            squares += std::pow(std::min(std::abs(double(a[i]) - double(b[i])), 100.0), 2);
            sum += a[i] + b[i];
        }
    }
    return squares / (sum * sum);
}

// One frame of a scene, and is it that of rays toward windows, which reuse nothing?
bool reuses_nothing(const std::string& text, render::RenderOptions options = {}) {
    const scene::Scene scene = scene_of(text);
    std::vector<float> frames[2];
    options.noisy_share = 0;
    for (const auto sampling : {render::Sampling::reuse, render::Sampling::portals}) {
        options.sampling = sampling;
        render::Renderer renderer(scene, into_room(), size, size, options, "cpu", {});
        renderer.frame(1, frames[sampling == render::Sampling::reuse]);
    }
    CHECK(std::accumulate(frames[0].begin(), frames[0].end(), 0.0) != 0);
    return frames[0] == frames[1];
}

// A floor and a wall of a material named "it", in the sun.
std::string corner(const std::string& it) {
    return "void light sun_light 0 0 3 2e4 2e4 2e4\nsun_light source sun 0 0 4 .3 -1 .8 .5333\n" + it +
           "it polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\nit polygon back 0 0 12 -2 2 0 2 2 0 2 2 3 -2 2 3\n";
}

const std::string matt = "void plastic it 0 0 5 .5 .5 .5 0 0\n";

}  // namespace

TEST_CASE("each pixel has one path of a sample, and each path its place in its group") {
    using namespace kernels;
    for (const auto& [nx, ny] : {std::pair{1u, 1u}, std::pair{17u, 5u}, std::pair{64u, 48u}}) {
        Params par{};
        par.nx = nx;
        par.ny = ny;
        par.reuse_path_count = reuse_paths(nx, ny);
        for (uint32_t sample = 0; sample < 3; sample++) {
            std::set<uint32_t> pixels;
            for (uint32_t path = 0; path < par.reuse_path_count; path++) {
                const uint32_t gid = sample * par.reuse_path_count + path, pixel = reuse_pixel(&par, gid);
                if (pixel != NONE) CHECK(pixels.insert(pixel).second);
                CHECK(reuse_member(gid, reuse_which(gid)) == gid);
                for (uint32_t m = 0; m < REUSE_GROUP; m++) {
                    const uint32_t member = reuse_member(gid, m);
                    CHECK(member / REUSE_SQUARE == gid / REUSE_SQUARE);
                    CHECK(reuse_member(member, reuse_which(gid)) == gid);
                }
                std::set<uint32_t> met;  // by the rounds of many hours
                for (uint32_t round = 0; round < REUSE_GROUPS; round++) {
                    par.reuse_turn = REUSE_FIRST(round);
                    const uint32_t other = REUSE_MET(&par, gid);
                    CHECK(met.insert(other).second);
                    CHECK(other / REUSE_SQUARE == gid / REUSE_SQUARE);
                    CHECK(reuse_which(other) == reuse_which(gid));
                    CHECK(REUSE_MET(&par, other) == gid);
                }
                par.reuse_turn = 0;
            }
            CHECK(pixels.size() == nx * ny);
            CHECK(*pixels.rbegin() == nx * ny - 1);
        }
    }
}

TEST_CASE("path reuse removes noise and moves no mean") {
    const scene::Scene scene = scene_of(room);
    const Means plain = means_of(scene, render::Sampling::plain, 400);
    const Means reuse = means_of(scene, render::Sampling::reuse, 400);
    double square = 0;
    for (size_t i = 0; i <= blocks; i++) {
        const double z = (reuse.mean[i] - plain.mean[i]) / std::sqrt(reuse.variance[i] + plain.variance[i]);
        CAPTURE(i);
        CHECK(std::abs(z) < 4.5);
        if (i < blocks) square += z * z / blocks;
    }
    CHECK(square < 2.2);
    CHECK(std::sqrt(plain.variance[blocks] + reuse.variance[blocks]) < .004 * plain.mean[blocks]);
    CHECK(noise_of(scene, render::Sampling::reuse) < .4 * noise_of(scene, render::Sampling::plain));
}

TEST_CASE("a surface that looks different from elsewhere is not reused") {
    CHECK(!reuses_nothing(corner(matt)));
    CHECK(!reuses_nothing(corner("void brightfunc stripes 2 .5+.4*cos(9*Px) .\n0 0\nstripes " + matt.substr(5))));
    for (const char* seen : {"Rdot", "abs(Dz)", "T/9", "Ts/9"}) {
        CAPTURE(seen);
        const std::string looks = std::string("void brightfunc looks 2 .5+.5*") + seen + " .\n0 0\n";
        CHECK(reuses_nothing(corner(looks + "looks " + matt.substr(5))));
        CHECK(reuses_nothing(corner(
            looks + "void brightfunc plain 2 .9 .\n0 0\nlooks brightfunc over 2 .8 .\n0 0\nover " + matt.substr(5))));
        CHECK(reuses_nothing(corner(looks + "void mixfunc both 4 looks void .5 .\n0 0\nboth " + matt.substr(5))));
    }
    CHECK(reuses_nothing(corner("void plastic it 0 0 5 .5 .5 .5 .05 0\n")));  // Fresnel
    CHECK(reuses_nothing(corner("void texfunc bumps 4 .1*cos(9*Px) 0 .1*cos(9*Py) .\n0 0\nbumps " + matt.substr(5))));
    CHECK(reuses_nothing(corner("void ashik2 it 4 1 0 0 .\n0 8 .5 .5 .5 .1 .1 .1 30 30\n")));
}

// A floor under a sky of the corner's room.
std::string open_floor(const std::string& sky, const std::string& above) {
    return sky + "it source sky 0 0 4 0 0 1 360\n" + "void plastic matt 0 0 5 .5 .5 .5 0 0\n" +
           "matt polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n" + above;
}

TEST_CASE("a sky that looks different from place to place is not reused") {
    const std::string glow = "glow it 0 0 4 9 9 9 0\n";
    CHECK(!reuses_nothing(open_floor("void " + glow, "")));
    CHECK(!reuses_nothing(open_floor("void brightfunc seen 2 2+Dz .\n0 0\nseen " + glow, "")));
    CHECK(reuses_nothing(open_floor("void brightfunc seen 2 2+Px .\n0 0\nseen " + glow, "")));
}

TEST_CASE("connections are blocked by panes that pass no path, or that depend on the distance to the eye") {
    const std::string pane = "seen glass pane 0 0 3 .9 .9 .9\npane polygon p 0 0 12 -3 -3 1 3 -3 1 3 3 1 -3 3 1\n";
    for (const char* seen : {"if(sin(6*Px)*sin(6*Py),-.5,1)", "1/(1+T)", "1/(1+Ts)"}) {
        CAPTURE(seen);
        const std::string pattern = std::string("void brightfunc seen 2 ") + seen + " .\n0 0\n";
        const scene::Scene scene = scene_of(open_floor("void glow it 0 0 4 10 10 10 0\n", pattern + pane));
        const Means plain = means_of(scene, render::Sampling::plain, 60);
        const Means reuse = means_of(scene, render::Sampling::reuse, 60);
        const double error = std::sqrt(reuse.variance[blocks] + plain.variance[blocks]);
        CHECK(error < .01 * plain.mean[blocks]);
        CHECK(std::abs(reuse.mean[blocks] - plain.mean[blocks]) < 4 * error);
    }
}

// The mist fills a part of the room only: paths whose suffix vertices lie before it go on into it.
TEST_CASE("light that a mist scatters is added once, whatever the suffix vertex has received") {
    const scene::Scene scene = scene_of(
        "void light bulb 0 0 3 60 60 60\nbulb sphere lamp 0 0 4 1.5 -1 2.5 .1\n"
        "void plastic matt 0 0 5 .7 .7 .7 0 0\n"
        "matt polygon floor 0 0 12 -2 -2 0 2 -2 0 2 2 0 -2 2 0\n"
        "matt polygon back 0 0 12 -2 2 0 2 2 0 2 2 3 -2 2 3\n"
        "matt polygon left 0 0 12 -2 -2 0 -2 2 0 -2 2 3 -2 -2 3\n"
        "void mist fog 1 lamp 0 7 .2 .2 .2 .9 .9 .9 .3\nfog sphere cloud 0 0 4 0 .8 1 .7\n");
    const Means plain = means_of(scene, render::Sampling::plain, 100);
    const Means reuse = means_of(scene, render::Sampling::reuse, 100);
    const double error = std::sqrt(reuse.variance[blocks] + plain.variance[blocks]);
    CAPTURE(plain.mean[blocks]);
    CAPTURE(reuse.mean[blocks]);
    CAPTURE(error);
    CHECK(error < .004 * plain.mean[blocks]);
    CHECK(std::abs(reuse.mean[blocks] - plain.mean[blocks]) < 4 * error);
}

TEST_CASE("no path reuse in mist, or where paths end by their weight") {
    render::RenderOptions options;
    options.lr = 3;
    CHECK(reuses_nothing(corner(matt), options));
    options = {};
    options.me[0] = options.me[1] = options.me[2] = .01;
    const std::string bulb = "void light lamp 0 0 3 50 50 50\nlamp sphere bulb 0 0 4 0 0 2.5 .1\n";
    CHECK(reuses_nothing(corner(matt) + bulb, options));  // no sun is left
    CHECK(reuses_nothing(corner(matt) + "void antimatter hole 1 it 0 0\nhole sphere hollow 0 0 4 9 9 9 .1\n"));
}

// A square of paths for each sample of a few pixels would be a thousand times the memory, and time.
TEST_CASE("pictures smaller than a square reuse nothing") {
    const scene::Scene scene = scene_of(room);
    std::vector<float> frames[2];
    for (const auto sampling : {render::Sampling::reuse, render::Sampling::portals}) {
        render::RenderOptions options;
        options.sampling = sampling;
        options.noisy_share = 0;
        render::Renderer renderer(scene, into_room(), 32, 15, options, "cpu", {});
        renderer.frame(1, frames[sampling == render::Sampling::reuse]);
    }
    CHECK(frames[0] == frames[1]);
}

TEST_CASE("every device reuses alike") {
    const scene::Scene scene = scene_of(room);
    std::vector<float> first, other;
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer renderer(scene, into_room(), size, size, {}, device, {});
        renderer.frame(3, first.empty() ? first : other);
        if (!other.empty()) CHECK(first == other);
    }
}
