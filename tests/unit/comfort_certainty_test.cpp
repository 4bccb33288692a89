// SPDX-License-Identifier: BSD-3-Clause
// Intervals, and metrics without bias, of streams whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

#include "base/error.h"
#include "comfort/certainty.h"
#include "comfort/interval.h"
#include "comfort/precision.h"
#include "comfort/halves.h"
#include "comfort/rammg.h"
#include "comfort_study.h"

using namespace comfort;

namespace {

constexpr int side = 12;

// A stream of sums: every pixel of frame k > 0 is its mean times a sample of mean 1, and frame 0 a tenth of the mean
// times the mean of 8 samples, of which frames up to 8 show one half or the other and which frames above 8 correct
// (paper section 7).  What is bright is seen exactly.
class Stream {
public:
    using Sample = std::function<double(std::mt19937&)>;
    Stream(std::vector<double> mean, Sample sample, uint32_t seed, double exact_above = 5000)
        : mean_(std::move(mean)),
          sample_(std::move(sample)),
          exact_above_(exact_above),
          random_(seed),
          frame0_(mean_.size()),
          half_off_(mean_.size()),
          sum_(mean_.size()) {
        for (size_t i = 0; i < mean_.size(); ++i)
            for (int k = 0; k < image::direct_samples; ++k) {
                const double own = exact(i) ? mean_[i] / image::direct_samples
                                            : direct * mean_[i] * sample_(random_) / image::direct_samples;
                frame0_[i] += own, half_off_[i] += 2 * k < image::direct_samples ? own : -own;
            }
    }
    std::vector<double> frame0() const { return frame0_; }
    std::vector<double> next() {
        ++n_;
        std::vector<double> out;
        for (size_t i = 0; i < mean_.size(); ++i) {
            if (!exact(i)) sum_[i] += (1 - direct) * mean_[i] * sample_(random_);
            if (n_ <= image::direct_samples) sum_[i] += image::in_first_half(n_) ? half_off_[i] : -half_off_[i];
            else if (!exact(i)) sum_[i] += direct * mean_[i] * sample_(random_) - frame0_[i];
            out.push_back(frame0_[i] + sum_[i] / double(n_));
        }
        return last_ = out;
    }
    std::vector<double> last() const { return last_; }
    int64_t frames() const { return n_; }

private:
    static constexpr double direct = 0.1;
    bool exact(size_t i) const { return mean_[i] > exact_above_; }
    std::vector<double> mean_;
    Sample sample_;
    double exact_above_;
    std::mt19937 random_;
    std::vector<double> frame0_, half_off_, sum_, last_;
    int64_t n_ = 0;
};

double gaussian(std::mt19937& random) { return std::normal_distribution<double>(1, 1)(random); }

// Mean 1, standard deviation 4, skewness 76: a few samples make most of a sum.
double heavy(std::mt19937& random) {
    const double variance = std::log(17.);
    return std::lognormal_distribution<double>(-variance / 2, std::sqrt(variance))(random);
}

// Mean 1, deviation 3.2, skewness 4.7: one sample in five is not 0, as of a small region that few paths light.
double skew(std::mt19937& random) {
    return std::uniform_real_distribution<double>(0, 1)(random) < 0.2
               ? std::exponential_distribution<double>(0.2)(random)
               : 0;
}

// A room: a window of 8000 cd/m2, walls that fall off to the right, and two regions of a screen.
std::vector<double> room() {
    std::vector<double> mean;
    for (int r = 0; r < side; ++r)
        for (int x = 0; x < side; ++x) {
            const bool window = r >= 3 && r < 6 && x >= 3 && x < 6;
            mean.push_back(window ? 8000 : r >= 7 && x >= 8 ? (x >= 10 ? 200 : 40) : 800 - 15 * x);
        }
    return mean;
}

image::MaskSet screen() {
    image::MaskSet set;
    set.width = set.height = side;
    set.masks = {{"low", std::vector<float>(side * side, 0)}, {"high", std::vector<float>(side * side, 0)}};
    for (int r = 7; r < 10; ++r) {
        for (int x = 8; x < 10; ++x) set.masks[0].coverage[size_t(r * side + x)] = 1;
        for (int x = 10; x < 12; ++x) set.masks[1].coverage[size_t(r * side + x)] = 1;
    }
    return set;
}

struct Room {
    Settings settings;
    Needs needs;
    std::vector<Column> columns;
    std::unique_ptr<Meter> meter;
    std::vector<double> truth;
    explicit Room(const std::vector<std::string>& names, DgpForm form = DgpForm::merged) {
        settings.dgp_form = form;
        ColumnChoice choice;
        choice.names = names;
        choice.regions = {"low", "high"};
        choice.pairs = {{"low", "high", "screen"}};
        columns = choose_columns(choice, settings, needs);
        meter = std::make_unique<Meter>(settings, needs, screen());
        image::Picture exact = fisheye_of(room(), side);
        const Measurement m = meter->measure(exact, "room");
        for (const Column& c : columns) truth.push_back(c.value(m));
    }
    // Looks at a stream until done(certainty) or so many frames.
    void watch(Stream& stream, int64_t most, Certainty& certainty, const std::function<bool()>& done) {
        image::Picture p = fisheye_of(stream.frame0(), side);
        certainty.frame0(meter->read(p, "frame 0"));
        while (stream.frames() < most) {
            p = fisheye_of(stream.next(), side);
            Luminance lum = meter->read(p, "sum");
            certainty.add(lum, stream.frames());
            if (!certainty.due()) continue;
            const Measurement m = meter->measure(lum, "sum");
            certainty.look(lum, m);
            if (done()) return;
        }
    }
};

}  // namespace

