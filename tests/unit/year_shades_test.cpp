// SPDX-License-Identifier: BSD-3-Clause
// Shades that move by rules: closed forms of each rule, what is in doubt, and what a year of them comes to.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "temp_folder.h"
#include "weather/light.h"
#include "year/shade_text.h"
#include "year/shades.h"
#include "year_shade_states.h"

namespace {

using namespace year;

template <class F>
std::string fault(const F& f) {
    try {
        f();
    } catch (const base::Error& e) {
        return e.text;
    }
    return "";
}

// A grid of 100 sensors of which so many have 1200 lx in each hour.
ShadeStates sunny(const std::vector<int>& counts) {
    Grid floor{"floor", {}};
    for (size_t i = 0; i < counts.size(); ++i) {
        GridHour h{hour_number(int(i)), {}};
        for (int k = 0; k < 100; ++k) h.sensors.push_back({k < counts[i] ? 1200.f : 900.f, 0});
        floor.hours.push_back(h);
    }
    StateTables open{"", {}};
    open.tables.grids = {floor};
    return ShadeStates({open});
}

// Does any of 1000 parallel rays between two slats pass?
bool sun_passes(const Slats& s, double tilt_deg, double profile_deg) {
    const double r = std::acos(-1.) / 180, tilt = tilt_deg * r, slope = std::tan(profile_deg * r);
    for (int i = 0; i < 1000; ++i) {
        // A ray is z = z0 + x slope, x outward; slat k lies along (x, k spacing - x tan(tilt)), |x| <= width/2
        // cos(tilt).
        const double z0 = s.spacing * (i + .5) / 1000;
        bool stopped = false;
        for (int k = -60; k <= 60 && !stopped; ++k) {
            const double x = (k * s.spacing - z0) / (slope + std::tan(tilt));
            stopped = std::fabs(x) <= s.width / 2 * std::cos(tilt);
        }
        if (!stopped) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("the cut-off angle of slats for ten suns, by hand and by rays") {
    const Slats slats{180, .05, .042};
    const double suns[10][4] = {// altitude, azimuth, profile angle, cut-off angle
                                {10, 180, 10.000, 45.816},      {30, 180, 30.000, 16.674},  {60, 180, 60.000, -35.165},
                                {45, 135, 54.736, -25.725},     {20, 240, 36.052, 6.723},   {5, 100, 26.740, 21.865},
                                {70, 200, 71.118, -55.345},     {50, 225, 59.318, -33.937}, {15, 265, 71.982, -56.922},
                                {26.41, 187.96, 26.632, 22.035}};
    for (const auto& [altitude, azimuth, profile, cut_off] : suns) {
        CAPTURE(altitude);
        CAPTURE(azimuth);
        const auto p = profile_angle_deg(altitude, azimuth, 180);
        REQUIRE(p);
        CHECK(*p == doctest::Approx(profile).epsilon(1e-4));
        const auto tilt = cut_off_deg(slats, *p);
        REQUIRE(tilt);
        CHECK(*tilt == doctest::Approx(cut_off).epsilon(1e-4));
        CHECK(!sun_passes(slats, *tilt + .3, *p));
        CHECK(sun_passes(slats, *tilt - .3, *p));
        CHECK(keep_out(slats, *tilt + .3, *p));
        CHECK(!keep_out(slats, *tilt - .3, *p));
    }
    CHECK(!profile_angle_deg(20, 280, 180));  // behind the facade
    CHECK(!profile_angle_deg(-1, 180, 180));
    CHECK(!cut_off_deg({180, .04, .05}, 10));  // gaps that no tilt covers
}

TEST_CASE("glare takes the most open state that keeps the limit; where that is in doubt an hour may be either") {
    const auto s = states_of({{"open", {.2, .5, .6, .399, .45, .401}},
                              {"half", {.2, .3, .5, .3, .399, .41}},
                              {"shut", {.2, .2, .5, .2, .2, .2}}});
    const ShadeYear y = controlled(s, "glare .40");
    CHECK(letters(y) == "o h s o|h h|s o|s");
    CHECK(y.of_group[0][3].best == 0);
    CHECK(y.of_group[0][4].best == 1);
    CHECK(y.of_group[0][5].best == 2);
    CHECK(!y.of_group[0][0].rule);
    CHECK(y.of_group[0][1].rule == 0);
    CHECK(letters(controlled(s, "glare .55")) == "o o h o o o");
}

TEST_CASE("shades that close stay so until glare is lower, or until the morning") {
    const std::vector<double> open{.3, .45, .38, .36, .34, .39}, shut(6, .2);
    const auto s = states_of({{"open", open}, {"shut", shut}});
    CHECK(letters(controlled(s, "glare .40")) == "o s o o o o");
    CHECK(letters(controlled(s, "glare .40 until .35")) == "o s s s o o");
    CHECK(letters(controlled(s, "glare .40 until morning")) == "o s s s s s");
    const auto doubtful = states_of({{"open", {.3, .4001, .38, .34, .39, .3}}, {"shut", shut}});
    CHECK(letters(controlled(doubtful, "glare .40 until .35")) == "o o|s o|s o o o");
    std::vector<double> days(48, .3);
    days[10] = .5;
    const ShadeYear y =
        controlled(states_of({{"open", days}, {"shut", std::vector<double>(48, .2)}}), "glare until morning");
    CHECK(y.of_group[0][23].best == 1);
    CHECK(y.of_group[0][24].best == 0);
    CHECK(group_years(y)[0].moves.value == 2);
}

TEST_CASE("LM-83: more than 2 % of the sensors with 1000 lx of direct sun close the shades") {
    const std::vector<double> none(5, .2);
    const auto s = states_of({{"open", none}, {"shut", none}});
    const auto direct = sunny({0, 1, 2, 3, 100});
    CHECK(letters(controlled(s, "sun", &direct)) == "o o o s s");
    CHECK(letters(controlled(s, "sun 2% 1000", &direct)) == "o o o s s");
    CHECK(letters(controlled(s, "sun 3% 1000 at floor", &direct)) == "o o o o s");
    CHECK(letters(controlled(s, "sun 2% 1300", &direct)) == "o o o o o");
    CHECK(letters(controlled(s, "sun 2% 900", &direct)) == "s s s s s");
    CHECK(letters(controlled(s, "sun until morning", &direct)) == "o o o s s");
    CHECK(fault([&] { controlled(s, "sun at wall", &direct); }) == "sun at wall: -direct has none of these grids");
    CHECK(fault([&] { controlled(s, "sun"); }) == "sun: reads a table of sensors under direct sun: -direct");
}

TEST_CASE("direct sun in W/m2, by the efficacy of the hour's sun") {
    TempFolder folder;
    const std::string site = folder.holding(
        "site.wea",
        "place Here\nlatitude 40\nlongitude 0\ntime_zone 0\nsite_elevation 0\nweather_data_file_units 1\n"
        "1 1 11.5 800 60\n1 1 12.5 0 60\n");
    std::vector<StateTables> tables{{"open", {}}, {"shut", {}}};
    for (StateTables& t : tables) {
        t.tables.views = {View{"desk", {}}};
        t.tables.views[0].hours = {hour_of_dgp(11, .2), hour_of_dgp(12, .2)};
    }
    const ShadeStates s(tables);
    StateTables sun{"", {}};
    sun.tables.grids = {Grid{"facade", {{hour_number(11), {{1200, 0}}}, {hour_number(12), {{1200, 0}}}}}};
    const ShadeStates direct({sun});
    const weather::Weather w = weather::read_weather(site);
    const double lumens = 179 * weather::light_of(w, w.hours[0])->sun_irradiance / 800;
    CHECK(lumens > 80);
    CHECK(lumens < 120);
    const auto of = [&](double limit) {
        return letters(controlled(s, fmt::format("sun 0% {:.4f}W at facade weather {}", limit, site), &direct));
    };
    CHECK(of(1200 / lumens * .999) == "s o");  // without a sun there is none to shut out
    CHECK(of(1200 / lumens * 1.001) == "o o");
    CHECK(fault([&] { controlled(s, "sun 0% 50W", &direct); }) ==
          "-shades: W/m2 need the file that the sun comes from: weather site.epw");
}

TEST_CASE("a schedule names states by hours, or numbers them for each hour of the year") {
    TempFolder folder;
    const std::vector<double> dgps(30, .3);
    const auto s = states_of({{"open", dgps}, {"half", dgps}, {"shut", dgps}});
    const auto of = [&](const std::string& text) {
        return letters(controlled(s, "schedule " + folder.holding("s.txt", text)));
    };
    std::string hours = "o h s";
    for (int i = 3; i < 30; ++i) hours += " o";
    CHECK(of("0101_0130 half\n0101_0230 shut\n") == hours);
    CHECK(of("sky\tgroup\tstate\n0101_0130\t-\thalf\n0101_0130\twest\tshut\n0101_0230\t-\tshut\n") == hours);
    std::string numbers = "0\n1\n2\n";
    for (int i = 3; i < 8760; ++i) numbers += "0\n";
    CHECK(of(numbers) == hours);
    CHECK(of("month,day,hour,state\n1,1,1.5,1\n1,1,2.5,2\n") == hours);
    CHECK(of(moves_table(controlled(s, "schedule " + folder.holding("m.txt", "0101_0130 half\n0101_0230 shut\n")))) ==
          hours);
    std::string list = "0, 1,2";
    for (int i = 3; i < 8760; ++i) list += ",0";
    const std::string json =
        "{\"west\": {\"schedule\": [9]}, \"\": {\"identifier\": \"x\", \"schedule\": [" + list + "]}}";
    CHECK(of(json) == hours);
    CHECK(of("{\"west\": [9], \"\": [" + list + "]}") == hours);
    CHECK(fault([&] { of("{\"west\": [1]}"); }).find("has no schedule of the group \"\"") != std::string::npos);
    CHECK(fault([&] { of("{\"\": [1, x]}"); }).find("\" x\" is not the number of a state") != std::string::npos);
    CHECK(fault([&] { of("0101_0130 ajar\n"); }).find("0101_0130: no state is called \"ajar\"") != std::string::npos);
    CHECK(fault([&] { of("1\n2\n"); }).find("has 2 numbers, not 8760 or 8784") != std::string::npos);
    CHECK(fault([&] { of("0101_0130 half\nhuh\n"); }).find("s.txt:2: \"huh\" is neither") != std::string::npos);
}

TEST_CASE("of several rules the most closed state counts, and the rule that asks for it is named") {
    TempFolder folder;
    const auto s = states_of({{"open", {.5, .3, .3}}, {"half", {.3, .3, .3}}, {"shut", {.2, .2, .2}}});
    const ShadeYear y =
        controlled(s, "glare .40; schedule " + folder.holding("s.txt", "0101_0030 shut\n0101_0130 half\n"));
    CHECK(letters(y) == "s h o");
    CHECK(y.of_group[0][0].rule == 1);
    const GroupYear g = group_years(y)[0];
    CHECK(g.closed_by == std::vector<size_t>{0, 2});
    CHECK(g.moves.value == 2);
}

TEST_CASE("groups decide in their order, each with those after it closed") {
    // Glare comes through the south alone.
    const std::vector<double> glare{.5}, fine{.3};
    const auto s = states_of({{"west/open+south/open", glare},
                              {"west/open+south/shut", fine},
                              {"west/shut+south/open", glare},
                              {"west/shut+south/shut", fine}});
    const ShadeYear y = controlled(s, "glare");
    CHECK(letters(y, 0) == "o");
    CHECK(letters(y, 1) == "s");
    CHECK(settings_at(y, 0) == std::vector<Setting>{{0, 1}});
    CHECK(letters(controlled(s, "west: glare"), 1) == "o");
    CHECK(fault([&] { controlled(s, "north: glare"); }) == "north: glare: no group is called \"north\"");
}

TEST_CASE("shades close where any view is above the limit, and each view has its hour of the closed state") {
    View desk{"desk", {}}, door{"door", {}};
    for (const double dgp : {0., .2, .41, .6, .8}) {
        const int i = int(desk.hours.size());
        desk.hours.push_back(hour_of_dgp(i, dgp, .001)), door.hours.push_back(hour_of_dgp(i, i ? .1 : .9, .001));
    }
    desk.hours[2].dgp = {.41, .01, .002};
    View shut_desk = desk, shut_door = door;
    for (View* v : {&shut_desk, &shut_door})
        for (Hour& h : v->hours) h.dgp = {.2, .001, .003};
    StateTables open{"open", {}}, shut{"shut", {}};
    open.tables.views = {desk, door}, shut.tables.views = {shut_door, shut_desk};
    const ShadeStates s({open, shut});
    const ShadeYear y = controlled(s, "glare .40");
    CHECK(letters(y) == "s o o|s s s");
    const Bounded closed = group_years(y)[0].hours[1];
    CHECK(closed.value == 4);
    CHECK(closed.low == 3);
    CHECK(closed.high == 4);
    const std::vector<View> views = with_shades(s.open().views, s, y);
    const auto dgp = [&](size_t view, size_t hour) { return views[view].hours[hour].dgp; };
    CHECK(dgp(0, 0).value == .2);
    CHECK(dgp(1, 0).value == .2);
    CHECK(dgp(0, 1).value == .2);  // open: its own
    CHECK(dgp(0, 1).bound == 0);
    CHECK(dgp(1, 3).value == .2);
    CHECK(dgp(0, 2).at(1) == doctest::Approx(.4));
    CHECK(dgp(0, 2).at(-1) == doctest::Approx(.197));
    CHECK(dgp(0, 2).error == .01);
    shut.tables.views[1].hours.pop_back();
    const ShadeStates some({open, shut});
    CHECK(fault([&] { with_shades(some.open().views, some, controlled(some, "glare")); }) ==
          "state shut: has no 0101_0430, in which shades may have it");
    shut.tables.views.pop_back();
    const ShadeStates none({open, shut});
    CHECK(fault([&] { with_shades(none.open().views, none, controlled(none, "glare")); }) ==
          "state shut: has no view \"desk\"");
}

TEST_CASE("moves: the fewest and the most of all ways through the states that hours may have") {
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        ShadeYear y{{{"", {"a", "b", "c"}}}, {}, {}, {{}}};
        std::vector<std::vector<size_t>> ways{{}};
        for (int i = 0; i < 6; ++i) {
            ShadeChoice c;
            c.may = 1 + random() % 7;
            while (!(c.may >> c.best & 1)) ++c.best;
            y.hours.push_back(hour_number(i));
            y.of_group[0].push_back(c);
            std::vector<std::vector<size_t>> longer;
            for (const auto& w : ways)
                for (size_t s = 0; s < 3; ++s)
                    if (c.may >> s & 1) longer.push_back(w), longer.back().push_back(s);
            ways = longer;
        }
        double least = 99, most = 0;
        for (const auto& w : ways) {
            double n = 0;
            for (size_t i = 1; i < w.size(); ++i) n += w[i] != w[i - 1];
            least = std::min(least, n), most = std::max(most, n);
        }
        const Bounded moves = group_years(y)[0].moves;
        CHECK(moves.low == least);
        CHECK(moves.high == most);
    }
}

TEST_CASE("rules are refused by name and place") {
    const auto says = [](const std::string& text) { return fault([&] { parse_shade_rules(text, "r.txt"); }); };
    CHECK(says("glare\nblink .4") == "r.txt:2: \"blink\" is no rule: glare, sun, schedule and slats are");
    CHECK(says("glare 1.4") == "r.txt:1: DGP is a number from 0 to 1");
    CHECK(says("glare .4 until .5") == "r.txt:1: until is a number from 0 to 0.4");
    CHECK(says("sun until .3") == "r.txt:1: until: only \"morning\" may follow here");
    CHECK(says("slats 180 .05 .04") == "r.txt:1: the tilts of the states are missing: tilts -,0,35");
    CHECK(says("# nothing") == "r.txt: holds no rule");
    CHECK(says("schedule a b") == "r.txt:1: \"b\" is one word too many");
    const auto rules = parse_shade_rules("south: glare .35 at a,b until morning # as people do\nsun 1% 500", "r.txt");
    REQUIRE(rules.size() == 2);
    CHECK(rules[0].group == "south");
    CHECK(rules[0].limit == .35);
    CHECK(rules[0].at == std::vector<std::string>{"a", "b"});
    CHECK(rules[0].until_morning);
    CHECK(rules[1].share == .01);
    CHECK(rules[1].lux == 500);
}
