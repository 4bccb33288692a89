// SPDX-License-Identifier: BSD-3-Clause
// Eq. 7: closed forms, and sums that lose nothing.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

#include "base/warnings.h"
#include "film/accumulate.h"
#include "image/stream.h"
#include "film_sums.h"
#include "temp_folder.h"

using film::Accumulator;
using film::Merger;
using image::Picture;

// Sums are of radiances, whatever exposure each frame was written with; the first one's is kept.
TEST_CASE("frames and parts of differing exposure") {
    const auto exposed = [](Picture p, double exposure) {
        p.header.exposure = exposure;
        return p;
    };
    Accumulator a;
    for (int64_t k = 0; k <= 9; ++k) a.add(exposed(frame(k), k ? 2 : 8), "x");
    Picture sum;
    a.result(sum, true);
    CHECK(sum.rgb == sum_of(0, 9).rgb);
    CHECK(sum.header.exposure == 8);
    const Picture whole = merged({exposed(sum_of(0, 4), 3), exposed(sum_of(5, 9), 1)});
    CHECK(worst(whole, sum) < 1e-6);
    CHECK(whole.header.exposure == 3);
}

// Frames of mean 1 with a heavy tail against their sum in long double: 1e-6 is the aim, 1e-7 the rounding of a float.
TEST_CASE("accumulation does not drift") {
    Picture f;
    f.width = 16;
    f.height = 1;
    f.rgb.resize(48);
    Accumulator a;
    std::vector<long double> sum(48, 0);
    uint64_t state = 1;
    for (int64_t k = 0; k <= 50000; ++k) {
        f.header.frame = k;
        for (size_t i = 0; i < 48; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            const double u = double(state >> 11) / 9007199254740992.;
            f.rgb[i] = k == 0 ? 0 : float(9 * std::pow(u, 8) + (u < 1e-4 ? 1e4 : 0) - 1e-3);
            sum[i] += f.rgb[i];
        }
        a.add(Picture(f), "x");
    }
    Picture p;
    a.result(p, false);
    for (size_t i = 0; i < 48; ++i) CHECK(std::fabs(double(p.rgb[i] / (sum[i] / 50000) - 1)) < 1e-6);
}

TEST_CASE("frame 0 alone is L(0)") {
    const Picture p = sum_of(0, 0);
    CHECK(p.rgb == frame(0).rgb);
    CHECK(p.header.frames == 0);
    CHECK(p.header.ranges == image::Ranges{{0, 0}});
    CHECK_FALSE(p.header.frame);
}

TEST_CASE("L'(n) = L(0) + mean of frames 1..n, after every frame") {
    Accumulator a;
    std::vector<double> sum(90, 0);
    Picture p;
    for (int64_t k = 0; k <= 50; ++k) {
        a.add(frame(k), "x");
        const Picture f = frame(k);
        if (k > 0)
            for (size_t i = 0; i < 90; ++i) sum[i] += f.rgb[i];
        a.result(p, false);
        CHECK(p.header.frames == k);
        for (size_t i = 0; i < 90; ++i) CHECK(p.rgb[i] == float(frame(0).rgb[i] + (k ? sum[i] * (1. / double(k)) : 0)));
    }
}

TEST_CASE("100,000 frames lose nothing") {
    // Frame k is 1 + 2^-20 everywhere: the mean must be that float exactly; a float sum would have stuck long before.
    Picture f;
    f.width = f.height = 1;
    f.rgb.assign(3, 0);
    Accumulator a;
    for (int64_t k = 0; k <= 100000; ++k) {
        f.header.frame = k;
        f.rgb.assign(3, k ? 1 + std::ldexp(1.f, -20) : 0);
        a.add(Picture(f), "x");
    }
    Picture p;
    a.result(p, false);
    CHECK(p.rgb[0] == 1 + std::ldexp(1.f, -20));
}

TEST_CASE("a new frame 0 starts again, whatever its size and seed") {
    Accumulator a;
    for (int64_t k = 0; k < 5; ++k) a.add(frame(k), "x");
    Picture big = frame(0, 9);
    big.width = 5, big.height = 6;
    a.add(std::move(big), "x");
    CHECK(a.frames() == 0);
    Picture p;
    a.result(p, true);
    CHECK(p.width == 5);
    CHECK(p.header.seed == 9);
}

