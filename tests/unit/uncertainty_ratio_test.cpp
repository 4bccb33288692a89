// SPDX-License-Identifier: BSD-3-Clause
// Ratios of quantities of two growing means, as melanopic DER is: how often their intervals hold the truth.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "uncertainty/ratio.h"

using namespace uncertainty;

namespace {

constexpr int width = 8, height = 4;
constexpr size_t pixels = size_t(width) * height;
const std::vector<Quantity> linear{{Quantity::Method::half_samples, NoiseBias::none, 0, false, 2}};

double mean_of(const std::vector<float>& image) {
    double sum = 0;
    for (const float v : image) sum += v;
    return sum / double(image.size());
}

// A sum of n frames of the pixels of some paths, each times a factor that its bands give it, and its replicates.
struct Sum {
    std::vector<float> mean = std::vector<float>(pixels, 0);
    image::GrowingParts parts;
    int64_t n = 0;
    void add(const std::vector<double>& frame, uint64_t seed) {
        ++n;
        for (size_t i = 0; i < pixels; ++i)
            mean[i] = float(double(mean[i]) * double(n - 1) / double(n) + frame[i] / double(n));
        parts.add(mean.data(), pixels, n, seed);
    }
    Replicates replicates() const {
        Metrics metrics;
        metrics.quantities = linear;
        metrics.measure = [] {
            return [](std::vector<float>& image, std::vector<float>&) { return Values{mean_of(image)}; };
        };
        GrowingMean growing;
        growing.width = width, growing.height = height, growing.whole = mean.data(), growing.parts = &parts.parts();
        growing.counts.assign(pixels, true);
        return replicate(growing, metrics, {mean_of(mean)});
    }
};

struct Coverage {
    int held = 0, known = 0;
    double width = 0;
    double share() const { return double(held) / double(known); }
};

// Rooms in which paths bring light of two kinds, sky and wood: of V, and of an action that sees less of the wood.
// noise: of paths, in common; own: of each picture by itself.  apart: nothing says so.
Coverage coverage(int64_t frames, double noise, double own, bool apart) {
    constexpr int runs = 1000;
    constexpr double sky = 1, wood = .5, of_sky = 1.1, of_wood = .6;
    Coverage out;
    for (int run = 0; run < runs; ++run) {
        std::mt19937 random{uint32_t(run)};
        std::lognormal_distribution<double> paths(-noise * noise / 2, noise), extra(-own * own / 2, own);
        Sum mel, by_V;
        for (int64_t k = 0; k < frames; ++k) {
            std::vector<double> a(pixels), b(pixels);
            for (size_t i = 0; i < pixels; ++i) {
                const double s = sky * paths(random), w = wood * paths(random);
                a[i] = (of_sky * s + of_wood * w) * extra(random), b[i] = (s + w) * extra(random);
            }
            mel.add(a, 1), by_V.add(b, apart ? 2 : 1);
        }
        const Replicates over = mel.replicates(), under = by_V.replicates();
        const Estimate e = ratio({&over, 0, estimate(over, linear)[0]}, {&under, 0, estimate(under, linear)[0]});
        const Interval off = e.around(.05, frames);
        const double truth = (of_sky * sky + of_wood * wood) / (sky + wood);
        out.known += std::isfinite(off.low);
        out.held += e.value + off.low <= truth && truth <= e.value + off.high;
        out.width += off.half_width() / runs;
    }
    return out;
}

}  // namespace

TEST_CASE("intervals of a ratio whose paths are shared hold the truth, and what both have in common is not in them") {
    for (const int64_t frames : {8, 16, 33, 64})
        for (const double noise : {.3, 1.}) {
            const Coverage c = coverage(frames, noise, .05, false);
            CAPTURE(frames);
            CAPTURE(noise);
            CHECK(c.known == 1000);
            CHECK(c.share() >= .93);
            CHECK(c.share() <= .98);
        }
    // Ratios of the same paths vary by the mixture alone; as independent ones by all of their noise.
    const Coverage paired = coverage(16, 1, .05, false), apart = coverage(16, 1, .05, true);
    CHECK(paired.width < .5 * apart.width);
    CHECK(apart.share() > .99);
}

TEST_CASE("without the same frames both errors count") {
    const Estimate a{10, .3, 8, 0, false, 16}, b{5, .2, 8, 0, false, 16};
    const Replicates none;
    const Estimate e = ratio({&none, 0, a}, {&none, 0, b});
    CHECK(e.value == doctest::Approx(2));
    CHECK(e.error == doctest::Approx(2 * std::hypot(.03, .04)));
    CHECK(e.degrees > 8);
    CHECK(ratio_of_half_samples({&none, 0, a}, {&none, 0, b}).empty());
    CHECK(!ratio({&none, 0, Estimate{10, NAN, 0}}, {&none, 0, b}).known());
}

TEST_CASE("a ratio of the same picture is 1 without an error") {
    std::mt19937 random{1};
    std::normal_distribution<double> gauss(1, .5);
    Sum sum;
    for (int k = 0; k < 32; ++k) {
        std::vector<double> frame(pixels);
        for (double& v : frame) v = gauss(random);
        sum.add(frame, 1);
    }
    const Replicates r = sum.replicates();
    const Measured m{&r, 0, estimate(r, linear)[0]};
    CHECK(ratio(m, m).value == 1);
    CHECK(ratio(m, m).half_width(.05, 32) == 0);
    for (const double v : ratio_of_half_samples(m, m)) CHECK(v == 1);
}
