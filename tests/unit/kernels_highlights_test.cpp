// SPDX-License-Identifier: BSD-3-Clause
// Directions toward highlights fall as their pdf says (Pearson's chi-square), only rectangles that can be met are
// aimed at, and mixed with the cosine and windows the weights have the mean of the cosine.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>
#include "kernels_tables.h"

using namespace kernels;

// A floor 4 x 4 about the origin, a tilted sheet in the same place and a floor far away, all in the sun; a window in
// the wall at x = -2.
struct Room : Tables {
    const float3 sun = unit3(F3(-.5f, .3f, .8f));
    Room() {
        add(F3(-2, -2, 0), F3(4, 0, 0), F3(0, 4, 0), F3(0, 0, 1), .05f);
        add(F3(-2, -2, -1), F3(4, 0, 2), F3(0, 4, 0), unit3(F3(-.5f, 0, 1)), .15f);
        add(F3(90, 90, 0), F3(4, 0, 0), F3(0, 4, 0), F3(0, 0, 1), .1f);
        s.highlights = highlights.data();
        par.highlights_count = uint32_t(highlights.size());
        put_portal(F3(-2, 0, 1.5f), F3(0, 2, 0), F3(0, 0, 1), F3(-1, 0, 0));
        par.portal_light[0] = 1;
    }
    void add(float3 corner, float3 u, float3 v, float3 n, float alpha) {
        const float3 dir = sub3(sun, scale3(n, 2 * dot3(n, sun)));
        highlights.push_back({packed(corner), packed(u), packed(v), packed(n), packed(dir), alpha * alpha});
    }
};

static float2 pair_of(std::mt19937& random) {
    float2 r;
    r.x = unit_float(uint32_t(random()));
    r.y = unit_float(uint32_t(random()));
    return r;
}

static const float3 ceiling = F3(.2f, -.1f, 1.5f), down = F3(0, 0, -1);

TEST_CASE("what can be met from a place is aimed at, and nothing else") {
    const Room room;
    CHECK(highlights_met(&room.s, &room.par, ceiling, down) == 3);
    CHECK(highlights_met(&room.s, &room.par, ceiling, F3(0, 0, 1)) == 0);   // its back
    CHECK(highlights_met(&room.s, &room.par, F3(0, 0, -2), down) == 0);     // below
    CHECK(highlights_met(&room.s, &room.par, F3(92, 92, .5f), down) == 4);  // far away
    CHECK(highlights_met(&room.s, &room.par, F3(0, 40, 1.5f), down) == 0);  // beside
    CHECK(highlights_count(0) == 0);
    CHECK(highlights_count(0xd) == 3);
}

// Bins of equal solid angle about the mirrored sun of the floor; what they should hold by midpoints of finer ones.
TEST_CASE("directions toward highlights fall as their pdf says") {
    const Room room;
    for (const uint32_t met : {1u, 2u, 3u, 7u}) {
        CAPTURE(met);
        constexpr int rings = 24, sectors = 12, fine = 24, total = 400000;
        const float3 axis = F3(room.sun.x, room.sun.y, -room.sun.z);
        float3 e1, e2;
        orthonormal_basis(axis, &e1, &e2);
        const double pi = std::acos(-1.);
        const auto ring_end = [&](double k) { return std::cos(pi * std::pow(k / rings, 1.5)); };

        std::vector<double> expected(rings * sectors), count(rings * sectors);
        double whole = 0;
        for (int r = 0; r < rings; r++)
            for (int i = 0; i < sectors; i++)
                for (int a = 0; a < fine; a++)
                    for (int b = 0; b < fine; b++) {
                        const double top = ring_end(r), bottom = ring_end(r + 1);
                        const double z = top + (bottom - top) * (a + .5) / fine, sn = std::sqrt(1 - z * z);
                        const double phi = 2 * pi * (i + (b + .5) / fine) / sectors;
                        const float3 dir =
                            unit3(add3(scale3(axis, float(z)), add3(scale3(e1, float(sn * std::cos(phi))),
                                                                    scale3(e2, float(sn * std::sin(phi))))));
                        const double part =
                            highlights_pdf(&room.s, met, dir) * (top - bottom) * 2 * pi / sectors / fine / fine;
                        expected[size_t(r * sectors + i)] += total * part;
                        whole += part;
                    }
        CHECK(whole == doctest::Approx(1).epsilon(.002));

        std::mt19937 random(3);
        for (int k = 0; k < total; k++) {
            const float2 r = pair_of(random);
            const float3 dir = highlights_sample(&room.s, met, r.x, r.y);
            CHECK(highlights_pdf(&room.s, met, dir) > 0);
            const double angle = std::acos(std::min(1., double(dot3(dir, axis))));
            double phi = std::atan2(dot3(dir, e2), dot3(dir, e1)) / (2 * pi);
            phi -= std::floor(phi);
            const int ring = std::min(int(std::pow(angle / pi, 1 / 1.5) * rings), rings - 1);
            count[size_t(ring * sectors + std::min(int(phi * sectors), sectors - 1))]++;
        }
        double chi2 = 0, freedom = -1;
        for (size_t k = 0; k < count.size(); k++) {
            if (expected[k] < 20) continue;
            chi2 += std::pow(count[k] - expected[k], 2) / expected[k];
            freedom++;
        }
        CHECK(freedom > 20);
        CHECK(std::abs(chi2 - freedom) < 5 * std::sqrt(2 * freedom));
    }
}

TEST_CASE("mixed with the cosine and windows they have the cosine's mean") {
    Room room;
    for (const float windows : {0.f, .5f})
        for (const float shine : {0.f, .0625f, .5f}) {
            CAPTURE(windows);
            CAPTURE(shine);
            room.par.portals_count = windows > 0 ? 1 : 0;
            room.par.portal_least = room.par.portal_most = windows;
            room.par.highlight_share = shine;
            constexpr int total = 400000;
            double sums[3] = {}, squares[3] = {};
            for (int k = 0; k < total; k++) {
                Sampler rnd = sampler_start(1, 2, uint32_t(k), 0, 0);
                Mixture mixture;
                float3 dir;
                const double weight = sample_diffuse(&room.s, &room.par, ceiling, down, &rnd, &mixture, &dir);
                const double seen = dot3(dir, F3(room.sun.x, room.sun.y, -room.sun.z)) > .98f;
                const double c = dot3(dir, down), values[3] = {weight, weight * c, weight * seen};
                for (int i = 0; i < 3; i++) {
                    sums[i] += values[i] / total;
                    squares[i] += values[i] * values[i] / total;
                }
            }
            const double cap = (1 - .98 * .98) * room.sun.z;  // cosine over pi in the cone about the mirrored sun
            const double means[3] = {1, 2. / 3, cap};
            for (int i = 0; i < 3; i++) {
                const double error = std::sqrt(std::max(0., squares[i] - sums[i] * sums[i]) / total) + 1e-6;
                CHECK(std::abs(sums[i] - means[i]) < 4 * error);
            }
        }
}
