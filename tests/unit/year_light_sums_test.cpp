// SPDX-License-Identifier: BSD-3-Clause
// Light of groups of shades that do not see each other, added up from tables of each group with the others black.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "year/light_sums.h"
#include "year/shades.h"
#include "year_shade_states.h"

namespace {

using namespace year;

uncertainty::HalfCodes codes_of(const std::vector<double>& halves) { return uncertainty::halves_of(halves, 8).codes; }

// One sensor with this light and error, whose half-samples are such.
GridHour hour_of(float lux, float error, const uncertainty::HalfCodes& halves) {
    return {hour_number(12), {{lux, error}}, {halves}, 8, 8, "p"};
}

StateTables tables_of(const std::string& state, float lux) {
    StateTables t{state, {}};
    Grid floor{"floor", {{hour_number(12), {{lux, 0}}}}};
    t.tables.grids = {floor};
    return t;
}

std::vector<StateTables> apart() {
    return {tables_of("s/open+w/black", 210), tables_of("s/half+w/black", 110), tables_of("s/black+w/black", 10),
            tables_of("s/black+w/open", 410), tables_of("s/black+w/shut", 60)};
}

float lux_of(const ShadeStates& s, const std::string& state) {
    return s.hour_of_grid(state, "floor", hour_number(12).minute_of_year()).sensors[0].value;
}

}  // namespace

TEST_CASE("a combination has the light of each group, and once what enters with all black") {
    const ShadeStates s(apart());
    REQUIRE(s.groups.size() == 2);
    CHECK(s.groups[0].states == std::vector<std::string>{"open", "half"});
    CHECK(s.groups[1].states == std::vector<std::string>{"open", "shut"});
    CHECK(lux_of(s, "s/open+w/open") == 610);
    CHECK(lux_of(s, "s/half+w/open") == 510);
    CHECK(lux_of(s, "s/open+w/shut") == 260);
    CHECK(s.open().grids[0].hours[0].sensors[0].value == 610);
    const ShadeYear y = control(s, {nullptr, &s}, parse_shade_rules("sun 0% 500", "-shades"));
    // Each answers for its own, with the other at its most closed state: 260 lx for the south, 510 for the west.
    CHECK(letters(y, 0) == "o");
    CHECK(letters(y, 1) == "s");
    CHECK(with_shades(s.open().grids, s, y)[0].hours[0].sensors[0].value == 260);
}

TEST_CASE("all black must be there; with all combinations black is a state as others are") {
    std::vector<StateTables> some = apart();
    some.erase(some.begin() + 2);
    std::string fact;
    try {
        const ShadeStates s(some);
    } catch (const base::Error& e) {
        fact = e.text;
    }
    CHECK(fact == "state s/black+w/black: is not in the tables");
    const ShadeStates all({tables_of("s/open+w/open", 9), tables_of("s/open+w/black", 5),
                           tables_of("s/black+w/open", 5), tables_of("s/black+w/black", 1)});
    CHECK(all.groups[0].states == std::vector<std::string>{"open", "black"});
    CHECK(lux_of(all, "s/open+w/open") == 9);
}

TEST_CASE("errors that runs of one seed have in common add up or cancel, others add in squares") {
    std::vector<double> a, b, c;
    for (int k = 0; k < int(uncertainty::half_samples); ++k)
        a.push_back(k % 2 ? 1 : -1), b.push_back(k / 2 % 2 ? 1 : -1), c.push_back(k % 2 ? -1 : 1);
    const GridHour x = hour_of(100, 3, codes_of(a)), y = hour_of(50, 4, codes_of(b)), z = hour_of(50, 4, codes_of(c));
    const GridHour apart = sum_of({{1, &x}, {1, &y}}), against = sum_of({{1, &x}, {1, &z}}),
                   less = sum_of({{1, &x}, {-1, &z}});
    CHECK(apart.sensors[0].value == 150);
    CHECK(apart.sensors[0].error == doctest::Approx(5));
    CHECK(against.sensors[0].error == doctest::Approx(1));
    CHECK(less.sensors[0].error == doctest::Approx(7));
    CHECK(less.sensors[0].value == 50);
    CHECK(uncertainty::off(less.halves[0])[1] == doctest::Approx(1));
    GridHour bare = y;
    bare.halves.clear();
    const GridHour unknown = sum_of({{1, &x}, {1, &bare}});
    CHECK(unknown.sensors[0].error == 7);
    CHECK(unknown.strata == 0);
}
