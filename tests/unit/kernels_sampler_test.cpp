// SPDX-License-Identifier: BSD-3-Clause
// The sampler's importances: each pair of dimensions is a (0,2)-net over blocks of 64 samples (Sobol 1967; Owen 1995
// keeps it), pixels, seeds and dimensions are independent, and long sums converge faster than random numbers.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <vector>
#include "kernels/dialect/compat_host.h"
namespace device {
#include "kernels/sampling/sampler.h"
}
using device::Sampler;

// The d-th pair of sample i of a pixel.
static float2 pair_of(uint seed, uint pixel, uint i, int d) {
    Sampler s = device::sampler_start(seed, 0, pixel, i, 0);
    float2 x{};
    for (int k = 0; k <= d; ++k) x = device::sample2(&s);
    return x;
}

TEST_CASE("64 samples fill every 64th part of the square once, however it is cut") {
    for (uint pixel : {0u, 1u, 77u})
        for (uint block : {0u, 1u, 15u})
            for (int d : {0, 1, 9})
                for (int bits = 0; bits <= 6; ++bits) {  // 2^bits columns, 2^(6-bits) rows
                    std::vector<int> count(64, 0);
                    for (uint i = 0; i < 64; ++i) {
                        const float2 x = pair_of(1, pixel, 64 * block + i, d);
                        REQUIRE(x.x >= 0);
                        REQUIRE(x.x < 1);
                        count[size_t(int(x.x * float(1 << bits)) * (1 << (6 - bits)) + int(x.y * float(64 >> bits)))]++;
                    }
                    for (int n : count) CHECK(n == 1);
                }
}

// The quarter disc has pi/4 of the square.  Random points leave an rms error of sqrt(p (1-p) / n); over 200 pixels that
// rms is known to 5 %.  Blocks of 64 are several times better, and go on improving as 1/sqrt(blocks).
TEST_CASE("means converge, to 1024 samples and beyond") {
    const double p = M_PI / 4;
    for (uint n : {64u, 256u, 1024u, 4096u}) {
        double square = 0;
        for (uint pixel = 0; pixel < 200; ++pixel) {
            uint inside = 0;
            for (uint i = 0; i < n; ++i) {
                const float2 x = pair_of(5, pixel, i, 2);
                inside += x.x * x.x + x.y * x.y < 1;
            }
            square += std::pow(double(inside) / n - p, 2) / 200;
        }
        CAPTURE(n);
        CHECK(std::sqrt(square) < .5 * std::sqrt(p * (1 - p) / n));
        CHECK(square > 0);
    }
}

// Independent uniform numbers: the covariance of 200,000 products has a standard error of 1/12/sqrt(200000).
TEST_CASE("dimensions, pixels and seeds do not know each other") {
    const uint n = 200000;
    double dims = 0, pixels = 0, seeds = 0;
    for (uint k = 0; k < n; ++k) {
        const float a = pair_of(1, k, 3, 0).x - .5f;
        dims += a * (pair_of(1, k, 3, 1).x - .5f);
        pixels += a * (pair_of(1, k + 1, 3, 0).x - .5f);
        seeds += a * (pair_of(2, k, 3, 0).x - .5f);
    }
    const double limit = 4. / 12 / std::sqrt(double(n));
    CHECK(std::abs(dims / n) < limit);
    CHECK(std::abs(pixels / n) < limit);
    CHECK(std::abs(seeds / n) < limit);
}
