// SPDX-License-Identifier: BSD-3-Clause
// Replication by law: quantiles, limits, balance of half-samples, textbook variances, coverage of correlated pixels.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "image/picture.h"
#include "uncertainty/difference.h"
#include "uncertainty/stopping.h"
#include "uncertainty/student.h"
#include "uncertainty/threshold_filter.h"

using namespace uncertainty;

namespace {

// Parts of a growing mean of single frames.
Frames frames_after(int64_t n) {
    Frames out;
    for (int64_t k = 0; k < n; ++k)
        if (out.size() < 16) out.push_back(1);
        else ++*std::min_element(out.begin(), out.end());
    return out;
}

double dot(const Weights& w, const std::vector<double>& x) {
    return std::inner_product(w.begin(), w.end(), x.begin(), 0.);
}

std::vector<double> of_half_samples(const Frames& frames, const std::vector<double>& x) {
    std::vector<double> out;
    for (int k = 0; k < half_samples; ++k) out.push_back(dot(half_sample(frames, k), x));
    return out;
}

double mean_of(const Frames& frames, const std::vector<double>& x) {
    double sum = 0, n = 0;
    for (size_t p = 0; p < x.size(); ++p) sum += double(frames[p]) * x[p], n += double(frames[p]);
    return sum / n;
}

// A binomial share of `trials` lies within so many standard deviations of p.
bool within(double share, double p, int trials, double sd) {
    return std::fabs(share - p) <= sd * std::sqrt(p * (1 - p) / trials);
}

}  // namespace

TEST_CASE("Student's quantiles are those of the tables") {
    CHECK(student_quantile(0.05, 1) == doctest::Approx(12.7062047).epsilon(1e-7));
    CHECK(student_quantile(0.05, 5) == doctest::Approx(2.5705818).epsilon(1e-7));
    CHECK(student_quantile(0.05, 15) == doctest::Approx(2.1314495).epsilon(1e-7));
    CHECK(student_quantile(0.01, 30) == doctest::Approx(2.7499957).epsilon(1e-7));
    CHECK(student_quantile(0.05, 1e7) == doctest::Approx(1.9599640).epsilon(1e-5));
    CHECK(std::isinf(student_quantile(0.05, 0)));
}

// g(T) of Hall's limits is Student's t again, and the far side is where the skewness points.
TEST_CASE("limits of a skew estimate are the inverse of Hall's formula") {
    const double G = 0.4, t = student_quantile(0.05, 15);
    const Estimate e{10, 2, 15, G, false, 64};
    const Interval off = e.around(0.05, 64);
    for (const double sign : {-1., 1.}) {
        const double T = -(sign > 0 ? off.low : off.high) / e.error;
        CHECK(T + G * T * T / 3 + G * G * T * T * T / 27 + G / 6 == doctest::Approx(sign * t));
    }
    CHECK(off.high > 1.2 * -off.low);
    CHECK(e.around(0.05, 256).half_width() < off.half_width() / 2);  // narrower, and less skew
}

TEST_CASE("the lasting part of an error stays, whatever the number of frames") {
    const Estimate e{10, 5, 8, 0, false, 64, 3};
    CHECK(e.error_after(64) == doctest::Approx(5));
    CHECK(e.error_after(256) == doctest::Approx(std::sqrt(9 + 16. / 4)));
    CHECK(e.error_after(1ll << 60) == doctest::Approx(3));
    CHECK(e.half_width(.05, 1ll << 60) == doctest::Approx(e.half_width(.05, 64) * 3 / 5));
}

TEST_CASE("half-samples are balanced: rows of the Hadamard matrix are orthogonal") {
    for (int a = 0; a < strata; ++a)
        for (int b = 0; b < strata; ++b) {
            int product = 0;
            for (int row = 0; row < strata; ++row) product += hadamard(row, a) * hadamard(row, b);
            CHECK(product == (a == b ? strata : 0));
        }
    const Frames frames(16, 3);
    for (int k = 0; k < strata; ++k) {
        const Weights one = half_sample(frames, k), other = half_sample(frames, k + strata);
        for (size_t p = 0; p < 16; ++p) {
            CHECK(one[p] + other[p] == doctest::Approx(.125));  // one or the other
            CHECK((one[p] > 0) != (one[(p + 8) % 16] > 0));     // one of each stratum
        }
    }
}

TEST_CASE("degrees of freedom and noise of half-samples") {
    CHECK(degrees_of_freedom({5}) == 0);
    CHECK(degrees_of_freedom({1, 1}) == 1);
    CHECK(degrees_of_freedom(Frames(16, 7)) == doctest::Approx(8));
    const Frames doubling{1, 1, 2, 4, 8, 16, 32, 64};  // ranges of ptaccum -every x2
    CHECK(degrees_of_freedom(doubling) == doctest::Approx(128. * 128 / (4 + 36 + 576 + 9216)));
    CHECK(variance_ratio({1, 1}) == doctest::Approx(2));
    CHECK(variance_ratio(Frames(16, 7)) == doctest::Approx(2));
    CHECK(variance_ratio({1, 1, 1}) == doctest::Approx(2.25));  // half-samples of two frames or of one
}

