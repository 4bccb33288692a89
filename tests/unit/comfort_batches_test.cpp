// SPDX-License-Identifier: BSD-3-Clause
// What intervals are made of: Student's quantiles, limits of skew estimates, batches of frames, half pictures.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "comfort/batches.h"
#include "comfort/halves.h"
#include "comfort/interval.h"
#include "comfort/student.h"

using namespace comfort;

TEST_CASE("Student's quantiles are those of the tables") {
    CHECK(student_quantile(0.05, 1) == doctest::Approx(12.7062047).epsilon(1e-7));
    CHECK(student_quantile(0.05, 5) == doctest::Approx(2.5705818).epsilon(1e-7));
    CHECK(student_quantile(0.05, 15) == doctest::Approx(2.1314495).epsilon(1e-7));
    CHECK(student_quantile(0.01, 30) == doctest::Approx(2.7499957).epsilon(1e-7));
    CHECK(student_quantile(0.05, 1e7) == doctest::Approx(1.9599640).epsilon(1e-5));
    CHECK(std::isinf(student_quantile(0.05, 0)));
}

// g(T) of Hall's limits is Student's t again, and the far side is where the skewness points.
TEST_CASE("limits of a skew estimate") {
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

// Frame k is k everywhere: L'(n) = (n+1)/2, and a batch a+1..b has the mean (a+b+1)/2.
TEST_CASE("batches are what the running means say, and never more than 16") {
    Batches batches;
    batches.watch({3});
    for (int64_t n = 1; n <= 100; ++n) {
        std::vector<float> mean(4, float(n + 1) / 2);
        batches.add({2, 2, mean.data()}, n, 100);
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

    // Halves of about 50 frames each: d = sqrt(a b)/100 (mean of 1 to a - mean of a+1 to 100) = - sqrt(a b)/2.
    std::vector<float> d(4);
    CHECK(batches.halves().know_frame0);
    batches.halves().find(0, d.size(), d.data());
    for (const float v : d) CHECK(v == doctest::Approx(-25).epsilon(0.02));
}

// Means that are read into room_for_next() take the place of those that nothing needs any more; halves are the same.
TEST_CASE("batches keep what looks need") {
    Batches copied, moved;
    std::vector<float> sum(1000, 0);
    for (int64_t n = 1, look = 2; n <= 150; ++n) {
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += float((int64_t(i) * n * n) % 101);
        std::vector<float> mean = sum, &room = moved.room_for_next();
        for (float& v : mean) v /= float(n);
        copied.add({100, 10, mean.data()}, n, look);
        room = mean;
        moved.add({100, 10, room.data()}, n, look);
        if (n < look) continue;
        std::vector<float> d[2] = {mean, mean};
        copied.halves().find(0, mean.size(), d[0].data());
        moved.halves().find(0, mean.size(), d[1].data());
        CHECK(d[0] == d[1]);
        CHECK(moved.whole() == mean);
        look = Batches::look_after(n);
    }
}

// Frames 1 to 8 show one half of frame 0's samples or the other: here 5 and -5 beside k^2 (page 2 of the decisions).
// The frames of one half less those of the other, whatever their number, tell both.
TEST_CASE("halves of few frames have halves of frame 0's samples") {
    Batches batches;
    Halves halves;
    double sum = 0, half[2] = {}, frames[2] = {};
    for (int k = 1; k <= 12; ++k) {
        const int of = image::in_first_half(k) ? 0 : 1;
        const double own = k * k + (k > 8 ? 0 : of == 0 ? 5 : -5);
        sum += own, half[of] += own, frames[of] += 1;
        float mean = float(sum / k);
        batches.add({1, 1, &mean}, k, k);
        if (k == 1) continue;
        REQUIRE(halves.take(batches));
        CHECK(halves.know_frame0());
        const double d = std::sqrt(frames[0] * frames[1]) / k * (half[0] / frames[0] - half[1] / frames[1]);
        CHECK(halves.off()[0] == doctest::Approx(d).epsilon(1e-4));
        if (k % 2 == 0) CHECK(frames[0] == frames[1]);
    }
    CHECK(half[0] - half[1] - 40 == doctest::Approx(2 * (1 + 16 + 36 + 49 + 100 + 121) - 650));
}

// Pixel i has the mean i in the first a frames and -3 i in the b = a/3 behind: d = sqrt(3) (i - 0).
TEST_CASE("half pictures lie around the whole one, each pixel by its own sign") {
    Batches batches;
    std::vector<float> first(4096), whole(4096);
    for (int i = 0; i < 4096; ++i) first[size_t(i)] = float(i);
    batches.add({64, 64, first.data()}, 30, 40);
    batches.add({64, 64, whole.data()}, 40, 40);
    Halves halves;
    REQUIRE(halves.take(batches));
    std::vector<GreyPicture> pictures(Halves::count);
    for (int k = 0; k < Halves::count; ++k) halves.pictures().picture(k, pictures[size_t(k)]);
    double squares[Halves::count] = {}, sums[Halves::count] = {}, exact = 0;
    for (int i = 0; i < 4096; ++i) {
        double mean = 0;
        for (int k = 0; k < Halves::count; ++k) {
            const double v = pictures[size_t(k)].grey[size_t(i)];
            REQUIRE(std::fabs(v) == doctest::Approx(std::sqrt(3.) * i));
            mean += v, sums[k] += v, squares[k] += v * v;
        }
        REQUIRE(mean == doctest::Approx(0));
        exact += 3. * i * i;
    }
    // The sum of all pixels has the variance of the pixels' together; a sum of squares has no variance at all.
    const Halves::Variance of_sum = Halves::variance(sums), of_squares = Halves::variance(squares);
    CHECK(of_sum.sum / exact > 0.3);  // 15 degrees of freedom: 1 +- 0.37
    CHECK(of_sum.sum / exact < 2.1);
    CHECK(of_sum.largest < of_sum.sum);
    CHECK(of_squares.sum < 1e-9 * exact * exact);
    CHECK(Halves::without_bias(0, squares, 2) == doctest::Approx(-exact));  // of the square of a noise of mean 0
}
