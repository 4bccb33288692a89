// SPDX-License-Identifier: BSD-3-Clause
// Counts above a limit and values that are exceeded: closed forms, and simulated years whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "uncertainty/counts.h"
#include "uncertainty/student.h"

using namespace uncertainty;

TEST_CASE("events of equal chance are a binomial distribution, of unequal chance the sum over all cases") {
    const std::vector<double> p = count_distribution(std::vector<double>(20, .3));
    double binomial = std::pow(.7, 20);
    for (int k = 0; k <= 20; ++k) {
        CHECK(p[size_t(k)] == doctest::Approx(binomial).epsilon(1e-12));
        binomial *= .3 / .7 * (20 - k) / (k + 1);
    }
    const std::vector<double> q = count_distribution({.1, .5, .8});
    CHECK(q[0] == doctest::Approx(.9 * .5 * .2));
    CHECK(q[1] == doctest::Approx(.1 * .5 * .2 + .9 * .5 * .2 + .9 * .5 * .8));
    CHECK(q[3] == doctest::Approx(.1 * .5 * .8));
}

TEST_CASE("the chance of a value is that of its error") {
    CHECK(chance_above({.4, .01, 0}, .4) == .5);
    CHECK(chance_above({.4, .01, 0}, .4 + .0196) == doctest::Approx(.025).epsilon(.01));
    CHECK(chance_above({.4, .01, .005}, .4, -1) == chance_above({.395, .01, 0}, .4));
    CHECK(chance_above({.4, 0, 0}, .4) == 0);  // above means more than the limit
    CHECK(chance_above({.41, 0, 0}, .4) == 1);
}

TEST_CASE("with few degrees of freedom the chance is Student's, for a 95 % limit to .003") {
    for (const double degrees : {3., 4., 5.5, 8., 15., 1e3})
        CHECK(chance_above({.4, .01, 0, 0, degrees}, .4 + .01 * student_quantile(.05, degrees)) ==
              doctest::Approx(.025).epsilon(.12));
    CHECK(student_of_normal(normal_of_student(-2.5, 4), 4) == doctest::Approx(-2.5));
    CHECK(normal_of_student(1.5, Uncertain::infinite) == 1.5);
}

TEST_CASE("what a value cannot be is no event") {
    Uncertain u{.5, .2, 1};
    u.least = .46, u.most = 1;
    CHECK(chance_above(u, .45, -1) == 1);
    CHECK(chance_above(u, 1, 1) == 0);
    CHECK(exceeded_interval({u}, 0, .05).low == doctest::Approx(.46));
    CHECK(exceeded_interval({u}, 0, .05).high == doctest::Approx(1));
}

TEST_CASE("exact values have no width") {
    std::vector<Uncertain> year;
    for (int i = 0; i < 100; ++i) year.push_back({i / 100., 0, 0});
    const Interval n = count_above(year, .945, .05);
    CHECK(n.low == 5);
    CHECK(n.high == 5);
    CHECK(exceeded(year, 5) == .94);
    const Interval x = exceeded_interval(year, 5, .05);
    CHECK(x.low == doctest::Approx(.94));
    CHECK(x.high == doctest::Approx(.94));
    CHECK(exceeded(year, 100) == 0);
}

TEST_CASE("a bound of the error widens both, however many values there are") {
    std::vector<Uncertain> year;
    for (int i = 0; i < 1000; ++i) year.push_back({i / 1000., 0, .0105});
    const Interval n = count_above(year, .8995, .05);
    CHECK(n.low == 90);
    CHECK(n.high == 110);
    CHECK(exceeded_interval(year, 50, .05).half_width() == doctest::Approx(.0105));
    for (Uncertain& u : year) u.bound = 0, u.jump = -.0105;
    CHECK(count_above(year, .8995, .05).low == 90);
    CHECK(count_above(year, .8995, .05).high == 100);
    CHECK(exceeded_interval(year, 50, .05).high == doctest::Approx(.949));
    CHECK(exceeded_interval(year, 50, .05).low == doctest::Approx(.949 - .0105));
}

// Years of 300 hours, a third of them dark; DGP like an office's, errors that grow with it, and estimated by eight
// frames, so that the interval of an hour is Student's of 4 degrees.  A common error of the pixels lies within its
// bound.
TEST_CASE("intervals of counts and of the exceeded value hold the truth in 93 of 100 years") {
    constexpr int years = 1000, hours = 300, exceeding = hours / 20;
    constexpr double degrees = 4, alpha = .05, limit = .40;
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::chi_squared_distribution<double> chi(degrees);
    std::uniform_real_distribution<double> uniform;
    for (const double bound : {0., .004}) {
        int counts = 0, percentiles = 0;
        double width = 0;
        for (int y = 0; y < years; ++y) {
            const double pixels = bound * (2 * uniform(random) - 1);
            std::vector<Uncertain> seen, truth;
            for (int h = 0; h < hours; ++h) {
                const bool dark = h % 3 == 0;
                const double dgp = dark ? .16 : .18 + .2 * std::pow(uniform(random), 2) + .02 * chi(random) / degrees;
                const double error = dark ? 0 : .02 * dgp;
                truth.push_back({dgp, 0, 0});
                seen.push_back({dgp + pixels * !dark + error * normal(random), error * std::sqrt(chi(random) / degrees),
                                dark ? 0 : bound, 0, degrees});
            }
            const double above = count_above(truth, limit, alpha).low, e5 = exceeded(truth, exceeding);
            const Interval n = count_above(seen, limit, alpha), x = exceeded_interval(seen, exceeding, alpha);
            counts += n.low <= above && above <= n.high;
            percentiles += x.low <= e5 && e5 <= x.high;
            width += x.half_width() / years;
        }
        CAPTURE(bound);
        CAPTURE(width);
        CHECK(counts >= .93 * years);
        CHECK(percentiles >= .93 * years);
        CHECK(width < .0062 + bound);  // an hour's own is .022
    }
}
