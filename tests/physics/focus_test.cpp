// SPDX-License-Identifier: BSD-3-Clause
// The laws of the focus (ptrace -focus): there each sample is the mean of N, so expectations are those without it and
// variances an Nth; all other pixels keep their bits; and frames still depend on (seed, k, pixel) alone.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "render/focus.h"

#include <cstring>
#include <memory>

#include "physics/laws.h"
#include "physics/office.h"
#include "physics/seeds.h"

using namespace laws;

namespace {

constexpr int size = 24;

// Two regions, rectangles of 4 x 2 and of 12 x 6 pixels that share two pixels.
bool in_small(int x, int y) { return x >= 8 && x < 12 && y >= 10 && y < 12; }
bool in_large(int x, int y) { return x >= 2 && x < 14 && y >= 11 && y < 17; }

image::MaskSet two_regions() {
    image::MaskSet set;
    set.width = set.height = size;
    set.masks = {{"small", {}}, {"large", {}}};
    for (int y = 0; y < size; y++)
        for (int x = 0; x < size; x++) {
            set.masks[0].coverage.push_back(in_small(x, y) ? .25f : 0.0f);
            set.masks[1].coverage.push_back(in_large(x, y) ? 1.0f : 0.0f);
        }
    return set;
}

// In each region as many samples more as a quarter of the picture has pixels: 18 and 2 copies.
render::Focus focus() { return render::focus_on(two_regions(), size, size, .5, "test"); }

std::unique_ptr<render::Renderer> renderer(const Office& office, const render::Focus& focus, const std::string& device,
                                           const render::RenderOptions& options = {}) {
    return std::make_unique<render::Renderer>(office.scene, render::RenderView{office.view, size, size, focus}, options,
                                              device, office.files);
}

}  // namespace

TEST_CASE("regions share samples alike, and a pixel of two has those of the smaller one") {
    const render::Focus parts = focus();
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].spp == 2);
    CHECK(parts[0].pixels.size() == 12 * 6 - 4);
    CHECK(parts[1].spp == 18);
    CHECK(parts[1].pixels.size() == 8);
    CHECK(parts[1].pixels.front() == 10 * size + 8);
}

TEST_CASE("regions that are too large for a second sample are no focus") {
    CHECK(render::focus_on(two_regions(), size, size, .01, "test").empty());
}

TEST_CASE("a focus of another size, or of nothing, is refused") {
    CHECK_THROWS_WITH(render::focus_on(two_regions(), size, 2 * size, .5, "x.exr"),
                      "x.exr: the picture has 24 x 48 pixels, the regions 24 x 24");
    image::MaskSet empty = two_regions();
    empty.masks[0].coverage.assign(size * size, 0.0f);
    CHECK_THROWS_WITH(render::focus_on(empty, size, size, .5, "x.exr"), "x.exr: region \"small\" is empty");
}

TEST_CASE("other pixels keep their bits, on every device") {
    const Office office;
    render::RenderOptions options;
    for (const auto sampling : {render::Sampling::portals, render::Sampling::reuse}) {
        options.sampling = sampling;
        const auto without = renderer(office, {}, "cpu", options), with = renderer(office, focus(), "cpu", options);
        for (const int64_t k : {0, 1, 8, 9, 100}) {
            CAPTURE(k);
            std::vector<float> a, b;
            without->frame(k, a);
            with->frame(k, b);
            int changed = 0, kept = 0;
            for (int i = 0; i < size * size; i++) {
                const bool same = std::memcmp(&a[3 * size_t(i)], &b[3 * size_t(i)], 12) == 0;
                const bool inside = in_small(i % size, i / size) || in_large(i % size, i / size);
                if (inside) changed += !same;
                else kept += same;
            }
            CHECK(kept == size * size - 76);
            CHECK(changed > (k == 0 ? 1 : 60));
        }
    }
}

TEST_CASE("devices and neighbouring frames do not matter") {
    const Office office;
    const auto cpu = renderer(office, focus(), "cpu");
    std::vector<float> alone, other;
    for (const std::string& device : devices()) {
        CAPTURE(device);
        const auto together = renderer(office, focus(), device);
        for (const int64_t k : {0, 63}) {
            together->frames(k, 5, [&](int64_t frame, const std::vector<float>& rgb, const image::Moments&) {
                CAPTURE(frame);
                cpu->frame(frame, alone);
                CHECK(rgb == alone);
                return true;
            });
        }
    }
}

TEST_CASE("ranges of frames merge to the run in one piece") {
    const Office office;
    const auto one = renderer(office, focus(), "cpu");
    const image::Picture whole = sum_of(*one, size, 0, 40);
    film::Merger merger;
    for (const auto& range : {std::pair{10, 40}, std::pair{0, 9}}) {
        const auto machine = renderer(office, focus(), "cpu");
        merger.add(sum_of(*machine, size, range.first, range.second), "part");
    }
    const image::Picture merged = merger.result();
    for (size_t i = 0; i < whole.rgb.size(); i++)
        CHECK(std::abs(merged.rgb[i] - whole.rgb[i]) <= 2e-6 * std::max(1e-3f, std::abs(whole.rgb[i])));
}

// Pixels of the two regions over 48 seeds of 64 frames, a whole block, of which each copy is a sample of its own;
// frames 0 to 63 hold all classes.  A pixel's variance is known to sqrt(2/47) = 21 % if its distribution is normal, and
// their mean over 68 pixels (8) to 2.5 % (7.3 %) of it; distributions with longer tails double that, and four such
// errors of both sides are allowed.  Of all means, the largest difference lies within 4.5 standard errors, and the mean
// of their squares is 1.
TEST_CASE("the mean of N samples has the expectation of one and an Nth of its variance") {
    const Office office({"materials", "layout", "sky_overcast"});
    const auto means = [&](const render::Focus& focus) {
        return over_seeds(48, size * size, [&](uint64_t seed) {
            render::RenderOptions options;
            options.seed = seed;
            options.noisy_share = 0;  // else some of them had several without a focus, too
            const auto r = renderer(office, focus, "cpu", options);
            const image::Picture sum = sum_of(*r, size, 0, 64);
            std::vector<double> grey;
            for (size_t i = 1; i < sum.rgb.size(); i += 3) grey.push_back(sum.rgb[i]);
            return grey;
        });
    };
    const Means one = means({}), several = means(focus());
    for (const render::FocusPart& part : focus()) {
        CAPTURE(part.spp);
        double variance_of_one = 0, variance = 0, square = 0;
        for (const uint32_t i : part.pixels) {
            variance_of_one += one.variance[i];
            variance += several.variance[i];
            const double z = (one.mean[i] - several.mean[i]) / std::sqrt(one.variance[i] + several.variance[i]);
            CHECK(std::abs(z) < 4.5);
            square += z * z / double(part.pixels.size());
        }
        MESSAGE(part.spp << " copies: variance " << variance_of_one / variance << " times smaller, z^2 " << square);
        CHECK(variance_of_one / variance == doctest::Approx(part.spp).epsilon(part.pixels.size() > 8 ? .28 : .8));
        CHECK(square < (part.pixels.size() > 8 ? 1.8 : 3));
    }
}
