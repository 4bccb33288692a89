// SPDX-License-Identifier: BSD-3-Clause
// The guide's table and its sampling: directions fall as the chances say (Pearson's chi-square), weights are cosine
// over density, no direction is impossible, and what was not learned is not found.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>
#include "trace/guide_table.h"
namespace kernels {
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/highlights.h"
#include "kernels/guide.h"
}  // namespace kernels

using namespace kernels;

// A few cells with random moments, some of them zero.
struct Learned {
    std::vector<trace::GuideCell> cells;
    trace::Guide guide;
    SceneTables s = {};
    Params par = {};
    explicit Learned(uint32_t side, size_t count = 40) {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> even(0, 1);
        par.guide_grid = {-5, -5, -5, 4};
        for (size_t k = 0; k < count; k++) {
            trace::GuideCell cell;
            cell.key = guide_key(&par, F3(float(k) * .5f - 4, 1, 2), F3(0, 0, 1));
            cell.side = side;
            cell.light = double(k);
            for (uint32_t i = 0; i < side * side; i++) {
                const double x = even(random);
                cell.square.push_back(k == 0 || x < .3 ? 0 : std::pow(x, 8) * 1e4);
            }
            cells.push_back(cell);
        }
        guide = trace::guide_table(cells, par.guide_grid);
        par.guide_mask = guide.mask;
        s.guide = guide.words.data();
    }
    uint32_t record(size_t k) const { return guide_find(&s, &par, cells[k].key); }
    // Of a bin, read from the record in another way than sampling does.
    double chance(uint32_t cell, uint32_t row, uint32_t column) const {
        const uint32_t n = guide.words[cell + GUIDE_SIDE];
        const auto part = [&](uint32_t first, uint32_t k) {
            const auto begin = [&](uint32_t i) {
                return i == n ? 65536u : guide.words[first + i / 2] >> (i % 2 * 16) & 0xffffu;
            };
            return (begin(k + 1) - begin(k)) / 65536.;
        };
        const uint32_t first = cell + GUIDE_CHANCES;
        return part(first, row) * part(first + (n + n * row) / 2, column);
    }
};

// Shirley and Chiu's map backwards, in double: the place in the unit square of a direction in the axes of n.
struct Square {
    double x, y;
};
static Square square_of(float3 n, float3 dir) {
    float3 e1, e2;
    frame_of(n, &e1, &e2);
    const double a = dot3(dir, e1), b = dot3(dir, e2), pi = std::acos(-1.);
    double r = std::hypot(a, b), phi = std::atan2(b, a), u, v;
    if (phi < -pi / 4) phi += 2 * pi;
    if (phi < pi / 4) u = r, v = phi * r * 4 / pi;
    else if (phi < 3 * pi / 4) v = r, u = -(phi - pi / 2) * r * 4 / pi;
    else if (phi < 5 * pi / 4) u = -r, v = -(phi - pi) * r * 4 / pi;
    else v = -r, u = (phi - 3 * pi / 2) * r * 4 / pi;
    return {(u + 1) / 2, (v + 1) / 2};
}

TEST_CASE("directions fall into the bins as their chances say, evenly inside, with weights to match") {
    for (const uint32_t side : {2u, 8u, 16u})
        for (const float3 n : {F3(0, 0, 1), F3(0, 0, -1), F3(.6f, -.48f, .64f)}) {
            const Learned learned(side);
            const uint32_t cell = learned.record(3), fine = 2 * side;
            CAPTURE(side);
            std::vector<double> count(fine * fine);
            const int total = int(400 * fine * fine);
            std::mt19937 random(11);
            double weights = 0, cosines = 0, squares = 0;
            int odd = 0;
            for (int i = 0; i < total; i++) {
                float2 r;
                r.x = unit_float(uint32_t(random()));
                r.y = unit_float(uint32_t(random()));
                float3 dir;
                const double weight = guide_sample(&learned.s, &learned.par, cell, F3(0, 0, 0), n, r, &dir);
                const Square q = square_of(n, dir);
                const auto at = [&](double x, uint32_t k) { return std::min(uint32_t(std::max(x, 0.) * k), k - 1); };
                count[at(q.x, fine) * fine + at(q.y, fine)]++;
                const double chance = learned.chance(cell, at(q.x, side), at(q.y, side));
                odd += std::abs(weight * chance * side * side - 1) > 1e-4;  // rounded over the border of its bin
                weights += weight / total;
                squares += weight * weight / total;
                cosines += weight * dot3(dir, n) / total;
            }
            CHECK(odd < total / 500);
            const double error = std::sqrt((squares - 1) / total);
            CHECK(std::abs(weights - 1) < 4 * error);       // cos/pi over the hemisphere
            CHECK(std::abs(cosines - 2. / 3) < 4 * error);  // cos^2/pi

            double chi2 = 0, freedom = -1;
            for (uint32_t x = 0; x < fine; x++)
                for (uint32_t y = 0; y < fine; y++) {
                    const double expected = total * learned.chance(cell, x / 2, y / 2) / 4;
                    if (expected < 5) continue;
                    chi2 += std::pow(count[x * fine + y] - expected, 2) / expected;
                    freedom++;
                }
            CHECK(freedom > fine * fine / 2);
            CHECK(std::abs(chi2 - freedom) < 5 * std::sqrt(2 * freedom));
        }
}

TEST_CASE("no bin is impossible") {
    const Learned learned(16);
    for (size_t k = 0; k < learned.cells.size(); k++)
        for (uint32_t row = 0; row < 16; row++)
            for (uint32_t column = 0; column < 16; column++)
                CHECK(learned.chance(learned.record(k), row, column) > .05 / 256);
}

TEST_CASE("a cell in the dark is sampled by the cosine") {
    const Learned learned(8, 1);
    const uint32_t cell = learned.record(0);
    for (uint32_t k = 0; k < 64; k++) CHECK(learned.chance(cell, k / 8, k % 8) == 1. / 64);
}

TEST_CASE("each cell is found by its key, and no other") {
    const Learned learned(8);
    for (size_t k = 0; k < learned.cells.size(); k++) {
        const uint32_t cell = learned.record(k);
        REQUIRE(cell != NONE);
        CHECK(guide_light(&learned.s, cell) == float(k));
    }
    CHECK(guide_find(&learned.s, &learned.par, learned.cells[0].key + 1) == NONE);
    CHECK(guide_find(&learned.s, &learned.par, NONE) == NONE);
    CHECK(guide_key(&learned.par, F3(-6, 0, 0), F3(0, 0, 1)) == NONE);
    CHECK(guide_key(&learned.par, F3(1e30f, 0, 0), F3(0, 0, 1)) == NONE);
    CHECK(guide_key(&learned.par, F3(0, 0, 0), F3(0, 0, 1)) != guide_key(&learned.par, F3(0, 0, 0), F3(0, 0, -1)));
    CHECK(trace::guide_table({}, {0, 0, 0, 1}).mask == 0);
}
