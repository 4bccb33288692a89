// SPDX-License-Identifier: BSD-3-Clause
// Noise that is taken for glare sources: two windows, and between them a dark wall of which few samples are bright.
// Early sums have wall pixels above the threshold, in both halves of the frames, that join the windows to one source.
// And noise that decides about single pixels, or about many, which really stand at the threshold.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "report_study.h"

using namespace glare;
using namespace report;

namespace {

constexpr int side = 44;
constexpr double window_cdm2 = 6000, wall_cdm2 = 300, glimpse = 0.01;

// Even sides: the mean of a window's columns and rows, whose whole part is where its position index is taken, is half
// odd.
bool in_window(int x, int row) { return row >= 12 && row < 30 && ((x >= 4 && x < 16) || (x >= 28 && x < 40)); }

// Windows are seen exactly.  Of the wall's samples one in a hundred is a hundred times as bright as the mean.
class Wall {
public:
    explicit Wall(uint32_t seed) : random_(seed), sum_(side * side) {}
    std::vector<double> next() {
        ++n_;
        std::vector<double> mean(sum_.size());
        for (int i = 0; i < side * side; ++i) {
            const bool bright = std::uniform_real_distribution<double>(0, 1)(random_) < glimpse;
            sum_[size_t(i)] += in_window(i % side, i / side) ? window_cdm2 : bright ? wall_cdm2 / glimpse : 0;
            mean[size_t(i)] = sum_[size_t(i)] / double(n_);
        }
        return mean;
    }
    static std::vector<double> truth() {
        std::vector<double> out;
        for (int i = 0; i < side * side; ++i) out.push_back(in_window(i % side, i / side) ? window_cdm2 : wall_cdm2);
        return out;
    }

private:
    std::mt19937 random_;
    std::vector<double> sum_;
    int64_t n_ = 0;
};

}  // namespace

TEST_CASE("DGP's interval holds while noise joins two windows") {
    Study study{"DGP", {3, 4, 8, 11, 16, 23}, 200};
    study.run<Wall>(Wall::truth(), [](uint32_t seed) { return Wall(seed); });
    for (size_t k = 0; k < study.looks.size(); ++k) {
        INFO(study.told(k));
        CHECK(study.covered[k] > 0.92 * study.seeds);
        CHECK(!study.too_wide(k, study.looks[k] < 8 ? 15 : 3));  // few frames have few degrees of freedom
        CHECK(std::fabs(study.unbiased[k] - study.truth) < 0.002);
    }
    CHECK(study.plain[3] > study.truth + 0.004);  // that noise does what it is here for
}

// Sources begin at 2000 cd/m2: DGP makes a step where a pixel crosses that.  Where nothing else has noise, the bias
// that replicates show is the side of the whole, which is noise: taken off, 77 to 90 % of intervals held.  The bound is
// 95 % less three standard deviations of 400 runs.
TEST_CASE("DGP's interval holds the step of a pixel at the threshold") {
    std::vector<double> exact = Wall::truth();
    exact[20 * side + 22] = 2000.1;
    Study study{"DGP", {23, 33, 47, 66, 93}, 400};
    study.run<Even>(exact, [&](uint32_t seed) { return Even(exact, {20, 25, 18, 23, 800}, seed); });
    for (size_t k = 0; k < study.looks.size(); ++k) {
        INFO(study.told(k));
        CHECK(study.covered[k] > 0.917 * study.seeds);
        CHECK(!study.too_wide(k, 2));
        CHECK(study.tails[k] < .1 * study.seeds);  // it is no matter of samples: -until may stop
    }
}

// A wall that grows darker from one window to the other: many pixels are ambiguous, and each moves DGP by little.  The
// filter's bias at the slope, a third of the error, costs coverage.
TEST_CASE("DGP's interval of many pixels near the threshold") {
    std::vector<double> exact = Wall::truth();
    for (int row = 14; row < 28; ++row)
        for (int x = 16; x < 28; ++x) exact[size_t(row * side + x)] = 4100 - 250 * (x - 16) + 10 * (row - 20);
    Study study{"DGP", {23, 33, 47, 66, 93}, 400};
    study.run<Even>(exact, [&](uint32_t seed) { return Even(exact, {16, 28, 14, 28, 1000}, seed); });
    for (size_t k = 0; k < study.looks.size(); ++k) {
        INFO(study.told(k));
        CHECK(study.covered[k] > 0.85 * study.seeds);
        CHECK(!study.too_wide(k, 1.5));
    }
}
