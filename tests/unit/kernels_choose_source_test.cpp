// SPDX-License-Identifier: BSD-3-Clause
// Choosing one of few sources: as often as its importance says, right in the mean, and no importance is 0 where a
// source can give something (kernels_light_tree_test.cpp has many).
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>
#include "kernels/dialect/host.h"
namespace kernels {
#include "kernels/cal/cal_vm.h"
#include "kernels/sampling/sampler.h"
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/material/lobes.h"
#include "kernels/material/modifier.h"
#include "kernels/light/sources.h"
#include "kernels/light/relay_aperture.h"
#include "kernels/light/light_tree.h"
#include "kernels/light/choose_source.h"
}  // namespace kernels

using namespace kernels;

// Small spheres at random places of a room 10 x 10 x 10, of random power.
struct Lamps {
    std::vector<Source> sources;
    SceneTables s = {};
    Params par = {};
    std::mt19937 random{7};
    explicit Lamps(uint32_t count) {
        std::uniform_real_distribution<float> place(-5, 5), power(1, 10);
        for (uint32_t i = 0; i < count; i++) {
            Source& q = sources.emplace_back();
            q.kind = SK_SPHERE;
            q.centre = {place(random), place(random), place(random)};
            q.radius = .01f;
            q.area = 3.14159265f * .0001f;
            q.power = power(random);
            q.relay = NONE;
        }
        par.sources_count = count;
        s.sources = sources.data();
    }
    float importance(uint32_t i) const { return source_importance(&s, i, p, n, 0); }
    float3 p = F3(0, 0, -5), n = F3(0, 0, 1);
};

static Sampler random_stream(uint32_t i) { return sampler_start(3, 4, i, 0, 0); }

TEST_CASE("few sources: each is chosen as often as its importance says (Pearson's chi-square)") {
    const Lamps lamps(40);
    double sum = 0;
    for (uint32_t i = 0; i < 40; i++) sum += lamps.importance(i);
    std::vector<double> count(40);
    const int n = 40000;
    for (int k = 0; k < n; k++) {
        Sampler rnd = random_stream(uint32_t(k));
        uint32_t i = 0;
        const float inv_p = choose_source(&lamps.s, &lamps.par, lamps.p, lamps.n, 0, &rnd, &i);
        CHECK(inv_p == doctest::Approx(sum / lamps.importance(i)).epsilon(1e-5));
        count[i]++;
    }
    double chi2 = 0;
    for (uint32_t i = 0; i < 40; i++) {
        const double expected = n * lamps.importance(i) / sum;
        chi2 += (count[i] - expected) * (count[i] - expected) / expected;
    }
    CHECK(chi2 < 39 + 4 * std::sqrt(2 * 39.0));
}

TEST_CASE("the mean over choices is the sum over sources") {
    for (uint32_t sources : {2u, 32u}) {
        const Lamps lamps(sources);
        const auto value = [&](uint32_t i) {
            return double(lamps.importance(i)) * (1 + i % 3);
        };  // not what is promised
        double exact = 0, sum = 0, square = 0;
        for (uint32_t i = 0; i < sources; i++) exact += value(i);
        const int n = 20000;
        for (int k = 0; k < n; k++) {
            Sampler rnd = random_stream(uint32_t(k));
            uint32_t i = 0;
            const float inv_p = choose_source(&lamps.s, &lamps.par, lamps.p, lamps.n, 0, &rnd, &i);
            const double v = inv_p > 0 ? inv_p * value(i) : 0;
            sum += v;
            square += v * v;
        }
        const double mean = sum / n, error = std::sqrt((square / n - mean * mean) / n);
        CAPTURE(sources);
        CHECK(std::abs(mean - exact) < 4 * error + 1e-6 * exact);
        CHECK(error < .01 * exact);
    }
}

TEST_CASE("one source is chosen without a random number") {
    const Lamps lamps(1);
    Sampler rnd = random_stream(0), before = rnd;
    uint32_t i = 9;
    CHECK(choose_source(&lamps.s, &lamps.par, lamps.p, lamps.n, 0, &rnd, &i) == 1.0f);
    CHECK(i == 0);
    CHECK(rnd.dim == before.dim);
}

TEST_CASE("an aperture lets through what some point of the source sends through its rectangle") {
    // a mirror at x = 0, 2 wide and 1 high about the origin, that faces +x; from p in front of it to a ball behind it
    const Aperture aperture{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, 0};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    int blocked = 0, passing = 0;
    for (int k = 0; k < 200000; k++) {
        const double p[3] = {.01 + 3 * std::abs(any(random)), 4 * any(random), 4 * any(random)};
        const double c[3] = {-.01 - 3 * std::abs(any(random)), 4 * any(random), 4 * any(random)};
        const double r = .5 * std::abs(any(random));
        double e[3], length = 0;
        for (double& x : e) x = any(random);
        for (double x : e) length += x * x;
        length = std::max(1.0, std::sqrt(length));
        double q[3];  // a point of the ball
        for (int i = 0; i < 3; i++) q[i] = c[i] + r * e[i] / length;
        const double t = p[0] / (p[0] - q[0]), y = p[1] + t * (q[1] - p[1]), z = p[2] + t * (q[2] - p[2]);
        const bool through = q[0] < 0 && std::abs(y) < 1 && std::abs(z) < .5;
        double to[3], d = 0;
        for (int i = 0; i < 3; i++) {
            to[i] = c[i] - p[i];
            d += to[i] * to[i];
        }
        const float3 from = F3(float(p[0]), float(p[1]), float(p[2]));
        const float3 way = F3(float(to[0]), float(to[1]), float(to[2]));
        for (int tight : {0, 1}) {
            const bool shut = aperture_occludes(&aperture, from, way, float(r / std::sqrt(d)), tight);
            if (through) CHECK(!shut);
            passing += through;
            blocked += shut;
        }
    }
    CHECK(passing > 1000);
    CHECK(blocked > 50000);
}
