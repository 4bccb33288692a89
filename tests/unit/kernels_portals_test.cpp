// SPDX-License-Identifier: BSD-3-Clause
// Directions toward portals fall as their pdf says (Pearson's chi-square), a portal's view is about its projected
// solid angle, and mixed with the cosine the weights have the mean of the cosine whatever the lights are.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>
#include "kernels_tables.h"

using namespace kernels;

static const float3 mirrored = unit3(F3(1.5f, .2f, -1.2f));  // the sun, from the place before the wall

// A window in the wall at x = 4, a slanted patch of sun on the floor, and one that is not to be used between them; a
// glossy reflector on the floor, in which the sun is mirrored to the place before the wall.
struct Room : Tables {
    Room() {
        put_portal(F3(4, 1, 1.5f), F3(0, 2, 0), F3(0, 0, 1), F3(1, 0, 0));
        put_portal(F3(9, 9, 9), F3(0, 1, 0), F3(0, 0, 1), F3(1, 0, 0));
        put_portal(F3(1, 0, 0), F3(1, .5f, 0), F3(0, 1.5f, 0), F3(0, 0, -1));
        put_portal(F3(1.5f, .8f, 0), F3(0, 2, 0), F3(.05f, 0, 0), F3(0, 0, -1), .15f, mirrored);
        par.portals_count = 3;
        par.portal_pick[1] = 2;
        par.portal_pick[2] = 3;
        par.portal_light[2] = 200;
        par.portal_light[0] = 3;
        par.portal_light[1] = 5;
        par.portal_rest = 2;
        par.portal_most = .9f;
    }
    float light(float3 p, float3 n) const { return portals_light(&s, &par, p, n); }
};

static const float3 wall = F3(0, .3f, 1.2f), inward = F3(1, 0, 0);

static float2 pair_of(uint32_t k) {
    Sampler rnd = sampler_start(3, 4, k, 0, 0);
    return sample2(&rnd);
}

TEST_CASE("a view is about the projected solid angle, and nothing from behind") {
    const Room room;
    const Portal* window = portal_record(&room.s, &room.par, 0);
    const float3 to = sub3(F3(4, 1, 1.5f), wall);
    const double d2 = dot3(to, to), exact = 2 * to.x * to.x / (d2 * d2);
    CHECK(double(portal_view(window, wall, inward)) == doctest::Approx(exact).epsilon(1e-5));
    CHECK(portal_view(window, wall, F3(-1, 0, 0)) == 0);          // faces away
    CHECK(portal_view(window, F3(5, 1, 1.5f), inward) == 0);      // outdoors
    CHECK(portal_view(window, F3(2, 1, 1.2f), F3(0, 0, 1)) > 0);  // the horizon cuts it
    CHECK(portal_view(window, F3(2, 1, 2.5f), F3(0, 0, 1)) == 0);
    CHECK(room.light(wall, inward) > 3 * exact);
}

// Its highlight: a Gaussian of the half vector's slope.  The brightest of many points along the strip tells the law.
TEST_CASE("a glossy reflector is as bright as its highlight from there") {
    const Room room;
    const Portal* strip = portal_record(&room.s, &room.par, 2);
    const float3 sun = F3(mirrored.x, mirrored.y, -mirrored.z);
    int seen = 0;
    for (uint32_t k = 0; k < 2000; k++) {
        const float2 a = pair_of(2 * k), b = pair_of(2 * k + 1);
        const float3 p = F3(3 * a.x - 1, 4 * a.y - 1, .1f + 2 * b.x);
        double brightest = 0;
        for (int i = 0; i < 5 * 201; i++) {
            const float3 at = F3(1.475f + .0125f * float(i / 201), float(i % 201) / 100 - .2f, 0);
            const float3 to = sub3(at, p), half_way = sub3(sun, unit3(to));
            const double h = double(half_way.z), hh = double(dot3(half_way, half_way));
            if (h > 0) brightest = std::max(brightest, std::exp(-(hh - h * h) / (h * h * .15 * .15)));
        }
        float3 to = sub3(F3(1.5f, .8f, 0), p);
        const double found = double(portal_gloss(strip, p.z, &to));
        CHECK(found <= 1.02 * brightest + .01);
        if (brightest < .5) continue;
        CHECK(found > .5 * brightest);
        seen++;
    }
    CHECK(seen > 50);
    CHECK(portal_view(strip, wall, inward) > 1e-4f);
    CHECK(portal_view(strip, F3(3, .3f, 1.2f), F3(-1, 0, 0)) < 1e-6f);  // against the light
}

