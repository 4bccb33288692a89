// SPDX-License-Identifier: BSD-3-Clause
// Counts of values whose errors are alike: simulated years of one set of paths, whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "uncertainty/shared_counts.h"
#include "uncertainty/student.h"
#include "uncertainty_shared_year.h"

using namespace uncertainty;

namespace {

constexpr double one_sigma = 1.5;  // of 200 years, percent

bool holds(const Interval& i, double truth) { return i.low <= truth + 1e-9 && truth - 1e-9 <= i.high; }

struct Held {
    double shared = 0, apart = 0, width = 0;
};

// Of counts from 300 on and of the value that 5 % of the hours exceed.
std::array<Held, 2> study(SharedYears years, int draws, size_t hours) {
    constexpr double limit = 300, alpha = .05;
    std::array<Held, 2> held;
    for (int y = 0; y < draws; ++y) {
        const SharedYear year = years.draw(hours);
        std::vector<Uncertain> truth, apart;
        for (size_t h = 0; h < hours; ++h) truth.push_back({year.truth[h]}), apart.push_back(year.seen[h].of);
        const size_t exceeding = hours / 20;
        const double n = count_within(truth, limit, INFINITY, alpha).low, x = exceeded(truth, exceeding);
        const Interval count = count_within(year.seen, counts_within(year.seen, limit, INFINITY), year.strata, limit,
                                            INFINITY, alpha),
                       value = exceeded_interval(year.seen, year.strata, exceeding, alpha);
        held[0].shared += holds(count, n) * 100. / draws;
        held[1].shared += holds(value, x) * 100. / draws;
        held[0].apart += holds(count_within(apart, limit, INFINITY, alpha), n) * 100. / draws;
        held[1].apart += holds(exceeded_interval(apart, exceeding, alpha), x) * 100. / draws;
        held[0].width += count.half_width() / draws, held[1].width += value.half_width() / draws / x;
    }
    return held;
}

}  // namespace

TEST_CASE("half-samples keep their proportions in a byte each; the root of their mean square is the standard error") {
    std::vector<double> values;
    for (int k = 0; k < half_samples; ++k) values.push_back(5 + std::sin(double(k)));
    const HalfCodes halves = halves_of(values, 8).codes;
    double squares = 0;
    for (const double o : off(halves)) squares += o * o / half_samples;
    CHECK(squares == doctest::Approx(1));
    CHECK(off(halves)[2] / off(halves)[4] == doctest::Approx(std::sin(2.) / std::sin(4.)).epsilon(.15));
    const HalfCodes alike = halves_of(std::vector<double>(half_samples, 5), 8).codes;
    CHECK(off(alike)[0] == 1);
    CHECK(off(alike)[strata] == -1);
}

TEST_CASE("of years of one set of paths, 93 to 97 of 100 lie within the limits by half-samples; half within others") {
    for (const int parts : {8, 16})
        for (const double error : {.03, .06}) {
            const std::array<Held, 2> held = study({1, parts, error, {.3, .5, .2}}, 200, 1500);
            for (const Held& h : held) {
                CAPTURE(parts);
                CAPTURE(error);
                CAPTURE(h.apart);
                CAPTURE(h.width);
                CHECK(h.shared >= 93 - one_sigma);
            }
            CHECK(held[0].shared <= 97 + one_sigma);
            CHECK(held[0].apart < 60);
            CHECK(held[1].apart < 85);
        }
}

TEST_CASE("where errors are independent after all, the limits are not too narrow") {
    const std::array<Held, 2> held = study({2, 16, .06, {0, 0, 1}}, 200, 1000);
    for (const Held& h : held) {
        CAPTURE(h.apart);
        CAPTURE(h.width);
        CHECK(h.shared >= 93);
    }
}

TEST_CASE("limits do not reach over what values surely do not exceed") {
    SharedYears years(5, 16, .05, {.9, 0, .1});
    const SharedYear year = years.draw(100);
    std::vector<Shared> values = year.seen;
    for (Shared& s : values) s.of.most = 300, s.of.least = 250;
    const Interval value = exceeded_interval(values, year.strata, 5, .05);
    CHECK(value.high <= 300 + 1e-9);
    CHECK(value.low >= 250 - 1e-9);
    CHECK(count_above(values, year.strata, 300, .05).high == 0);
    CHECK(count_above(values, year.strata, 249, .05).low == 100);
}
