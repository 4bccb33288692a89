// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a grid of noisy values: closed forms, and simulated coverage.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "report/grids.h"

using namespace uncertainty;

namespace {
struct Noisy {
    std::vector<image::Part> parts;
    std::vector<float> whole;
};

// Sixteen frames of values, each with its relative noise; all have a part in common.
Noisy frames_of_values(const std::vector<double>& truth, const std::vector<double>& noise, double common,
                       std::mt19937& random) {
    std::normal_distribution<double> normal;
    Noisy out;
    out.whole.assign(truth.size(), 0.0f);
    for (int k = 0; k < 16; ++k) {
        image::Part part;
        part.frames = 1;
        const double all = common * normal(random);
        for (size_t i = 0; i < truth.size(); ++i) {
            part.grey.push_back(float(truth[i] * (1 + all + noise[i] * normal(random))));
            out.whole[i] += part.grey[i] / 16;
        }
        out.parts.push_back(std::move(part));
    }
    return out;
}
}  // namespace

TEST_CASE("without noise every interval is the number itself") {
    std::vector<image::Part> parts(4);
    for (image::Part& part : parts) part.frames = 4, part.grey = {1, 2, 3, 4};
    const std::vector<float> whole = {1, 2, 3, 4};
    const NoisyValues v = noisy_values(parts, whole.data(), 1, 3, 10);
    CHECK(v.mean.value == doctest::Approx(30));
    CHECK(v.value == std::vector<double>{20, 30, 40});
    for (const char* name : {"mean", "min", "max", "median", "p5", "U0", "share25"}) {
        const image::Grid grid{"g", 0, 3, true, ""};
        const auto n = report::grid_number(report::grid_columns({name}, {grid}, "")[0], {v}, .05);
        CAPTURE(name);
        CHECK(n.limits.low == doctest::Approx(n.value));
        CHECK(n.limits.high == doctest::Approx(n.value));
    }
    CHECK(percentile({4, 1, 3, 2}, .5) == doctest::Approx(2.5));
    CHECK(share_from({1, 2, 3, 4}, 3) == doctest::Approx(.5));
}

TEST_CASE("frames that are all alike have no width from the second one on: direct light alone, or a dark grid") {
    std::vector<image::Part> parts(2);
    for (const float light : {1.0f, 0.0f}) {
        for (image::Part& part : parts) part.frames = 1, part.grey = {light, 2 * light};
        const NoisyValues v = noisy_values(parts, parts[0].grey.data(), 0, 2, 10);
        const image::Grid grid{"g", 0, 2, true, ""};
        for (const char* name : {"mean", "min", "max", "median", "share5"}) {
            const auto n = report::grid_number(report::grid_columns({name}, {grid}, "")[0], {v}, .05);
            CAPTURE(name);
            CHECK(n.limits.low == n.value);
            CHECK(n.limits.high == n.value);
        }
        const auto u = report::grid_number(report::grid_columns({"U0"}, {grid}, "")[0], {v}, .05);
        CHECK(std::isnan(u.limits.low) == (light == 0));
        CHECK(std::isnan(u.limits.high) == (light == 0));
    }
}

TEST_CASE("fewer than two parts: no interval") {
    const std::vector<float> whole = {1, 2};
    const NoisyValues v = noisy_values({}, whole.data(), 0, 2, 1);
    CHECK(std::isnan(mean_limits(v, .05).low));
    CHECK(std::isnan(least_limits(v, .05).high));
}

TEST_CASE("intervals hold: of 200 simulated runs, 93 % or more; of points, 93 % of all") {
    // many values within the noise of each number, few, of which one or two decide it, and values that differ less than
    // their noise does
    struct Case {
        size_t count;
        double noise, range;
    };
    const Case cases[] = {{150, .4, 2.5}, {150, .02, 2.5}, {24, .05, 2.5}, {150, .1, .02}, {24, .2, .1}};
    for (const auto& [count, noise, range] : cases) {
        CAPTURE(count);
        CAPTURE(noise);
        std::mt19937 random(7);
        std::vector<double> truth;
        for (size_t i = 0; i < count; ++i) truth.push_back(100 * std::exp(range * double(i) / double(count)));
        const double true_mean = std::accumulate(truth.begin(), truth.end(), 0.0) / double(count);
        const std::vector<image::Grid> grids = {{"g", 0, count, true, ""}};
        const std::string decided = "share" + std::to_string(int(std::ceil(truth[count / 3])));  // by one value
        // of values that noise alone drives across the limit; at the end of a wide range 86 % would hold
        const std::string none = range < 1 ? "share" + std::to_string(int(std::ceil(truth[count - 1]))) : "share5000";
        const auto columns = report::grid_columns(
            {"mean", "min", "max", "median", "p5", "p95", "share300", none, decided, "U0"}, grids, "");
        const double exact[] = {true_mean,
                                truth[0],
                                truth[count - 1],
                                percentile(truth, .5),
                                percentile(truth, .05),
                                percentile(truth, .95),
                                share_from(truth, 300),
                                0,
                                share_from(truth, columns[8].argument),
                                truth[0] / true_mean};
        const std::vector<double> noises(count, noise);
        for (const double common : {0., .25}) {
            std::vector<int> holds(columns.size(), 0);
            int points = 0;
            for (int run = 0; run < 200; ++run) {
                const Noisy noisy = frames_of_values(truth, noises, common * noise, random);
                const NoisyValues v = noisy_values(noisy.parts, noisy.whole.data(), 0, count, 1);
                for (size_t c = 0; c < columns.size(); ++c) {
                    const Interval of = report::grid_number(columns[c], {v}, .05).limits;
                    holds[c] += of.low <= exact[c] && exact[c] <= of.high;
                }
                for (size_t i = 0; i < count; ++i) {
                    const Interval of = point_limits(v, i, .05);
                    points += of.low <= truth[i] && truth[i] <= of.high;
                }
            }
            for (size_t c = 0; c < columns.size(); ++c) {
                CAPTURE(columns[c].name);
                CHECK(holds[c] >= 183);  // 93 %, less a standard error
            }
            CHECK(points >= .93 * 200 * double(count));
            CHECK(points <= .98 * 200 * double(count));
        }
    }
}

TEST_CASE(
    "noise that differs tenfold among values: intervals hold where it is large and stay narrow where it is small") {
    constexpr size_t count = 120;
    std::mt19937 random(7);
    const std::vector<double> truth(count, 100);
    std::vector<double> noise;
    for (size_t i = 0; i < count; ++i) noise.push_back(i % 5 == 0 ? .2 : .02);
    int noisy = 0, holds = 0;
    double width = 0;
    for (int run = 0; run < 200; ++run) {
        const Noisy frames = frames_of_values(truth, noise, 0, random);
        const NoisyValues v = noisy_values(frames.parts, frames.whole.data(), 0, count, 1);
        for (size_t i = 0; i < count; ++i) {
            const Interval of = point_limits(v, i, .05);
            if (i % 5 == 0) noisy++, holds += of.low <= truth[i] && truth[i] <= of.high;
            else width += (of.high - of.low) / 2 / (200 * .8 * count);
        }
    }
    CHECK(holds >= .93 * noisy);
    CHECK(width <= 2 * 1.96 * (.02 * 100 / 4));  // twice what they scatter by
}
