// SPDX-License-Identifier: BSD-3-Clause
// The laws of frames (paper Eq. 7): frame k of a pixel depends on (seed, k, pixel) alone - on no device, no number of
// threads, no range asked for -, and frame 0's own noise averages out.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "physics/laws.h"
#include "physics/office.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "base/processors.h"
#include "physics/blocks.h"
#include "physics/seeds.h"

#include "render/frame_zero.h"
#include "render/learn.h"
#include "render/make_device.h"

using namespace laws;

namespace {

void devices_agree(render::Sampling sampling) {
    const Office scene;
    const int size = 40;
    render::RenderOptions options;
    options.sampling = sampling;
    render::Renderer cpu = scene.renderer("cpu", size, options);
    std::vector<std::vector<float>> mine(20), theirs(20);
    for (int k : {0, 1, 19}) cpu.frame(k, mine[size_t(k)]);
    for (const std::string& device : devices()) {
        CAPTURE(device);
        render::Renderer other = scene.renderer(device, size, options);
        for (int k : {0, 1, 19}) {
            CAPTURE(k);
            other.frame(k, theirs[size_t(k)]);
            const auto &a = mine[size_t(k)], &b = theirs[size_t(k)];
            REQUIRE(a.size() == b.size());
            int different = 0;
            for (size_t i = 0; i < a.size(); i += 3) {
                const float brightest = std::max({std::abs(a[i]), std::abs(a[i + 1]), std::abs(a[i + 2])});
                for (size_t c = i; c < i + 3; ++c)
                    if (std::abs(a[c] - b[c]) > 1e-5f * brightest) {
                        different++;
                        break;
                    }
            }
            CHECK(different <= 1);
            CHECK(luminance_sum(b) == doctest::Approx(luminance_sum(a)).epsilon(1e-3));
        }
    }
}

void ranges_merge(render::Sampling sampling) {
    const Office scene;
    const int size = 24;
    render::RenderOptions options;
    options.sampling = sampling;
    render::Renderer renderer = scene.renderer("cpu", size, options);
    const image::Picture whole = sum_of(renderer, size, 0, 63);
    film::Merger merger;
    for (const auto& range : {std::pair{10, 40}, std::pair{0, 9}, std::pair{41, 63}}) {
        render::Renderer machine = scene.renderer("cpu", size, options);
        merger.add(sum_of(machine, size, range.first, range.second), "part");
    }
    const image::Picture merged = merger.result();
    REQUIRE(merged.rgb.size() == whole.rgb.size());
    double worst = 0;
    for (size_t i = 0; i < whole.rgb.size(); ++i)
        worst =
            std::max(worst, double(std::abs(merged.rgb[i] - whole.rgb[i])) / std::max(1e-3f, std::abs(whole.rgb[i])));
    CHECK(worst < 2e-6);
}

// Means of frames first .. last, of each of 8 x 8 blocks and of the picture, from 16 seeds.
Means means_of(const Office& scene, render::Sampling sampling, int first, int last) {
    const int size = 32;
    return over_seeds(16, 65, [&](uint64_t seed) {
        render::RenderOptions options;
        options.sampling = sampling;
        options.seed = seed;
        options.direct_samples = (1 << 20) + 1;  // odd: frames of the diffuse class alone
        options.more_if_small = false;
        render::Renderer renderer = scene.renderer("cpu", size, options);
        return block_means(renderer, size, 8, first, last);
    });
}

// Median over pixels of the squared difference of two seeds' means of 64 frames, over their squared sum.
double noise_of(const Office& scene, render::Sampling sampling) {
    const int size = 32;
    std::vector<image::Picture> seeds;
    for (const uint64_t seed : {1, 2}) {
        render::RenderOptions options;
        options.sampling = sampling;
        options.seed = seed;
        options.ab = 5;  // the shares below are of the first bounces; later ones have noise that no aim takes away
        render::Renderer renderer = scene.renderer("cpu", size, options);
        seeds.push_back(sum_of(renderer, size, 0, 64));
    }
    std::vector<double> squares;
    for (size_t i = 1; i < seeds[0].rgb.size(); i += 3) {
        const double a = seeds[0].rgb[i], b = seeds[1].rgb[i];
        if (a + b > 0) squares.push_back((a - b) * (a - b) / ((a + b) * (a + b)));
    }
    std::nth_element(squares.begin(), squares.begin() + long(squares.size() / 2), squares.end());
    return squares[squares.size() / 2];
}

// The means of the picture and of its blocks by one way to aim are those by another.
void means_agree(const Means& one, const Means& other) {
    double square = 0;
    for (size_t i = 0; i < 65; i++) {
        const double z = (one.mean[i] - other.mean[i]) / std::sqrt(one.variance[i] + other.variance[i]);
        CAPTURE(i);
        CHECK(std::abs(z) < 4.5);
        if (i < 64) square += z * z / 64;
    }
    CHECK(square < 1.8);
}

}  // namespace