// Noise of deviation s alone has a contrast in proportion to s, and halves of the frames have sqrt 2 of it.
TEST_CASE("RAMMG without the contrast of noise") {
    const int n = 128;
    view::View view;
    view.vh = view.vv = 60;
    const Geometry geometry(view, n, n);
    std::mt19937 random(5);
    std::vector<float> exact, first, whole;
    for (int i = 0; i < n * n; ++i) {
        exact.push_back(float(100 + 40 * (i % n > n / 2)));
        const double a = 5 * (gaussian(random) - 1), b = 5 * (gaussian(random) - 1);
        first.push_back(float(exact.back() + a)), whole.push_back(float(exact.back() + (a + b) / 2));
    }
    Batches batches;
    batches.add({n, n, first.data()}, 8, 16);
    batches.add({n, n, whole.data()}, 16, 16);
    Halves halves;
    halves.take(batches);
    double of_halves[Halves::count], mean = 0;
    for (int k = 0; k < Halves::count; ++k) {
        GreyPicture half;
        halves.pictures().picture(k, half);
        of_halves[k] = rammg(half.luminance(), geometry);
        mean += of_halves[k] / Halves::count;
    }
    const double truth = rammg({n, n, exact.data()}, geometry), noisy = rammg({n, n, whole.data()}, geometry);
    CHECK(mean - truth == doctest::Approx(std::sqrt(2) * (noisy - truth)).epsilon(0.01));
    CHECK(Halves::without_bias(noisy, of_halves, std::sqrt(2)) == doctest::Approx(truth).epsilon(0.05));
}

// Each bright pixel by itself is a source here, so that the squares of noisy pixels are too large by their variance.
TEST_CASE("DGP without the bias of squares") {
    Room room({"DGP", "RAMMG"}, DgpForm::pixel);
    const int seeds = 600, frames = 17;
    double unbiased = 0, squares = 0, taken_off = 0, squares_off = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        Stream stream(::room(), gaussian, uint32_t(seed), 1e9);
        Certainty certainty(*room.meter, room.columns, false);
        room.watch(stream, frames, certainty, [] { return false; });
        image::Picture p = fisheye_of(stream.last(), side);
        const double value = certainty.estimate(0).value, off = room.meter->measure(p, "sum").dgp - value;
        unbiased += value / seeds, squares += value * value / seeds;
        taken_off += off / seeds, squares_off += off * off / seeds;
    }
    const double error = std::sqrt((squares - unbiased * unbiased) / seeds);
    CHECK(std::fabs(unbiased - room.truth[0]) < 3 * error);
    CHECK(taken_off > 5 * std::sqrt((squares_off - taken_off * taken_off) / seeds));
}

TEST_CASE("without noise the de-biased metrics are the plain ones, and no interval is claimed") {
    Room room({"DGP", "RAMMG"});
    Stream quiet(
        ::room(), [](std::mt19937&) { return 1.; }, 1);
    Certainty certainty(*room.meter, room.columns, true);
    room.watch(quiet, 40, certainty, [] { return false; });
    for (size_t c = 0; c < 2; ++c) {
        CHECK(certainty.estimate(c).value == doctest::Approx(room.truth[c]).epsilon(1e-5));
        CHECK(!certainty.estimate(c).known());  // no spread at all is not believed
        CHECK(std::isnan(certainty.estimate(c).half_width(0.05, 40)));
    }
}

