// SPDX-License-Identifier: BSD-3-Clause
// Intervals, and metrics without bias, of streams whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

#include "base/error.h"
#include "comfort/certainty.h"
#include "comfort/precision.h"
#include "comfort/rammg.h"
#include "comfort/student.h"
#include "comfort/unbiased.h"

using namespace comfort;

namespace {

constexpr int side = 12;

image::Picture picture(const std::vector<double>& cdm2, int width = side) {
    image::Picture p;
    p.width = width;
    p.height = int(cdm2.size()) / width;
    for (double v : cdm2)
        for (int c = 0; c < 3; ++c) p.rgb.push_back(float(v / cdm2_per_grey));
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 180;
    p.header.view = v;
    return p;
}

// A stream of sums: every pixel of frame k > 0 is its mean times a sample of mean 1, and frame 0 a tenth of the mean
// times the mean of 16 samples, which frames above 16 correct (paper section 7).  What is bright is seen exactly.
class Stream {
public:
    using Sample = std::function<double(std::mt19937&)>;
    Stream(std::vector<double> mean, Sample sample, uint32_t seed, double exact_above = 5000)
        : mean_(std::move(mean)),
          sample_(std::move(sample)),
          exact_above_(exact_above),
          random_(seed),
          frame0_(mean_.size()),
          sum_(mean_.size()) {
        for (size_t i = 0; i < mean_.size(); ++i)
            for (int k = 0; k < image::direct_samples; ++k)
                frame0_[i] += exact(i) ? mean_[i] / image::direct_samples
                                       : direct * mean_[i] * sample_(random_) / image::direct_samples;
    }
    std::vector<double> frame0() const { return frame0_; }
    std::vector<double> next() {
        ++n_;
        std::vector<double> out;
        for (size_t i = 0; i < mean_.size(); ++i) {
            if (!exact(i)) sum_[i] += (1 - direct) * mean_[i] * sample_(random_);
            if (!exact(i) && n_ > image::direct_samples) sum_[i] += direct * mean_[i] * sample_(random_) - frame0_[i];
            out.push_back(frame0_[i] + sum_[i] / double(n_));
        }
        return out;
    }
    int64_t frames() const { return n_; }

private:
    static constexpr double direct = 0.1;
    bool exact(size_t i) const { return mean_[i] > exact_above_; }
    std::vector<double> mean_;
    Sample sample_;
    double exact_above_;
    std::mt19937 random_;
    std::vector<double> frame0_, sum_;
    int64_t n_ = 0;
};

double gaussian(std::mt19937& random) { return std::normal_distribution<double>(1, 1)(random); }

// Mean 1, standard deviation 4, skewness 76: a few samples make most of a sum.
double heavy(std::mt19937& random) {
    const double variance = std::log(17.);
    return std::lognormal_distribution<double>(-variance / 2, std::sqrt(variance))(random);
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
        choice.certain = true;
        columns = choose_columns(choice, settings, needs);
        meter = std::make_unique<Meter>(settings, needs, screen());
        image::Picture exact = picture(room());
        const Measurement m = meter->measure(exact, "room");
        for (const Column& c : columns) truth.push_back(c.value(m));
    }
    // Looks at a stream until done(certainty) or so many frames.
    void watch(Stream& stream, int64_t most, Certainty& certainty, const std::function<bool()>& done) {
        image::Picture p = picture(stream.frame0());
        certainty.frame0(meter->read(p, "frame 0"));
        while (stream.frames() < most) {
            p = picture(stream.next());
            Luminance lum = meter->read(p, "sum");
            certainty.add(lum, stream.frames());
            if (!certainty.due()) continue;
            Measurement m = meter->measure(lum, "sum");
            certainty.look(m);
            if (done()) return;
        }
    }
};

}  // namespace

TEST_CASE("Student's quantiles are those of the tables") {
    CHECK(student_quantile(0.05, 1) == doctest::Approx(12.7062047).epsilon(1e-7));
    CHECK(student_quantile(0.05, 5) == doctest::Approx(2.5705818).epsilon(1e-7));
    CHECK(student_quantile(0.05, 15) == doctest::Approx(2.1314495).epsilon(1e-7));
    CHECK(student_quantile(0.01, 30) == doctest::Approx(2.7499957).epsilon(1e-7));
    CHECK(student_quantile(0.05, 1e7) == doctest::Approx(1.9599640).epsilon(1e-5));
    CHECK(std::isinf(student_quantile(0.05, 0)));
}

// Frame k is k everywhere: L'(n) = (n+1)/2, and a batch a+1..b has the mean (a+b+1)/2.
TEST_CASE("batches are what the running means say, and never more than 16") {
    Batches batches;
    for (int64_t n = 1; n <= 100; ++n) {
        std::vector<float> mean(4, float(n + 1) / 2);
        batches.add({2, 2, mean.data()}, n);
        REQUIRE(batches.count() == size_t(std::min<int64_t>(n, 16)));
        REQUIRE(batches.frames() == n);
    }
    int64_t sum = 0;
    for (size_t k = 0; k < batches.count(); ++k) {
        CHECK(batches.begin(k) == sum);
        sum += batches.frames(k);
        CHECK(batches.frames(k) <= 16);
        GreyPicture rest;
        batches.without(k, rest);
        const double a = double(batches.begin(k)), b = a + double(batches.frames(k));
        CHECK(rest.grey[3] == doctest::Approx((5050 - (b - a) * (a + b + 1) / 2) / (100 - (b - a))));
    }
    CHECK(sum == 100);

    Batches::Parts parts, fewer;
    batches.split(parts);
    double total = 0;
    for (int p = 0; p < Batches::parts; ++p) total += double(parts.frames[p]) * parts.mean[p].grey[0];
    CHECK(total == doctest::Approx(5050));
    batches.without(4, parts, fewer);
    CHECK(fewer.frames[0] == parts.frames[0] - batches.frames(4));
    CHECK(fewer.mean[1].grey == parts.mean[1].grey);
}

