// SPDX-License-Identifier: BSD-3-Clause
// Sums without rounding: closed forms over the whole range of floats, and any order and grouping.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "image/exact_loops.h"
#include "image/exact_sum.h"

using image::ExactSum;

namespace {

double sum_of(const std::vector<float>& values) {
    ExactSum s;
    s.clear(1);
    for (float v : values) s.add(std::vector<float>{v});
    return s.value(0);
}

float any_float(std::mt19937& dice) {
    for (;;) {
        const uint32_t bits = uint32_t(dice());
        float v;
        std::memcpy(&v, &bits, 4);
        if (std::isfinite(v)) return v;
    }
}

bool same(const ExactSum& a, const ExactSum& b) {
    const auto x = a.layers(), y = b.layers();
    return x.size() == y.size() && std::equal(x.begin(), x.end(), y.begin(), [](const auto& p, const auto& q) {
               return p.digit == q.digit && p.words == q.words;
           });
}

}  // namespace

TEST_CASE("what rounding would lose is there") {
    CHECK(sum_of({1e32f, 1e-32f, -1e32f}) == double(1e-32f));
    CHECK(sum_of({3e38f, 3e38f, -3e38f, -3e38f, 1e-45f}) == double(1e-45f));
    CHECK(sum_of({-1e-5f, 1, -1}) == double(-1e-5f));
    CHECK(sum_of({}) == 0);
    CHECK(sum_of({1, -1}) == 0);
    CHECK(sum_of({1, std::numeric_limits<float>::infinity(), 2, NAN}) == 3);
    const float largest = std::numeric_limits<float>::max();
    CHECK(sum_of({largest, largest, largest, largest}) == 4 * double(largest));
}

TEST_CASE("a single float and a single double come back") {
    std::mt19937 dice(1);
    for (int i = 0; i < 20000; ++i) {
        const float v = any_float(dice);
        CHECK(sum_of({v}) == double(v));
        const double d = std::ldexp(double(v) + double(any_float(dice)), int(dice() % 20)) / 3;
        ExactSum s;
        s.clear(1);
        s.add(std::vector<double>{d});
        const bool cut = std::fabs(d) < 0x1p-96;
        CHECK((cut ? std::fabs(s.value(0) - d) <= 0x1p-149 : s.value(0) == d));
    }
}

TEST_CASE("any order and grouping gives the same digits") {
    std::mt19937 dice(2);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<std::vector<float>> values(60, std::vector<float>(5));
        for (auto& frame : values)
            for (float& v : frame) v = trial % 2 ? any_float(dice) : float(dice() % 1000) * 1e-3f - .3f;
        ExactSum whole;
        whole.clear(5);
        for (const auto& frame : values) whole.add(frame);

        std::shuffle(values.begin(), values.end(), dice);
        ExactSum parts;
        parts.clear(5);
        for (size_t first = 0; first < values.size();) {
            ExactSum part;
            part.clear(5);
            const size_t end = std::min<size_t>(values.size(), first + 1 + dice() % 20);
            for (; first < end; ++first) part.add(values[first]);
            parts.add(part.layers(), "part");
        }
        REQUIRE(same(whole, parts));
        for (size_t i = 0; i < 5; ++i) CHECK(whole.value(i) == parts.value(i));
    }
}

// The loops take 256 sums and eight frames at a time, of near exponents together and of distant ones one by one.
TEST_CASE("many frames at once are the same as one after the other") {
    std::mt19937 dice(3);
    constexpr size_t count = 1003;
    for (int spread : {0, 20, 200}) {
        std::vector<std::vector<float>> frames(19, std::vector<float>(count));
        ExactSum one_by_one, at_once;
        one_by_one.clear(count), at_once.clear(count);
        image::exact::Exponents exponents;
        for (auto& frame : frames) {
            for (float& v : frame) v = dice() % 3 ? std::ldexp(float(dice()) - 1e9f, -int(dice() % (spread + 1))) : 0;
            frame[700] = -std::numeric_limits<float>::max();
            frame[710] = std::numeric_limits<float>::denorm_min();
            for (size_t i : {size_t(5), size_t(300)}) frame[i] = i == 5 ? NAN : INFINITY;
            image::exact::widen(exponents, frame.data(), count);
            one_by_one.add(frame);
        }
        at_once.add({frames.data(), frames.size()}, exponents, 3);
        REQUIRE(same(one_by_one, at_once));

        std::vector<double> values(count);
        at_once.values(0, count, values.data());
        for (size_t i = 0; i < count; ++i) {
            long double sum = 0;  // near enough: the terms have 24 bits
            for (const auto& frame : frames) sum += std::isfinite(frame[i]) ? frame[i] : 0;
            CHECK(values[i] == one_by_one.value(i));
            if (spread <= 20) CHECK(values[i] == double(sum));
        }
    }
}
