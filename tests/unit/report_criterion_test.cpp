// SPDX-License-Identifier: BSD-3-Clause
// Rules that a report judges: how they are read, and what intervals make of them.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "report/criterion.h"

using namespace report;

TEST_CASE("a rule has a name, a number, a side and a limit") {
    const Criterion c = parse_criterion("EN 17037: medium: DGPf <= 0.40", "-criterion");
    CHECK(c.name == "EN 17037: medium");
    CHECK(c.metric == "DGPf");
    CHECK(c.at_most);
    CHECK(c.limit == .4);
    const Criterion bare = parse_criterion("floor.mean >= 500", "-criterion");
    CHECK(bare.name.empty());
    CHECK(!bare.at_most);
    for (const char* wrong : {"", "DGPf", "DGPf < .4", "DGPf <= x", "a: DGPf <= .4 .5", "<= .4"})
        CHECK_THROWS_AS(parse_criterion(wrong, "-criterion"), base::Error);
}

TEST_CASE("an interval on one side decides, one that holds the limit does not, and nothing is known of no number") {
    const Criterion most{"", "DGPf", true, .4}, least{"", "E", false, 500};
    const auto is = [](const char* a, const std::string& b) { return a == b; };
    CHECK(is(judged(most, .38, .37, .39), "met"));
    CHECK(is(judged(most, .395, .38, .41), "undecided"));
    CHECK(is(judged(most, .42, .41, .43), "not met"));
    CHECK(is(judged(least, 520, 510, 530), "met"));
    CHECK(is(judged(least, 505, 490, 520), "undecided"));
    CHECK(is(judged(least, 480, 470, 490), "not met"));
    CHECK(is(judged(most, .4, NAN, NAN), "met"));
    CHECK(is(judged(most, .41, NAN, NAN), "not met"));
    CHECK(is(judged(most, NAN, .3, .5), "not known"));
}