TEST_CASE("another action starts again, and goes on from no sum of another one") {
    const auto of_action = [](int64_t k, const std::optional<image::Action>& action) {
        Picture p = frame(k);
        p.header.action = action;
        return p;
    };
    Accumulator a;
    for (int64_t k = 0; k < 5; ++k) a.add(of_action(k, {}), "x");
    CHECK(a.restarts(of_action(5, image::Action{"mel", 9, "lx"}).header));
    a.add(of_action(5, image::Action{"mel", 9, "lx"}), "x");
    CHECK(a.frames() == 1);
    CHECK(a.restarts(of_action(6, image::Action{"mel", 12, "lx"}).header));
    CHECK(!a.restarts(of_action(6, image::Action{"mel", 9, "lx"}).header));
    Accumulator b;
    b.resume(sum_of(0, 4), "sum.exr");
    CHECK(error_text([&] {
              b.add(of_action(5, image::Action{"mel", 9, "lx"}), "x");
          }) ==
          "x: frame 5: has action mel of 9 bands in lx, sum.exr has no action (ACTION=): they cannot be combined into "
          "one picture");
}

TEST_CASE("values that are not finite count as 0, with a warning") {
    base::take_warnings();
    Accumulator a;
    a.add(frame(0), "x");
    Picture f = frame(1);
    f.rgb[3] = NAN;
    f.rgb[5] = INFINITY;
    a.add(Picture(f), "x");
    Picture p;
    a.result(p, false);
    CHECK(p.rgb[3] == frame(0).rgb[3]);
    CHECK(p.rgb[5] == frame(0).rgb[5]);
    CHECK(base::take_warnings().size() == 1);
}

TEST_CASE("schedules") {
    const auto due = [](const char* text, int64_t last) {
        film::Schedule s = film::Schedule::parse(text, "-every");
        std::vector<int64_t> all;
        for (int64_t n = 0; n <= last; ++n)
            if (s.due(n)) all.push_back(n);
        return all;
    };
    CHECK(due("1", 3) == std::vector<int64_t>{0, 1, 2, 3});
    CHECK(due("4", 9) == std::vector<int64_t>{0, 4, 8});
    CHECK(due("x2", 40) == std::vector<int64_t>{0, 1, 2, 4, 8, 16, 32});
    CHECK(due("x10", 1500) == std::vector<int64_t>{0, 1, 10, 100, 1000});
    // 16 steps a doubling: from 16 to 32 every frame, from 1024 to 2048 16 of them
    const auto fine = due("x2/16", 2047);
    int64_t in_doubling = 0;
    for (const int64_t n : fine) in_doubling += n >= 1024;
    CHECK(in_doubling == 16);
    // Factors at the ends of what a double holds: nothing after the first, or every number
    for (const char* huge : {"x1e300", "x1e19", "x1e18/1"}) CHECK(due(huge, 5000) == std::vector<int64_t>{0, 1});
    for (const char* tiny : {"x1.0000000001", "x1.0000000000000002", "x2/9000000000000000000"})
        CHECK(due(tiny, 5000).size() == 5001);
    // All n that F^(i/M) rounds to, counted one by one
    for (const char* text : {"x2/16", "x1.5", "x1.01", "x3/7", "x1e19/100"}) {
        const char* slash = std::strchr(text, '/');
        const double factor = std::atof(text + 1), parts = slash ? std::atof(slash + 1) : 1;
        std::vector<int64_t> all{0};
        for (double i = 0, t = 1; t <= 5000; t = std::round(std::pow(factor, ++i / parts)))
            if (int64_t(t) != all.back()) all.push_back(int64_t(t));
        CHECK(due(text, 5000) == all);
    }
    for (const char* bad : {"0", "-3", "x1", "x", "x2/0", "y", "", "2.5"})
        CHECK_FALSE(error_text([&] { film::Schedule::parse(bad, "-every"); }).empty());
}
