// SPDX-License-Identifier: BSD-3-Clause
// Russian roulette (kernels/integrator/continue.h, docs/decisions/0029-roulette.md): it keeps the mean of what a path
// carries, makes none carry more than where roulette sets in, and leaves alone what carries more, however dark its
// surfaces.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>
namespace device {
#include "kernels/dialect/compat_host.h"
#include "kernels/all.h"
}  // namespace device
using namespace device;

// A path behind its second diffuse bounce.
static Vertex path_of(uint k, float carried, float weight) {
    Vertex vertex = {};
    vertex.flags = 2u << PC_AB_SHIFT;
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
    for (float carried : {.04f, .01f, 1e-4f}) {
        double sum = 0;
        for (uint k = 0; k < n; k++) {
            Vertex vertex = path_of(k, carried, 1);
            if (path_roulette(&vertex, carried)) sum += double(vertex.throughput.y);
        }
        const double p = std::fmax(double(carried / RR_START), double(RR_LEAST));
        CHECK(std::abs(sum / n / double(carried) - 1) < 4 * std::sqrt((1 - p) / p / n));
    }
}

TEST_CASE("no roulette at the first diffuse bounce") {
    for (uint k = 0; k < 100; k++) {
        Vertex vertex = path_of(k, 1e-6f, 1e-6f);
        vertex.flags = 1u << PC_AB_SHIFT;
        CHECK(path_roulette(&vertex, 1e-6f) == 1);
    }
}
