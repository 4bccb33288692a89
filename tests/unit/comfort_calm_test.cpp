// SPDX-License-Identifier: BSD-3-Clause
// Noise that is taken for glare sources: two windows, and between them a dark wall of which few samples are bright.
// Early sums have wall pixels above the threshold, in both halves of the frames, that join the windows to one source.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "comfort/calm.h"
#include "comfort/certainty.h"
#include "comfort_pictures.h"

using namespace comfort;

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

TEST_CASE("DGP's interval is honest while noise joins two windows") {
    Settings settings;
    Needs needs;
    ColumnChoice choice;
    choice.names = {"DGP"};
    const std::vector<Column> columns = choose_columns(choice, settings, needs);
    Meter meter(settings, needs);
    image::Picture exact = fisheye_of(Wall::truth(), side, 60);
    const double truth = meter.measure(exact, "truth").dgp;

    const std::vector<int64_t> looks = {3, 5, 8, 12, 17, 25};
    std::vector<int> covered(looks.size(), 0);
    std::vector<double> plain(looks.size(), 0), unbiased(looks.size(), 0);
    const int seeds = 200;
    for (int seed = 1; seed <= seeds; ++seed) {
        Wall wall{uint32_t(seed)};
        Certainty certainty(meter, columns, true);
        image::Picture none = fisheye_of(std::vector<double>(side * side, 0), side, 60);
        certainty.frame0(meter.read(none, "frame 0"));
        size_t look = 0;
        for (int64_t n = 1; n <= looks.back(); ++n) {
            image::Picture p = fisheye_of(wall.next(), side, 60);
            Luminance lum = meter.read(p, "sum");
            certainty.add(lum, n);
            if (!certainty.due()) continue;
            const Measurement m = meter.measure(lum, "sum");
            certainty.look(lum, m);
            if (n != looks[look]) continue;
            const Estimate& e = certainty.estimate(0);
            const Interval off = e.around(0.05, n);
            covered[look] += !e.known() || (e.value + off.low <= truth && truth <= e.value + off.high);
            plain[look] += m.dgp / seeds, unbiased[look] += e.value / seeds;
            ++look;
        }
    }
    for (size_t k = 0; k < looks.size(); ++k) {
        INFO(looks[k] << " frames: " << covered[k] << " of " << seeds << " intervals hold " << truth << "; plain "
                      << plain[k] << ", without bias " << unbiased[k]);
        CHECK(covered[k] > 0.92 * seeds);
        CHECK(std::fabs(unbiased[k] - truth) < 0.002);
    }
    CHECK(plain[3] > truth + 0.004);  // that noise does what it is here for
}
