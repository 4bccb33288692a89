// SPDX-License-Identifier: BSD-3-Clause
// Hours in which the state of shades is in doubt: a state other than the most closed one is one that kept the limit.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "temp_folder.h"
#include "year/shades.h"
#include "year/verdict.h"
#include "year_shade_states.h"

using namespace year;

TEST_CASE("a view in doubt holds what all states may let it have, and keeps the value of the likely one") {
    const auto s = states_of({{"open", {.3, .41, .6}}, {"shut", {.1, .2, .2}}}, .01);
    const ShadeYear y = controlled(s, "glare");
    CHECK(letters(y) == "o o|s s");
    const std::vector<View> views = with_shades(s.open().views, s, y);
    const uncertainty::Uncertain doubtful = views[0].hours[1].dgp;
    CHECK(doubtful.value == .2);
    CHECK(doubtful.at(-1) == doctest::Approx(.2));
    CHECK(doubtful.at(1) == doctest::Approx(.4));  // more would have closed them
    CHECK(views[0].hours[0].dgp.value == .3);
    CHECK(views[0].hours[2].dgp.value == .2);
    CHECK(views[0].hours[2].dgp.bound == 0);
}

TEST_CASE("shades that glare leaves open keep its limit, whatever the table says of that state") {
    const auto most = [](const ShadeStates& s, const std::string& rules, size_t hour, const Setting& setting) {
        return most_dgp(controlled(s, rules), hour, setting, "desk");
    };
    const auto s = states_of({{"open", {.39, .41, .5}}, {"half", {.3, .39, .41}}, {"shut", {.2, .3, .41}}}, .02);
    const double any = INFINITY;
    CHECK(most(s, "glare .40", 1, {0}) == .4);
    CHECK(most(s, "glare .40", 1, {1}) == .4);
    CHECK(most(s, "glare .40", 1, {2}) == any);  // nothing is left to close
    CHECK(most_dgp(controlled(s, "glare .40 at desk"), 1, {1}, "door") == any);
    CHECK(most(s, "glare .40; glare .35 at desk", 1, {1}) == .35);
    CHECK(most(s, "glare .40 until .35", 1, {0}) == .4);
    CHECK(most(s, "glare .40 until .35", 1, {1}) == any);  // it may have been half closed before
    CHECK(most(s, "glare .40 until morning", 1, {1}) == any);
    TempFolder folder;
    const std::string half = folder.holding("s.txt", "0101_0030 half\n0101_0130 half\n0101_0230 half\n");
    CHECK(most(s, "glare .40; schedule " + half, 0, {1}) == any);  // it may be the schedule's alone
    // A group keeps it in the room as it decided, with those after it closed.
    const std::vector<double> dim{.39};
    const auto two = states_of(
        {{"w/open+s/open", dim}, {"w/open+s/shut", dim}, {"w/shut+s/open", dim}, {"w/shut+s/shut", dim}}, .02);
    CHECK(most(two, "glare", 0, {0, 0}) == .4);
    CHECK(most(two, "glare", 0, {0, 1}) == .4);
    CHECK(most(two, "w: glare", 0, {0, 1}) == .4);
    CHECK(most(two, "w: glare", 0, {0, 0}) == any);
    CHECK(most(two, "glare", 0, {1, 1}) == any);
}

TEST_CASE("of hours in doubt only the most closed state may be above the limit of glare") {
    const auto s = states_of({{"open", {.41, .41, .43}}, {"half", {.39, .41, .43}}, {"shut", {.2, .39, .41}}}, .01);
    const ShadeYear y = controlled(s, "glare .40");
    CHECK(letters(y) == "o|h|s o|h|s s");
    const Verdict v = judge(with_shades(s.open().views, s, y)[0], .05);
    CHECK(v.above[1].low == 0);
    CHECK(v.above[1].high == 2);  // the first hour is shut at .2, or below .40
    CHECK(v.above[0].low == 2);
    CHECK(v.above[0].high == 3);
}
