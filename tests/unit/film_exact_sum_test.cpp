// SPDX-License-Identifier: BSD-3-Clause
// Sums without rounding: closed forms over the whole range of floats, and any order and grouping.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "film/exact_sum.h"

using film::ExactSum;

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

// Values that are alike, which pairs of doubles hold, and unlike ones, up to the whole range of floats: the frames, in
// order on three threads and in reverse on one; and once each by itself, as digits.
TEST_CASE("many frames of like and of unlike values") {
    std::mt19937 dice(3);
    constexpr size_t count = 1003;
    for (int spread : {0, 20, 28, 36, 60, 70, 200}) {
        std::vector<std::vector<float>> frames(59, std::vector<float>(count));
        ExactSum forwards, backwards, digits;
        for (ExactSum* sum : {&forwards, &backwards, &digits}) sum->clear(count);
        for (auto& frame : frames) {
            for (float& v : frame) v = dice() % 3 ? std::ldexp(float(dice()) - 1e9f, -int(dice() % (spread + 1))) : 0;
            frame[700] = spread == 200 ? -std::numeric_limits<float>::max() : 1e9f;
            frame[710] = spread == 200 ? std::numeric_limits<float>::denorm_min() : -1e-9f;
            for (size_t i : {size_t(5), size_t(300)}) frame[i] = i == 5 ? NAN : INFINITY;
            CHECK_FALSE(forwards.add(frame, 3));
            ExactSum alone;
            alone.clear(count);
            alone.add(frame);
            digits.add(alone.layers(), "frame");
        }
        for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) backwards.add(*frame);
        REQUIRE(same(forwards, backwards));
        REQUIRE(same(forwards, digits));

        for (size_t i = 0; i < count; ++i) {
            long double sum = 0;  // near enough: the terms have 24 bits
            for (const auto& frame : frames) sum += std::isfinite(frame[i]) ? frame[i] : 0;
            const double value = forwards.value(i);
            if (value != backwards.value(i) || value != digits.value(i)) FAIL(i);
            if (spread <= 20 && value != double(sum)) FAIL(i);
        }
    }
}

// 53 bits, and one more: 2^29 and the 24 bits of a float near 1, then what makes a carry.
TEST_CASE("a double that is full") {
    const float small = 1 + 0x1p-23f;
    for (const float large : {0x1p28f, 0x1p29f, 0x1p30f, 0x1p31f, 0x1p40f}) {
        for (const int count : {1, 2, 3, 4, 5}) {
            std::vector<float> values{small};
            for (int k = 0; k < count; ++k) values.push_back(large);
            for (int k = 0; k < count; ++k) values.push_back(-large);
            CHECK(sum_of(values) == double(small));
            values.push_back(-small);
            CHECK(sum_of(values) == 0);
        }
    }
}