// Of a linear quantity: the sum over strata of the squared half-differences, each by its share of the frames.
TEST_CASE("the error of a linear quantity is the textbook's") {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> x(16);
    for (double& v : x) v = normal(random);
    const Frames even(16, 4);
    double variance = 0;
    for (size_t s = 0; s < 8; ++s) variance += std::pow((x[s] - x[s + 8]) / 2 / 8, 2);
    const Estimate e = brr(mean_of(even, x), of_half_samples(even, x), even, NoiseBias::none, 0);
    CHECK(e.error == doctest::Approx(std::sqrt(variance)));
    CHECK(e.value == doctest::Approx(mean_of(even, x)));

    // The delete-one jackknife's is that of a weighted mean.
    const Frames uneven{1, 1, 2, 4, 8, 16, 32, 64};
    x.resize(8);
    const double n = 128, mean = mean_of(uneven, x);
    double squares = 0;
    std::vector<double> without;
    for (size_t p = 0; p < 8; ++p) {
        squares += double(uneven[p]) * std::pow(x[p] - mean, 2);
        without.push_back(dot(all_but(uneven, p), x));
    }
    CHECK(jackknife(mean, without, uneven, false).error == doctest::Approx(std::sqrt(squares / 7 / n)));
    CHECK(jackknife(mean, without, uneven, false).degrees == 7);
}

// E[mean^2] = mu^2 + sigma^2/n, and of half the frames sigma^2/n more: a square loses its bias.
TEST_CASE("the bias of a square is taken off") {
    std::mt19937 random(2);
    std::normal_distribution<double> normal(3, 1);
    const int trials = 4000;
    double sum = 0, squares = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Frames frames = frames_after(20);
        std::vector<double> x, halves;
        for (const int64_t m : frames) x.push_back(3 + (normal(random) - 3) / std::sqrt(double(m)));
        for (const double h : of_half_samples(frames, x)) halves.push_back(h * h);
        const double v = brr(std::pow(mean_of(frames, x), 2), halves, frames, NoiseBias::variance, 0).value;
        sum += v / trials, squares += v * v / trials;
    }
    CHECK(std::fabs(sum - 9) < 3 * std::sqrt((squares - sum * sum) / trials));
}

// A pixel near the threshold: the quantity is 1 above it and 0 below.  off: of the truth, in errors of the whole.
TEST_CASE("intervals hold the step of a pixel near the threshold") {
    const int trials = 2000;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const Frames frames(16, 4);
    const auto step = [](double x) { return x > 0 ? 1. : 0.; };
    for (const double off : {.05, .5, 1., 2.}) {
        int covered = 0;
        for (int trial = 0; trial < trials; ++trial) {
            std::vector<double> x(16), halves;
            for (double& v : x) v = off / 4 + normal(random);
            for (const double h : of_half_samples(frames, x)) halves.push_back(step(h));
            const Estimate e = brr(step(mean_of(frames, x)), halves, frames, NoiseBias::variance, .25);
            covered += e.known() ? std::fabs(1 - e.value) <= e.half_width(.05, 64) : e.value == 1;
        }
        INFO(off << " standard errors above: " << covered << " of " << trials);
        CHECK(covered > (.95 - 3 * .0049) * trials);
    }
}

TEST_CASE("one stratum that makes most of the error is told") {
    const Frames frames(16, 4);
    std::vector<double> x(16, 1), halves;
    x[5] = 100;
    for (size_t p = 0; p < 16; ++p) x[p] += double(p % 5) * .1;
    CHECK(brr(mean_of(frames, x), of_half_samples(frames, x), frames, NoiseBias::none, 0).unreliable);
    x[5] = 1;
    CHECK(!brr(mean_of(frames, x), of_half_samples(frames, x), frames, NoiseBias::none, 0).unreliable);
}