TEST_CASE("devices give the same frames") { devices_agree(render::Sampling::portals); }
TEST_CASE("devices give the same frames with path reuse") { devices_agree(render::Sampling::reuse); }

TEST_CASE("the number of threads changes nothing") {
    const Office scene;
    std::map<unsigned, std::vector<float>> frames;
    render::RenderOptions options;
    for (const auto sampling : {render::Sampling::reuse, render::Sampling::portals}) {
        options.sampling = sampling;
        for (unsigned threads : {1u, 2u, 5u}) {
            base::use_processors(threads);
            render::Renderer renderer = scene.renderer("cpu", 33, options);
            renderer.frame(17, frames[threads]);
        }
        base::use_processors(0);  // as many as there are
        CHECK(luminance_sum(frames[1]) != 0);
        CHECK(frames[1] == frames[2]);
        CHECK(frames[1] == frames[5]);
    }
}

TEST_CASE("ranges of frames merge to the run in one piece") { ranges_merge(render::Sampling::portals); }
TEST_CASE("ranges of frames with path reuse do, too") { ranges_merge(render::Sampling::reuse); }

// At night no light comes through the window: no directions go there.
TEST_CASE("where windows do not pay, their share is none") {
    const scene::Scene night = laws::scene_of(
        "void light lamp 0 0 3 9 9 9\nlamp polygon l 0 0 12 1 1 2.9 1 2 2.9 2 2 2.9 2 1 2.9\n"
        "void plastic white 0 0 5 .7 .7 .7 0 0\nwhite polygon floor 0 0 12 0 0 0 3 0 0 3 3 0 0 3 0\n"
        "white polygon wall 0 0 12 0 3 0 3 3 0 3 3 3 0 3 3\nvoid glass pane 0 0 3 .9 .9 .9\n"
        "pane polygon window 0 0 12 3 0 1 3 2 1 3 2 2 3 0 2\n");
    view::View view;
    view.vp = {1.5, .1, 1};
    view.vd = {0, 1, 0};
    view.vh = view.vv = 60;
    render::RenderOptions options;
    options.ab = 3;
    options.sampling = render::Sampling::portals;
    render::Renderer portals(night, view, 16, 16, options, "cpu", {});
    options.sampling = render::Sampling::plain;
    render::Renderer plain(night, view, 16, 16, options, "cpu", {});
    std::vector<float> a, b;
    for (const int64_t k : {1, 100}) {
        portals.frame(k, a);
        plain.frame(k, b);
        CHECK(luminance_sum(a) != 0);
        CHECK(a == b);
    }
}

TEST_CASE("under an overcast sky windows take half of the noise away") {
    const Office scene({"materials", "layout", "sky_overcast"});
    CHECK(noise_of(scene, render::Sampling::portals) < .6 * noise_of(scene, render::Sampling::plain));
}

TEST_CASE("where sun comes in, aiming at its patches takes a third away") {
    const Office scene;
    CHECK(noise_of(scene, render::Sampling::portals) < .67 * noise_of(scene, render::Sampling::plain));
}

// Standard errors come from 16 seeds (Student's t with 15 degrees of freedom, of two means: 4 is exceeded by chance in
// one of 1500 comparisons).  The blocks together: their mean square is 1 and a little more, that of t.  The cosine's
// paths get eight times the frames: they meet the sun in the window's frame so seldom that fewer have skewed means and
// too small errors.
TEST_CASE("aims at windows, patches of sun and glossy reflectors move no mean") {
    const Office scene;
    const Means aimed = means_of(scene, render::Sampling::portals, 8, 135);
    const Means plain = means_of(scene, render::Sampling::plain, 8, 1031);
    means_agree(aimed, plain);
    CHECK(aimed.variance[64] < 8 * plain.variance[64]);  // of as many frames
}

// Where one half of frame 0's samples holds all of a pixel's light, frame 1 may take it away, but no more than that.
TEST_CASE("sums are nowhere negative") {
    const int size = 192;
    render::RenderOptions options = direct_only();
    render::Renderer renderer = Office().renderer("cpu", size, options);
    film::Accumulator sum;
    float least = 1;
    renderer.frames(0, 17, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        sum.add(picture(rgb, size, k), "test");
        image::Picture now;
        sum.result(now, false);
        least = std::min(least, *std::min_element(now.rgb.begin(), now.rgb.end()));
        return true;
    });
    CHECK(least >= 0);
}

