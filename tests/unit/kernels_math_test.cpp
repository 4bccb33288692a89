// SPDX-License-Identifier: BSD-3-Clause
// The device's elementary functions against the double ones: the worst error in ulp over each function's range,
// and defined results at the extremes.  (Device = host bits is checked in cal_opencl_test.cpp.)
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include "kernels/dialect/compat_host.h"
namespace device {
#include "kernels/math/math.h"
}

// Largest |f - exact| in units of the last place of the exact value (of 1e-30 at least) for `count` random arguments.
template <class F, class G>
static double worst_ulp(F f, G exact, double low, double high, int count = 400000) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(low, high);
    double worst = 0;
    for (int i = 0; i < count; i++) {
        const float x = float(uniform(random));
        const double want = exact(double(x)), got = f(x);
        if (std::fabs(want) < 1.2e-38) continue;  // denormal results count as 0
        const float near = float(std::fabs(want));
        const double ulp = double(std::nextafterf(near, INFINITY)) - near;
        worst = std::max(worst, std::fabs(got - want) / ulp);
    }
    return worst;
}
#define WORST(limit, fn, exact, low, high) \
    CHECK(worst_ulp([](float x) { return device::fn(x); }, [](double x) { return exact(x); }, low, high) < limit)

TEST_CASE("exponential and logarithms are good to 2 ulp") {
    WORST(1.5, k_exp, std::exp, -87.3, 88.7);
    WORST(1.5, k_exp, std::exp, -1, 1);
    WORST(1.5, k_log, std::log, 1e-30, 1e-3);
    WORST(1.5, k_log, std::log, 0.5, 2);
    WORST(1.5, k_log, std::log, 1, 1e30);
    WORST(2.5, k_log10, std::log10, 1e-6, 1e6);
    WORST(2.5, k_log10, std::log10, 0.5, 2);
}

TEST_CASE("circular functions, also of large angles") {
    WORST(2.0, k_sin, std::sin, -10, 10);
    WORST(2.0, k_cos, std::cos, -10, 10);
    WORST(3.5, k_tan, std::tan, -1.57, 1.57);
    WORST(2.5, k_sin, std::sin, 8000, 9000);
    WORST(2.5, k_cos, std::cos, -1e6, 1e6);
    WORST(2.5, k_sin, std::sin, 1e9, 1e12);
    WORST(2.5, k_cos, std::cos, -1e38, 1e38);
    for (float x : {0.3f, 5.0f, -77.7f, 1e5f}) {
        float s, c;
        device::k_sincos(x, &s, &c);
        CHECK(s == device::k_sin(x));
        CHECK(c == device::k_cos(x));
    }
}

TEST_CASE("inverse circular functions") {
    WORST(2.5, k_asin, std::asin, -1, 1);
    WORST(2.0, k_acos, std::acos, -1, 1);
    WORST(2.0, k_atan, std::atan, -3, 3);
    WORST(2.0, k_atan, std::atan, -1e6, 1e6);
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    double worst = 0;
    for (int i = 0; i < 200000; i++) {
        const float y = normal(random), x = normal(random);
        worst = std::max(worst, std::fabs(device::k_atan2(y, x) - std::atan2(double(y), double(x))) /
                                    (std::fabs(std::atan2(double(y), double(x))) * 1.2e-7));
    }
    CHECK(worst < 2.0);
}

TEST_CASE("powers keep their accuracy where the exponent is large") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> base(0.001f, 30), expo(-12, 12);
    double worst = 0;
    for (int i = 0; i < 400000; i++) {
        const float x = base(random), y = expo(random);
        const double want = std::pow(double(x), double(y));
        if (want > 3e38 || want < 1.2e-38) continue;
        worst = std::max(worst, std::fabs(device::k_pow(x, y) - want) / (want * 1.2e-7));
    }
    CHECK(worst < 1.5);
    CHECK(device::k_pow(2, 10) == 1024);
    CHECK(device::k_pow(-2, 3) == -8);
    CHECK(device::k_pow(-2, 2) == 4);
    CHECK(device::k_pow(0, 3) == 0);
    CHECK(device::k_pow(0, 0) == 1);
    CHECK(device::k_pow(-2, 0.5f) == 0);
    CHECK(device::k_pow(10, -60) == 0);
    CHECK(device::k_pow(10, 60) == INFINITY);
}

TEST_CASE("error function") {
    WORST(2.5, k_erf, std::erf, -5, 5);
    WORST(3.0, k_erfc, std::erfc, -5, 0.4);
    WORST(16.0, k_erfc, std::erfc, 0.4, 9);
}

TEST_CASE("extremes are defined") {
    CHECK(device::k_exp(-1000) == 0);
    CHECK(device::k_exp(1000) == INFINITY);
    CHECK(device::k_exp(0) == 1);
    CHECK(device::k_log(0) == -INFINITY);
    CHECK(device::k_log(-1) == -INFINITY);
    CHECK(device::k_log(1) == 0);
    CHECK(device::k_sin(INFINITY) == 0);
    CHECK(device::k_asin(2) == doctest::Approx(M_PI / 2));
    CHECK(device::k_acos(-2) == doctest::Approx(M_PI));
    CHECK(device::k_atan2(0, -1) == doctest::Approx(M_PI));
    CHECK(device::k_atan2(0, 0) == 0);
    CHECK(device::k_log10(1000) == doctest::Approx(3));
}
