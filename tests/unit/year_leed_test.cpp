// SPDX-License-Identifier: BSD-3-Clause
// LEED's option 1, the mean daylight factor and months, from rooms that can be counted by hand.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>

#include "temp_folder.h"
#include "year/daylight_factor.h"
#include "year/leed.h"
#include "year/months.h"
#include "year/text.h"

namespace {

using namespace year;

GridYear space(const char* name, size_t sensors, Bounded spatial, Bounded exposed = {}) {
    GridYear y;
    y.name = name, y.hours = 3650, y.sun_hours = 3650;
    y.sensors.resize(sensors), y.spatial = spatial, y.exposed = exposed;
    return y;
}
Bounded exactly(double x) { return {x, x, x}; }

Leed leed(const std::vector<GridYear>& spaces) { return judge_leed(spaces, {}); }

}  // namespace

TEST_CASE("points by sDA over all sensors: 40, 55 and 75 %") {
    const auto points = [](double share) { return leed({space("a", 100, exactly(share))}).points; };
    CHECK(points(.39) == 0);
    CHECK(points(.40) == 1);
    CHECK(points(.54) == 1);
    CHECK(points(.55) == 2);
    CHECK(points(.75) == 3);
    // 30 sensors of 90 % and 70 of 40 % are 55 %.
    const Leed two = leed({space("a", 30, exactly(.9)), space("b", 70, exactly(.4))});
    CHECK(two.spatial.value == doctest::Approx(.55));
    CHECK(two.points == 2);
    CHECK(!two.each);
    CHECK(lines_of(two) ==
          "LEED v4.1 option 1: 2 points, sDA 55.0 % of 100 sensors in 2 spaces\n"
          "each      1 of the spaces have 55 %: no point more\n");
}

TEST_CASE("points within an interval are either, glare is named, and what LM-83 asks besides") {
    const Leed l = leed({space("a", 1, {.6, .54, .76}, exactly(.11)), space("b", 1, {.6, .54, .76}, exactly(.10))});
    CHECK(l.low == 1);
    CHECK(l.high == 3);
    CHECK(lines_of(l) ==
          "LEED v4.1 option 1: 1 to 3 points, sDA 60.0 % (54.0 to 76.0) of 2 sensors in 2 spaces\n"
          "each      0 of the spaces have 55 %: undecided\n"
          "glare     ASE above 10 %, say what is done about it: a\n");
    GridYear part = space("c", 1, exactly(1));
    part.hours = 2600, part.sun_hours.reset();
    CHECK(lines_of(leed({part}))
              .find("lacks     c has 2600 hours, not the 3650 from 8 to 18\n"
                    "lacks     c has no direct sun (-direct)\n") != std::string::npos);
    Goals other;
    other.autonomy_lux = 500;
    CHECK(error_text([&] { judge_leed({part}, other); }) ==
          "-leed: asks 300 lx in 50 % of the hours and 1000 lx in 250 (-sda, -ase)");
}

TEST_CASE("mean daylight factor: the mean of the sensors by the light outdoors") {
    TempFolder folder;
    const std::string head = "grid\tpoint\tE\tlo\thi\n";
    const std::string table = folder.holding(
        "df.tsv", head + "floor\t0\t300\t300\t300\nfloor\t1\t100\t100\t100\ndesk\t0\t500\t490.2\t509.8\n");
    const std::vector<DaylightFactor> f = daylight_factors(table, 10000, .05);
    REQUIRE(f.size() == 2);
    CHECK(f[0].mean.value == doctest::Approx(.02));
    CHECK(line_of(f[0], 10000) == "DF        2.00 % of 10000 lx outdoors, mean of the sensors\n");
    CHECK(line_of(f[1], 10000) == "DF        5.00 % (4.90 to 5.10) of 10000 lx outdoors, mean of the sensors\n");
    const auto said = [&](const std::string& text) {
        const std::string file = folder.holding("other.tsv", text);
        return error_text([&] { daylight_factors(file, 10000, .05); }).substr(file.size());
    };
    CHECK(said(head + "floor\t1\t300\t300\t300\n") ==
          ": floor: point 1 where 0 comes next: one picture of the points is wanted");
    CHECK(said(head + "floor\t0\tnan\tnan\tnan\n") == ": floor: point 0 has no value with an interval");
    CHECK(said("sky\tDGP\n0621_1230\t.3\n") == ": has no column grid (vcmetrics -each of points)");
}

TEST_CASE("a month counts its own hours") {
    Grid g{"floor", {}};
    for (int month = 1; month <= 3; ++month)
        for (int day = 1; day <= 10; ++day)
            g.hours.push_back({{{month, day}, 12.5}, {{month > 1 && day <= 5 * (month - 1) ? 400.f : 10.f, 0}}});
    CHECK(months_of(g) == std::vector<int>{1, 2, 3});
    const auto autonomy = [&](int month) { return judge(of_month(g, month), nullptr, {}, .05).autonomy.value; };
    CHECK(autonomy(1) == 0);
    CHECK(autonomy(2) == doctest::Approx(.5));
    CHECK(autonomy(3) == doctest::Approx(1));
    const report::Line row = with_month(line_of(judge(of_month(g, 2), nullptr, {}, .05)), 2);
    CHECK(row.names[0] == "month");
    CHECK(row.cells[0].text == "Feb");
    CHECK(row.names[1] == "grid");
}
