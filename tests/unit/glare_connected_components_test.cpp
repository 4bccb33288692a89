// SPDX-License-Identifier: BSD-3-Clause
// Connected components against the definition: breadth-first over all pairs of pixels no farther apart than the reach.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cmath>
#include <random>
#include "glare/connected_components.h"

namespace {

view::View fisheye(char type, double angle) {
    view::View v;
    v.type = type;
    v.vh = v.vv = angle;
    return v;
}

std::vector<glare::Run> to_runs(const std::vector<char>& bright, const glare::Geometry& g) {
    std::vector<glare::Run> runs;
    for (size_t i = 0; i < bright.size(); ++i) {
        if (!bright[i]) continue;
        if (!runs.empty() && runs.back().start + runs.back().length == i && i % g.width) ++runs.back().length;
        else runs.push_back({uint32_t(i), 1, 0});
    }
    return runs;
}

// Labels by the definition, numbered by the first pixel, columns from the left, from the bottom.
std::vector<int> by_definition(const std::vector<char>& bright, const glare::Geometry& g, double reach) {
    std::vector<int> label(bright.size(), -1);
    std::vector<size_t> all;
    for (int x = 0; x < g.width; ++x)
        for (int y = 0; y < g.height; ++y)
            if (bright[g.index(x, y)]) all.push_back(g.index(x, y));
    std::vector<glare::Vec3> d(bright.size());
    for (size_t i : all) d[i] = g.direction(i);
    int groups = 0;
    for (size_t seed : all) {
        if (label[seed] >= 0) continue;
        std::vector<size_t> todo{seed};
        label[seed] = groups;
        while (!todo.empty()) {
            const size_t a = todo.back();
            todo.pop_back();
            for (size_t b : all)
                if (label[b] < 0 && dot(d[a], d[b]) >= std::cos(reach)) label[b] = groups, todo.push_back(b);
        }
        ++groups;
    }
    return label;
}

void compare(char type, double angle, int size, double reach, double density, bool blobs, unsigned seed) {
    const glare::Geometry g(fisheye(type, angle), size, size);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<char> bright(g.omega.size(), 0);
    for (int k = 0; k < (blobs ? 12 : 1); ++k) {
        const double cx = u(random) * size, cy = u(random) * size, r = u(random) * size / 8;
        for (size_t i = 0; i < bright.size(); ++i)
            if (g.valid(i) && (blobs ? std::hypot(g.x_of(i) - cx, g.y_of(i) - cy) < r : u(random) < density))
                bright[i] = 1;
    }
    std::vector<glare::Run> runs = to_runs(bright, g);
    glare::ConnectedComponents components(g, reach);
    components.label(runs, 0);
    const std::vector<int> want = by_definition(bright, g, reach);
    long wrong = 0;
    for (const glare::Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) wrong += int(r.group) != want[p];
    INFO(type << " " << angle << " size " << size << " reach " << reach << " density " << density << " seed " << seed);
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("components are those of the definition") {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        for (double density : {0.002, 0.01, 0.05, 0.4}) compare('a', 180, 72, 0.1, density, false, seed);
        for (double reach : {0.02, 0.05, 0.1, 0.3}) compare('a', 180, 72, reach, 0, true, seed);
        compare('h', 180, 64, 0.1, 0.02, false, seed);
        compare('h', 180, 64, 0.1, 0, true, seed);
        compare('v', 80, 64, 0.1, 0.005, false, seed);
        compare('s', 120, 64, 0.1, 0, true, seed);
        compare('a', 180, 120, 0.02, 0.05, false, seed);  // 11,000 cells
    }
}

TEST_CASE("a reach of pi or more makes one group, no pixel none") {
    const glare::Geometry g(fisheye('a', 180), 32, 32);
    std::vector<glare::Run> runs{{g.width * 16u + 3u, 2, 0}, {g.width * 17u + 25u, 1, 0}};
    CHECK(glare::ConnectedComponents(g, 3.3).label(runs, 1) == 1);
    std::vector<glare::Run> none;
    CHECK(glare::ConnectedComponents(g, 0.1).label(none, 1) == 0);
}
