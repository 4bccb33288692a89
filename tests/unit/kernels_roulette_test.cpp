// SPDX-License-Identifier: BSD-3-Clause
// Russian roulette (kernels/integrator/continue.h, docs/decisions/0029-roulette.md): it keeps the mean of what a path
// carries, makes none carry more than where roulette sets in, and leaves alone what carries more, however dark its
// surfaces.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>
namespace device {
#include "kernels/dialect/compat_host.h"
#include "kernels/all.h"
}  // namespace device
using namespace device;

static Vertex path_of(uint k, float carried, float weight, uint bounces = 2) {
    Vertex vertex = {};
    vertex.flags = bounces << PC_AB_SHIFT;
    vertex.rnd = sampler_start(7, 8, k, 0, 0);
    vertex.throughput = F3(.5f * carried, carried, .25f * carried);
    vertex.weight = weight;
    return vertex;
}

TEST_CASE("a path that carries much goes on, whatever its ray weight") {
    for (uint k = 0; k < 1000; k++)
        for (float carried : {RR_START, 1.0f, 20.0f}) {
            Vertex vertex = path_of(k, carried, 1e-4f);
            CHECK(path_roulette(&vertex, carried) == 1);
            CHECK(vertex.throughput.y == carried);
        }
}

TEST_CASE("no path is made to carry more than where roulette sets in, or 1 / RR_LEAST times as much") {
    for (uint k = 0; k < 1000; k++)
        for (float carried : {.04f, .01f, 1e-3f, 1e-5f}) {
            Vertex vertex = path_of(k, carried, 1);
            if (!path_roulette(&vertex, carried)) continue;
            CHECK(vertex.throughput.y <= RR_START * 1.00001f);
            CHECK(vertex.throughput.y <= carried / RR_LEAST * 1.00001f);
            CHECK(vertex.throughput.x == doctest::Approx(.5 * vertex.throughput.y));
        }
}

// What goes on is one of two values, so that the error of the mean is known: carried sqrt((1 - p) / p / n).
TEST_CASE("the mean of what paths carry stays") {
    constexpr uint n = 200000;
    for (uint bounces : {2u, 6u, PC_MOST_BOUNCES})
        for (float carried : {.04f, .01f, 1e-4f}) {
            double sum = 0;
            for (uint k = 0; k < n; k++) {
                Vertex vertex = path_of(k, carried, 1, bounces);
                if (path_roulette(&vertex, carried)) sum += double(vertex.throughput.y);
            }
            const float start = bounces > RR_EARLY ? RR_START_LATE : RR_START;
            const double p = std::fmax(double(carried / start), double(RR_LEAST));
            CHECK(std::abs(sum / n / double(carried) - 1) < 4 * std::sqrt((1 - p) / p / n));
        }
}

TEST_CASE("between mirrors roulette begins with a reflection") {
    uint ended = 0;
    for (uint k = 0; k < 1000; k++)
        for (uint level : {RR_LEVELS - 1, RR_LEVELS}) {
            Vertex vertex = path_of(k, .01f, 1, 0);
            vertex.flags = level << PC_LEVEL_SHIFT;
            const int goes_on = path_roulette(&vertex, .01f);
            if (level < RR_LEVELS) CHECK(goes_on);
            ended += !goes_on;
        }
    CHECK(std::abs(double(ended) - 800) < 4 * std::sqrt(1000 * .2 * .8));
}

TEST_CASE("counts of a path stop at their largest value and leave all other flags alone") {
    const uint others = PC_DIFFUSE | PC_SUFFIX | 7u << PC_STEP_SHIFT;
    uint flags = others;
    for (uint k = 1; k <= 1000; k++) {
        flags = count_bounce(count_level(flags));
        CHECK(path_bounces(flags) == std::min(k, PC_MOST_BOUNCES));
        CHECK(path_level(flags) == std::min(k, PC_MOST_LEVELS));
        CHECK(path_steps(flags) == 7u);
        CHECK((flags & 31u) == (PC_DIFFUSE | PC_SUFFIX));
    }
}

TEST_CASE("no roulette at the first diffuse bounce") {
    for (uint k = 0; k < 100; k++) {
        Vertex vertex = path_of(k, 1e-6f, 1e-6f);
        vertex.flags = 1u << PC_AB_SHIFT;
        CHECK(path_roulette(&vertex, 1e-6f) == 1);
    }
}