// Frames of 64 pixels in groups of 16 that have one error in common: the mean of all pixels is linear, and its interval
// covers whatever pixels have in common.  Student's t is exact where strata have the same number of frames.
TEST_CASE("intervals of correlated pixels cover") {
    const int trials = 3000;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (const int64_t n : {2, 3, 4, 5, 8, 13, 16, 17, 32, 65}) {
        const Frames frames = frames_after(n);
        int covered = 0;
        for (int trial = 0; trial < trials; ++trial) {
            std::vector<double> x(frames.size(), 0);
            for (int64_t k = 0; k < n; ++k) {
                double frame = 0;
                for (int group = 0; group < 4; ++group) {
                    const double common = normal(random);
                    for (int pixel = 0; pixel < 16; ++pixel) frame += (common + .3 * normal(random)) / 64;
                }
                const size_t p = size_t(k) % 16;
                x[p] += frame / double(frames[p]);
            }
            const Estimate e = brr(mean_of(frames, x), of_half_samples(frames, x), frames, NoiseBias::none, 0);
            covered += std::fabs(e.value) <= e.half_width(.05, n);
        }
        INFO(n << " frames: " << covered << " of " << trials);
        const bool exact = (n & (n - 1)) == 0;
        CHECK((exact ? within(double(covered) / trials, .95, trials, 3.5) : covered > .93 * trials));
    }
}

// Frames 1 to m show frame 0 and half the difference h of its halves, by turns; nothing else varies.
TEST_CASE("the error of frame 0 from parts of any number of frames") {
    for (const int64_t m : {8, 16, 32})
        for (const int n : {3, 7, 16, 40, 100}) {
            CAPTURE(m);
            CAPTURE(n);
            std::vector<image::Part> parts;
            for (int k = 1; k <= n; ++k) {
                const float h = k > m ? 0 : image::in_first_half(k) ? -.25f : .25f;
                image::add_part(parts, {1, {5 + h}, {{7, {{k, k}}}}});
            }
            const Frame0Error error = frame0_error(parts, m, 1, 1, {true});
            REQUIRE(error.of_pixel.size() == 1);
            CHECK(error.of_pixel[0] == doctest::Approx(-.25));
            CHECK(error.m == m);
        }
    std::vector<image::Part> runs;
    for (const int k : {1, 2, 3}) runs.push_back({1, {1.f * float(k)}, {{k % 2, {{k, k}}}}});
    CHECK(frame0_error(runs, 8, 1, 1, {true}).of_pixel.empty());
    CHECK(missing_share(4, 8) == doctest::Approx(.5));
    CHECK(missing_share(16, 8) == doctest::Approx(.75 / 4));
    CHECK(missing_share(64, 32) == doctest::Approx(.875 / 4));
}

// Two runs of one pixel, b = 3 + x + y and a = 2 + x + z, of which x is noise in common: the square of each is biased,
// and so is their difference.  Where they have other seeds, b has an x of its own, and the error is that of both.
TEST_CASE("intervals of a difference cover, and noise in common is not in them") {
    const int trials = 2000, n = 16;
    const std::vector<Quantity> quantities = {{Quantity::Method::half_samples, NoiseBias::none, 0, false},
                                              {Quantity::Method::half_samples, NoiseBias::variance, 0, false}};
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto values = [](std::vector<float>& image, std::vector<float>&) {
        return Values{image[0], image[0] * image[0]};
    };
    const auto replicates = [&](std::vector<image::Part>& parts, uint64_t seed) {
        float mean = 0;
        for (image::Part& p : parts) mean += p.grey[0] / n, p.from = {{seed, {{1, 1}}}};
        const Metrics metrics{quantities, [&] { return values; }, {}, {}, 0};
        return replicate({1, 1, &mean, &parts, Frame0Error(), {true}}, metrics, {mean, mean * mean});
    };
    for (const bool common : {true, false}) {
        int covered[2] = {};
        double width = 0;
        for (int trial = 0; trial < trials; ++trial) {
            std::vector<image::Part> a, b;
            for (int k = 0; k < n; ++k) {
                const double x = normal(random), own = common ? x : normal(random);
                a.push_back({1, {float(2 + x + .1 * normal(random))}, {}});
                b.push_back({1, {float(3 + own + .1 * normal(random))}, {}});
            }
            const auto out = difference(replicates(a, 1), replicates(b, common ? 1 : 2), quantities);
            for (int c = 0; c < 2; ++c)
                covered[c] += std::fabs(out[c].value - (c ? 5 : 1)) <= out[c].half_width(.05, n);
            width += out[0].half_width(.05, n) / trials;
        }
        INFO(common << ": " << covered[0] << " and " << covered[1] << " of " << trials << ", " << width);
        CHECK(width < (common ? .1 : .9));
        for (const int count : covered) CHECK(count > .935 * trials);
    }
}