// Each seed is watched until the rule holds; then the truth must lie in the 95 % interval in 92 to 98 of 100 cases.
TEST_CASE("intervals cover the truth when the rule stops, also with heavy tails") {
    struct Case {
        const char* rule;
        double (*sample)(std::mt19937&);
    };
    for (const Case& c : {Case{"Ev 0.6%", gaussian}, Case{"Ev 2.5%", heavy}, Case{"DGP 0.003", gaussian},
                          Case{"low.TAL 25%", skew}, Case{"screen.CR 35%", skew}}) {
        const std::string rule = c.rule;
        const std::string metric = rule.substr(0, rule.find(' '));
        Room room({metric});
        int stopped = 0, covered = 0;
        const int seeds = 600;
        for (int seed = 1; seed <= seeds; ++seed) {
            PrecisionRule until(rule);
            Stream stream(::room(), c.sample, uint32_t(1000 + seed));
            Certainty certainty(*room.meter, room.columns, true);
            bool held = false;
            room.watch(stream, 400, certainty, [&] {
                const Estimate& e = certainty.estimate(0);
                return held = until.holds(certainty.looks(), stream.frames(), {e}, e);
            });
            if (!held) continue;
            const Estimate& e = certainty.estimate(0);
            const Interval off = e.around(PrecisionRule::outside, stream.frames());
            ++stopped;
            covered += e.value + off.low <= room.truth[0] && room.truth[0] <= e.value + off.high;
        }
        INFO(rule << ": " << covered << " of " << stopped);
        MESSAGE(rule << ": " << covered << " of " << stopped);
        CHECK(stopped > seeds / 2);
        CHECK(covered > 0.92 * stopped);
        CHECK(covered < 0.98 * stopped);
    }
}

// Two halves tell a pixel's variance with one degree of freedom: of a single pixel's error they know little.
TEST_CASE("an interval knows how few pixels its error is of") {
    const std::vector<double> exact(side * side, 1000);
    for (const int pixels : {1, 3}) {
        Study study{"Ev", {3, 5, 8, 12}, 400};
        study.run<Even>(exact, [&](uint32_t seed) { return Even(exact, {4, 4 + pixels, 5, 6, 2e4}, seed); });
        for (size_t k = 0; k < study.looks.size(); ++k) {
            INFO(pixels << " pixels, " << study.told(k));
            CHECK(study.covered[k] > (pixels == 1 ? .89 : .92) * study.seeds);
            CHECK(!study.too_wide(k, 2.5));
        }
    }
}

// Then halves have sqrt 2 of it, and what is taken off as if they had more is too little by more than a third.
TEST_CASE("an early interval of RAMMG allows for noise that is all of the contrast") {
    constexpr int wall_side = 24;
    const std::vector<double> wall(size_t(wall_side * wall_side), 1000);
    Study study{"RAMMG", {3, 5}, 100};
    study.run<Even>(wall, [&](uint32_t seed) { return Even(wall, {0, wall_side, 0, wall_side, 400}, seed); });
    for (size_t k = 0; k < study.looks.size(); ++k) {
        INFO(study.told(k));
        CHECK(study.covered[k] > .92 * study.seeds);
        CHECK(study.half_width[k] < .75 * study.plain[k]);
    }
}

TEST_CASE("rules of widths and of the class") {
    CHECK_THROWS_AS(PrecisionRule(""), base::Error);
    CHECK_THROWS_AS(PrecisionRule("DGP"), base::Error);
    PrecisionRule rule("DGP 0.01, class");
    CHECK(rule.tolerances().size() == 1);
    CHECK(rule.asks_class());

    Estimate e{0.30, 0.003, 15, 0, false, 64};
    CHECK(rule.holds(5, 64, {e}, e));
    CHECK(!rule.holds(5, 63, {e}, e));  // too early
    e.tails = true;
    CHECK(!rule.holds(5, 64, {e}, e));
    e = {0.349, 0.003, 15, 0, false, 64};  // crosses 0.35
    CHECK(!rule.holds(5, 64, {e}, e));
    e = {0.337, 0.003, 15, 0, false, 64};  // does so at the level of a late look
    CHECK(rule.holds(2, 64, {e}, e));
    CHECK(!rule.holds(30, 64, {e}, e));
    CHECK(dgp_class(0.34) == 0);
    CHECK(dgp_class(0.35) == 1);
    CHECK(dgp_class(0.40) == 2);
    CHECK(dgp_class(0.45) == 2);
    CHECK(dgp_class(0.46) == 3);
}