TEST_CASE("directions fall as their pdf says") {
    const Room room;
    const float total = room.light(wall, inward);
    constexpr int side = 40, fine = 6, draws = 1000000;
    // squares on the plane x = 1 before the wall, of 4 x 4 about its middle
    std::vector<double> expected(side * side), count(side * side);
    constexpr double step = 4. / (side * fine);
    for (int a = 0; a < side * fine; a++)
        for (int b = 0; b < side * fine; b++) {
            const double y = (a + .5) * step - 2, z = (b + .5) * step - 2, d2 = 1 + y * y + z * z;
            const float3 dir = unit3(F3(1, float(y), float(z)));
            const double pdf = double(portals_pdf(&room.s, &room.par, wall, inward, dir, total));
            expected[size_t(a / fine * side + b / fine)] += draws * pdf * step * step / (d2 * std::sqrt(d2));
        }
    for (int k = 0; k < draws; k++) {
        const float2 r = pair_of(uint32_t(k));
        const float3 dir = portals_sample(&room.s, &room.par, wall, inward, r.x * total, r.y);
        const double y = double(dir.y / dir.x) + 2, z = double(dir.z / dir.x) + 2;
        if (y < 0 || z < 0 || y >= 4 || z >= 4) continue;
        count[size_t(int(y / 4 * side) * side + int(z / 4 * side))]++;
    }
    // Squares on the portals' edges are left out: there the sum over fine squares is coarse.
    double chi2 = 0, freedom = 0;
    for (int a = 1; a + 1 < side; a++)
        for (int b = 1; b + 1 < side; b++) {
            double low = 1e30, high = 0;
            for (int i = -1; i <= 1; i++)
                for (int j = -1; j <= 1; j++) {
                    low = std::min(low, expected[size_t((a + i) * side + b + j)]);
                    high = std::max(high, expected[size_t((a + i) * side + b + j)]);
                }
            if (low < 20 || high > 1.5 * low) continue;
            const size_t k = size_t(a * side + b);
            chi2 += std::pow(count[k] - expected[k], 2) / expected[k];
            freedom++;
        }
    CHECK(freedom > 20);
    CHECK(std::abs(chi2 - freedom) < 5 * std::sqrt(2 * freedom));
}

TEST_CASE("mixed with the cosine they have the cosine's mean") {
    Room room;
    for (const float rest : {.5f, 2.f, 50.f})
        for (const float least : {0.f, .25f}) {
            CAPTURE(rest);
            CAPTURE(least);
            room.par.portal_rest = rest;
            room.par.portal_least = least;
            constexpr int total = 400000;
            double sums[3] = {}, squares[3] = {};
            for (int k = 0; k < total; k++) {
                Sampler rnd = sampler_start(1, 2, uint32_t(k), 0, 0);
                Mixture mixture;
                float3 dir;
                const double weight = double(sample_diffuse(&room.s, &room.par, wall, inward, &rnd, &mixture, &dir));
                const double values[3] = {weight, weight * double(dir.x), weight * (dir.z > 0)};
                for (int i = 0; i < 3; i++) {
                    sums[i] += values[i] / total;
                    squares[i] += values[i] * values[i] / total;
                }
            }
            const double means[3] = {1, 2. / 3, .5};
            for (int i = 0; i < 3; i++) {
                const double error = std::sqrt(std::max(0., squares[i] - sums[i] * sums[i]) / total) + 1e-6;
                CHECK(std::abs(sums[i] - means[i]) < 4 * error);
            }
        }
}