// Region columns (jackknife) came with the second run: what both have is compared, whichever run lacks images.
TEST_CASE("a difference of runs that measured other quantities") {
    const Quantity linear{Quantity::Method::half_samples, NoiseBias::none, 0, false},
        region{Quantity::Method::jackknife, NoiseBias::none, 0, false};
    const auto run = [&](const std::vector<Quantity>& quantities, double shift) {
        Replicates r;
        const size_t n = quantities.size();
        r.frames = Frames(16, 1), r.whole = r.decided = Values(n, shift);
        for (int k = 0; k < half_samples; ++k) r.half_samples.push_back(Values(n, shift + .1 * double(k % 5)));
        for (const Quantity& q : quantities)
            if (q.method == Quantity::Method::jackknife)
                for (int k = 0; k < 16; ++k) r.without.push_back(Values(n, shift + .1 * double(k % 3)));
        return r;
    };
    const Replicates one = run({linear}, 1), both = run({linear, region}, 3);
    const auto later = difference(select(one, {0}), select(both, {0}), {linear});
    const auto earlier = difference(select(both, {0}), select(one, {0}), {linear});
    CHECK(later[0].value == 2);
    CHECK(earlier[0].value == -2);
    CHECK(difference(one, one, {linear})[0].half_width(.05, 16) == 0);
    CHECK(!difference(one, one, {region})[0].known());  // images that the jackknife needs were not measured
}

TEST_CASE("the threshold filter") {
    const int side = 20;
    std::vector<float> flat(side * side, 7), variance(flat.size(), 1), out;
    variance[3] = -1;  // does not count
    const ThresholdFilter all({side, side, flat.data(), variance.data()}, 7, 2);
    CHECK(all.replaced() == flat.size() - 1);
    all.apply(flat, out);
    for (size_t i = 0; i < out.size(); ++i) CHECK(out[i] == doctest::Approx(7));  // a constant stays

    CHECK(ThresholdFilter({side, side, flat.data(), variance.data()}, 9.6f, 2).empty());  // 2.6 errors away
    CHECK(ThresholdFilter({side, side, flat.data(), variance.data()}, 7, 0).empty());

    // The same linear combination of any image, and edges far above the noise stay.
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    std::vector<float> edge(flat.size()), a(flat.size()), b(flat.size()), both(flat.size()), fa, fb, fboth;
    for (size_t i = 0; i < edge.size(); ++i) {
        edge[i] = i % side < 10 ? 6.5f : 60;
        a[i] = normal(random), b[i] = normal(random), both[i] = 2 * a[i] - b[i];
    }
    const ThresholdFilter filter({side, side, edge.data(), variance.data()}, 7, 2);
    filter.apply(edge, out);
    for (size_t i = 0; i < out.size(); ++i) CHECK(out[i] == doctest::Approx(edge[i]));
    filter.apply(a, fa), filter.apply(b, fb), filter.apply(both, fboth);
    for (size_t i = 0; i < out.size(); ++i) CHECK(fboth[i] == doctest::Approx(2 * fa[i] - fb[i]).epsilon(1e-4));
}

// Looks from 16 frames on, each sqrt 2 times as late, at a value that lies on the bound of two classes: claiming either
// class is wrong half of the time, as the truth would lie a hair beyond the bound on one side of it.
TEST_CASE("the class is wrong in at most five of a hundred runs") {
    const int trials = 2000;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const auto class_of = [](double v) { return v < 0 ? 0 : 1; };
    int wrong = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> sums(16, 0);
        int64_t n = 0;
        for (int64_t next = least_frames; next < 6000; next = int64_t(std::ceil(double(n) * std::sqrt(2.)))) {
            std::vector<double> x;
            const Frames frames = frames_after(next), before = frames_after(n);
            for (size_t p = 0; p < 16; ++p) {
                const double more = double(frames[p] - (n ? before[p] : 0));
                sums[p] += std::sqrt(more) * normal(random);
                x.push_back(sums[p] / double(frames[p]));
            }
            n = next;
            const Estimate e = brr(mean_of(frames, x), of_half_samples(frames, x), frames, NoiseBias::none, 0);
            Estimate at = e;
            at.frames = n;
            if (!class_is_known(at, class_of)) continue;
            wrong += at.value > 0;
            break;
        }
    }
    INFO(wrong << " of " << trials);
    CHECK(wrong <= trials * .05 + 3 * std::sqrt(trials * .05 * .95));
    CHECK(wrong > trials * .02);
}

TEST_CASE("a width is narrow enough where it is known and reliable") {
    Estimate e{1, .1, 8, 0, false, 64};
    CHECK(narrow_enough(e, .24));
    CHECK(!narrow_enough(e, .22));
    e.unreliable = true;
    CHECK(!narrow_enough(e, .24));
    CHECK(!narrow_enough({1, std::nan(""), 8, 0, false, 64}, 100));
    CHECK(!narrow_enough({1, 0, 8, 0, false, 15}, 100));  // no spread at all is believed from 16 frames on
    CHECK(narrow_enough({1, 0, 8, 0, false, 16}, 0));
    CHECK(narrow_enough({0, 0, 8, 0, false, 16}, 0));
    CHECK(!narrow_enough({1, 0, 0, 0, false, 16}, 100));  // of one part
}