// Soft shadow of a square lamp and its image in a rough floor, -ab 0: nothing but frame 0's own noise.  The rms error
// over 16 x 16 pixels against 16384 frames of another seed must fall at least as 1/sqrt(n) from that of the 16 samples
// of frames 33 to 48, the first above m.  The rms of 256 pixels is itself known to 1/sqrt(512) = 4.4 %; two such errors
// and the reference's own (1/16 of the variance at 1024) make 7 %, of which three are allowed.
TEST_CASE("frame 0's own noise averages out") {
    const scene::Scene scene = scene_of(
        "void plastic floor 0 0 5 .4 .4 .4 .1 .15\nfloor polygon f 0 0 12 -5 -5 0 5 -5 0 5 5 0 -5 5 0\n"
        "void light lm 0 0 3 10 10 10\nlm polygon lamp 0 0 12 -.5 .5 2 -.5 1.5 2 .5 1.5 2 .5 .5 2\n"
        "void plastic box 0 0 5 .3 .2 .1 0 0\nbox sphere ball 0 0 4 0 .5 .5 .4\n");
    view::View view;
    view.vp = {0, -3, 1.5};
    view.vd = {0, 3, -1.3};
    view.vh = view.vv = 40;
    render::RenderOptions options = direct_only();
    options.seed = 99;
    const int size = 16;
    render::Renderer other(scene, view, size, size, options, "cpu", {});
    const image::Picture reference = sum_of(other, size, 0, 16384);
    options.seed = 1;
    render::Renderer renderer(scene, view, size, size, options, "cpu", {});
    const auto error_of = [&](const std::vector<float>& rgb) {
        double square = 0;
        for (size_t i = 0; i < rgb.size(); ++i) square += std::pow(rgb[i] - reference.rgb[i], 2);
        return std::sqrt(square / double(rgb.size()));
    };
    film::Accumulator sum;
    std::vector<float> of_16;
    std::map<int64_t, double> error;
    renderer.frames(0, 1025, [&](int64_t k, const std::vector<float>& rgb, const image::Moments&) {
        sum.add(picture(rgb, size, k), "test");
        if (k == 0) of_16 = rgb;
        for (size_t i = 0; k > 32 && k <= 48 && i < rgb.size(); ++i) of_16[i] += rgb[i] / 16;
        if (k == 16 || k == 64 || k == 256 || k == 1024) {
            image::Picture now;
            sum.result(now, false);
            error[k] = error_of(now.rgb);
        }
        return true;
    });
    CHECK(error_of(of_16) > 0);
    for (int64_t n : {16, 64, 256, 1024}) {
        CAPTURE(n);
        CHECK(error[n] <= 1.21 * error_of(of_16) / std::sqrt(double(n) / 16));
    }
}

#define ADD_BYTES(type, name) all.append(reinterpret_cast<const char*>(t.name.data()), sizeof(type) * t.name.size());
static std::string bytes_of(const kernels::ViewTables& t) {
    using namespace kernels;
    std::string all;
    VIEW_TABLES(ADD_BYTES)
    return all;
}

TEST_CASE("a stage that is called twice gives equal values, and changes none that it takes") {
    const Office office;
    const auto device = render::make_device("cpu");
    const render::RenderOptions options;
    const render::LoadedScene scene = render::load_scene(office.scene, options, office.files);
    device->upload(scene.tables);
    const auto plan = [&] { return render::plan_view(*device, scene, {office.view, 40, 40}, options); };
    const render::ViewPlan one = plan();
    const render::FrameZero zero = render::draw_frame_zero(*device, one);
    const render::DiffusePlan learned = render::learn(*device, one);
    const auto frames = [&](const render::ViewPlan& p) {
        std::vector<float> all;
        render::render_frames(*device, p, 0, 36, true,
                              [&](int64_t, const std::vector<float>& rgb, const image::Moments& moments) {
                                  all.insert(all.end(), rgb.begin(), rgb.end());
                                  if (moments) all.insert(all.end(), moments->begin(), moments->end());
                                  return true;
                              });
        return all;
    };
    const std::vector<float> first = frames(one);
    const render::ViewPlan two = plan();
    CHECK(two.fingerprint == one.fingerprint);
    CHECK(bytes_of(*two.sampling.params.view_tables) == bytes_of(*one.sampling.params.view_tables));
    CHECK(render::draw_frame_zero(*device, two).mean == zero.mean);
    const render::DiffusePlan again = render::learn(*device, one);
    REQUIRE(again.noisy.size() == learned.noisy.size());
    for (size_t i = 0; i < again.noisy.size(); i++) CHECK(again.noisy[i].pixels == learned.noisy[i].pixels);
    CHECK(std::memcmp(static_cast<const kernels::Params*>(&again.sampling.params),
                      static_cast<const kernels::Params*>(&learned.sampling.params), sizeof(kernels::Params)) == 0);
    CHECK(frames(one) == first);
    CHECK(frames(two) == first);
}