// Noise of deviation s alone has a contrast in proportion to s, and halves of the frames have sqrt 2 of it.
TEST_CASE("RAMMG without the contrast of noise") {
    const int n = 128;
    view::View view;
    view.vh = view.vv = 60;
    const Geometry geometry(view, n, n);
    std::mt19937 random(5);
    Batches::Parts parts;
    std::vector<float> sum(n * n);
    for (int p = 0; p < Batches::parts; ++p) {
        parts.frames[p] = p + 3;  // 3, 4, 5, 6 frames
        parts.mean[p] = {n, n, {}};
        for (int i = 0; i < n * n; ++i) {
            const double noise = 15 / std::sqrt(double(p + 3)) * (gaussian(random) - 1);
            parts.mean[p].grey.push_back(float(100 + 40 * (i % n > n / 2) + noise));
            sum[size_t(i)] += parts.mean[p].grey.back() * float(p + 3) / 18;
        }
    }
    Luminance lum[4];
    double counts[4];
    for (int p = 0; p < 4; ++p) lum[p] = parts.mean[p].luminance(), counts[p] = double(parts.frames[p]);
    const double whole = rammg({n, n, sum.data()}, geometry), halves = rammg_of_halves(lum, counts, geometry);
    std::vector<float> exact;
    for (int i = 0; i < n * n; ++i) exact.push_back(float(100 + 40 * (i % n > n / 2)));
    const double truth = rammg({n, n, exact.data()}, geometry);
    CHECK(noise_of_halves(parts, 1) == doctest::Approx(2));
    CHECK(halves - truth == doctest::Approx(std::sqrt(2) * (whole - truth)).epsilon(0.01));
    CHECK(extrapolated(whole, halves, noise_of_halves(parts, 0.5)) == doctest::Approx(truth).epsilon(0.05));
}

double sum_of_terms(const Measurement& m) {
    double sum = 0;
    for (const GlareTerm& t : m.glare) sum += t.weight * dgp_term(t, {});
    return sum;
}

// Each bright pixel by itself is a source here, so that the squares of noisy pixels are too large by their variance,
// and nothing else is wrong.
TEST_CASE("the sum over sources that DGP takes has no bias of squares") {
    Room room({"DGP", "RAMMG"}, DgpForm::pixel);
    image::Picture exact = picture(::room());
    const double truth = sum_of_terms(room.meter->measure(exact, "room"));
    const int seeds = 1500, frames = 17;
    double plain = 0, unbiased = 0, squares = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        Stream stream(::room(), gaussian, uint32_t(seed), 1e9);
        Batches batches;
        Measurement m;
        for (int n = 1; n <= frames; ++n) {
            image::Picture p = picture(stream.next());
            Luminance lum = room.meter->read(p, "sum");
            batches.add(lum, n);
            if (n == frames) m = room.meter->measure(lum, "sum");
        }
        Batches::Parts parts;
        batches.split(parts);
        room.meter->extrapolate(parts, m);
        plain += sum_of_terms(m) / seeds;
        unbiased += sum_of_terms(*m.unbiased) / seeds;
        squares += std::pow(sum_of_terms(*m.unbiased), 2) / seeds;
    }
    const double error = std::sqrt((squares - unbiased * unbiased) / seeds);
    CHECK(plain - truth > 5 * error);
    CHECK(std::fabs(unbiased - truth) < 3 * error);
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
    for (const Case& c : {Case{"Ev 0.6%", gaussian}, Case{"Ev 2.5%", heavy}, Case{"DGP 0.003", gaussian}}) {
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
            ++stopped;
            covered += std::fabs(e.value - room.truth[0]) <= e.half_width(PrecisionRule::outside, stream.frames());
        }
        INFO(rule << ": " << covered << " of " << stopped);
        MESSAGE(rule << ": " << covered << " of " << stopped);
        CHECK(stopped > seeds / 2);
        CHECK(covered > 0.92 * stopped);
        CHECK(covered < 0.98 * stopped);
    }
}

TEST_CASE("rules of widths and of the class") {
    CHECK_THROWS_AS(PrecisionRule(""), base::Error);
    CHECK_THROWS_AS(PrecisionRule("DGP"), base::Error);
    PrecisionRule rule("DGP 0.01, class");
    CHECK(rule.tolerances().size() == 1);
    CHECK(rule.asks_class());

    Estimate e{0.30, 0.003, 15, false, 64};
    CHECK(rule.holds(5, 64, {e}, e));
    CHECK(!rule.holds(5, 31, {e}, e));  // too early
    e.tails = true;
    CHECK(!rule.holds(5, 64, {e}, e));
    e = {0.349, 0.003, 15, false, 64};  // crosses 0.35
    CHECK(!rule.holds(5, 64, {e}, e));
    e = {0.337, 0.003, 15, false, 64};  // does so at the level of a late look
    CHECK(rule.holds(2, 64, {e}, e));
    CHECK(!rule.holds(30, 64, {e}, e));
    CHECK(dgp_class(0.34) == 0);
    CHECK(dgp_class(0.35) == 1);
    CHECK(dgp_class(0.40) == 2);
    CHECK(dgp_class(0.45) == 2);
    CHECK(dgp_class(0.46) == 3);
}
