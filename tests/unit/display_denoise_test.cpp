// SPDX-License-Identifier: BSD-3-Clause
// The filter of pictures for people: a known picture with known noise comes nearer to the truth, keeps its edges and
// its light, and where there is no noise nothing moves.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "display/denoise.h"

namespace {

constexpr int width = 72, height = 64, edge = 30, frames = 32;

size_t at(int x, int y, int c = 0) { return 3 * (size_t(y) * width + size_t(x)) + size_t(c); }

// Walls of 1 and 4 that meet at `edge`, a slope below, coloured: what diffuse frames have as their mean.
std::vector<float> diffuse_truth() {
    std::vector<float> v(3 * size_t(width) * height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const float wall = x < edge ? 1.f : 4.f;
                v[at(x, y, c)] = (y < 40 ? wall : 1 + .02f * float(x)) * (1 - .2f * float(c));
            }
    return v;
}

// Frame 0 is exact and has its own pattern, which no frame after it shows: lines of one pixel.
std::vector<float> frame_zero() {
    std::vector<float> v(3 * size_t(width) * height, .25f);
    for (int y = 0; y < height; y += 8)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) v[at(x, y, c)] = 6;
    return v;
}

// One path in five finds an emitter: a sample's standard deviation is `noise` times the truth, and with 2 four of five
// are black.  All channels of a pixel find it together.
display::HalfSums sampled(const std::vector<float>& truth, float noise, std::vector<float>& mean) {
    std::mt19937 dice(7);
    display::HalfSums sums;
    sums.clear(truth.size());
    mean.assign(truth.size(), 0);
    for (int k = 0; k < frames; ++k) {
        std::vector<float> frame = truth;
        for (size_t i = 0; noise > 0 && i < frame.size(); i += 3) {
            const float found = 1 + noise * (dice() % 5 == 0 ? 2.f : -.5f);
            for (size_t c = 0; c < 3; ++c) frame[i + c] *= found;
        }
        sums.add(frame);
        for (size_t i = 0; i < frame.size(); ++i) mean[i] += frame[i] / frames;
    }
    return sums;
}

struct Trial {
    std::vector<float> truth, plain, filtered;
};

Trial trial(float noise, unsigned threads = 1) {
    Trial t;
    t.truth = diffuse_truth();
    const std::vector<float> zero = frame_zero();
    const display::HalfSums sums = sampled(t.truth, noise, t.plain);
    for (size_t i = 0; i < zero.size(); ++i) t.truth[i] += zero[i], t.plain[i] += zero[i];
    t.filtered = display::denoised(sums, zero, width, height, threads);
    return t;
}

double rms_error(const std::vector<float>& picture, const std::vector<float>& truth) {
    double sum = 0;
    for (size_t i = 0; i < truth.size(); ++i) sum += std::pow(double(picture[i] / truth[i] - 1), 2);
    return std::sqrt(sum / double(truth.size()));
}

// Mean of the green of column x over the rows of the two walls that frame 0 has no line in.
double column(const std::vector<float>& picture, int x) {
    double sum = 0;
    int n = 0;
    for (int y = 1; y < 40; ++y)
        if (y % 8) sum += double(picture[at(x, y, 1)]), ++n;
    return sum / n;
}

double mean(const std::vector<float>& picture) {
    double sum = 0;
    for (float v : picture) sum += double(v);
    return sum / double(picture.size());
}

}  // namespace

TEST_CASE("noise falls to less than half") {
    for (float noise : {.5f, 2.f}) {
        const Trial t = trial(noise);
        const double before = rms_error(t.plain, t.truth), after = rms_error(t.filtered, t.truth);
        MESSAGE("rms of relative errors: ", before, " before, ", after, " after");
        CHECK(after < before / 2);
    }
}

// With little noise the columns on both sides of the edge are as they should be; with much of it, all but these two.
TEST_CASE("an edge stays where it is") {
    for (float noise : {.5f, 2.f}) {
        const Trial t = trial(noise);
        for (int x = edge - 6; x < edge + 6; ++x) {
            if (noise > 1 && (x == edge - 1 || x == edge)) continue;
            const double truth = column(t.truth, x), diffuse = truth - .25;
            const double plain_deviation = double(noise) * diffuse / std::sqrt(frames * 35.);  // 35 rows
            CHECK(std::fabs(column(t.filtered, x) - truth) < 3 * plain_deviation);
        }
    }
}

TEST_CASE("lines of one pixel in frame 0 stay lines") {
    const Trial t = trial(.5f);
    for (int y = 8; y < 40; y += 8)
        for (int x = 0; x < width; ++x) CHECK(t.filtered[at(x, y)] - t.filtered[at(x, y - 1)] > .8 * 5.75);
}

TEST_CASE("the light of the whole picture is the same") {
    for (float noise : {.5f, 2.f}) {
        const Trial t = trial(noise);
        const double deviation = double(noise) * mean(diffuse_truth()) / std::sqrt(double(frames) * width * height);
        CHECK(std::fabs(mean(t.filtered) - mean(t.truth)) < 4 * deviation);
    }
}

// Nor does the rounding of huge distances that a box filter has passed by let pixels look alike.
TEST_CASE("without noise nothing moves") {
    const Trial t = trial(0);
    for (size_t i = 0; i < t.truth.size(); ++i) CHECK(t.filtered[i] == doctest::Approx(t.truth[i]).epsilon(1e-4));
}

TEST_CASE("threads do not show") { CHECK(trial(2, 1).filtered == trial(2, 3).filtered); }

TEST_CASE("a sample that is no number counts as black") {
    display::HalfSums sums;
    sums.clear(12);
    for (int k = 0; k < 8; ++k) sums.add(std::vector<float>(12, k == 3 ? NAN : 1));
    for (float v : display::denoised(sums, std::vector<float>(12, 0), 2, 2, 1)) CHECK(std::isfinite(v));
}

TEST_CASE("a sample too bright to be squared spoils no pixel far from it") {
    display::HalfSums sums;
    const size_t pixels = 40;
    sums.clear(3 * pixels);
    for (int k = 0; k < 8; ++k) {
        std::vector<float> frame(3 * pixels, 1);
        if (k == 3) frame[60] = 1e25f;
        sums.add(frame);
    }
    const std::vector<float> out = display::denoised(sums, std::vector<float>(3 * pixels, 0), int(pixels), 1, 1);
    for (size_t i = 0; i < out.size(); ++i) {
        CHECK(std::isfinite(out[i]));
        if (i / 3 < 10 || i / 3 > 30) CHECK(out[i] == 1);
    }
}
