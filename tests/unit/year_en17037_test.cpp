// SPDX-License-Identifier: BSD-3-Clause
// EN 17037 of rooms that can be counted by hand: daylight hours, provision, at the limits and in doubt.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "temp_folder.h"
#include "year/en17037_text.h"

namespace {

using namespace year;

weather::Time hour_number(int i) { return {weather::date_of(1 + i / 24), i % 24 + .5}; }

// A table whose row is a sensor and whose column is one of the first hours of the year.
Grid grid_of(const std::vector<std::vector<float>>& sensors, float error = 0) {
    Grid g{"floor", {}};
    for (size_t h = 0; h < sensors.front().size(); ++h) {
        g.hours.push_back({hour_number(int(h)), {}});
        for (const std::vector<float>& of : sensors) g.hours.back().sensors.push_back({of[h], error * of[h]});
    }
    return g;
}

// The first `lit` hours of the year, and so many dark ones.
DaylightHours hours_by_day(size_t lit, size_t dark = 0) {
    DaylightHours d{"site.epw", lit + dark, {}, {}};
    for (size_t i = 0; i < lit; ++i) d.lit.push_back(hour_number(int(i)));
    for (size_t i = 0; i < dark; ++i) d.dark.push_back(hour_number(int(lit + i)));
    return d;
}

Provision provision(const Grid& grid, const DaylightHours& hours, bool rooflight = false) {
    return judge_provision(grid, hours, rooflight, .05);
}

std::vector<double> shares(const Provision& p) {
    std::vector<double> out;
    for (const Bounded& b : p.plane) out.push_back(b.value);
    return out;
}

// 8760 hours whose diffuse irradiance this function gives.
template <class Diffuse>
weather::Weather weather_of(double latitude_deg, const Diffuse& diffuse) {
    weather::Weather w;
    w.path = "site.wea", w.latitude_deg = latitude_deg;
    for (int day = 1; day <= 366; ++day) {
        if (day == weather::leap_day) continue;
        for (int hour = 0; hour < 24; ++hour) {
            weather::Hour h;
            h.time = {weather::date_of(day), hour + .5};
            h.diffuse_wm2 = diffuse(day, hour);
            h.line = uint32_t(w.hours.size() + 1);
            w.hours.push_back(h);
        }
    }
    return w;
}

}  // namespace

TEST_CASE("a room by hand: four sensors, eight daylight hours, of which four are asked") {
    const Grid room = grid_of({{800, 800, 800, 800, 0, 0, 0, 0},          // 750 lx in half of them
                               {0, 0, 600, 600, 310, 310, 0, 0},          // 300 lx in half of them
                               {100, 100, 100, 100, 100, 100, 100, 100},  // 100 lx in all
                               {900, 900, 900, 99, 99, 99, 99, 99}});     // nothing in half of them
    const Provision p = provision(room, hours_by_day(8));
    CHECK(shares(p) == std::vector<double>{.75, .5, .25, .25});
    CHECK(p.hours == 8);
    REQUIRE(p.sensors.size() == 4);
    CHECK(p.sensors[1][0].value == .5);  // 100 lx in four of eight hours
    CHECK(p.sensors[1][2].value == .25);
    CHECK(p.sensors[3][3].high == .375);
    CHECK(p.level == 0);  // 100 lx on 75 % is less than 95 %
    CHECK(p.low == 0);
    CHECK(p.high == 0);
    CHECK(lines_of(p) ==
          "provision EN 17037 none: 300 lx on 50.0 %, 100 lx on 75.0 % of the sensors in half of 8 daylight hours\n"
          "lacks     for minimum: 100 lx on 75.0 % where 95 % are asked\n");
}

TEST_CASE("each level asks its target on half and its minimum on 95 % of the plane") {
    // 20 sensors; `bright` of them have the target, the others the minimum, but for `dim`.
    const auto level = [](float target, int bright, float least, int dim) {
        std::vector<std::vector<float>> sensors;
        for (int i = 0; i < 20; ++i) sensors.push_back({i < bright ? target : i < 20 - dim ? least : 0, 0});
        return provision(grid_of(sensors), hours_by_day(2)).level;
    };
    CHECK(level(300, 10, 100, 0) == 1);
    CHECK(level(300, 10, 100, 1) == 1);  // 19 of 20 are 95 %
    CHECK(level(300, 10, 100, 2) == 0);
    CHECK(level(300, 9, 100, 0) == 0);
    CHECK(level(500, 10, 300, 1) == 2);
    CHECK(level(500, 9, 300, 1) == 1);
    CHECK(level(750, 10, 500, 1) == 3);
    CHECK(level(750, 10, 499.9f, 1) == 2);
    CHECK(level(2000, 10, 100, 1) == 1);
    CHECK(std::string(level_name(3)) == "high");
}

TEST_CASE("half of the hours and the illuminance itself are enough; dark hours count, and need no row") {
    CHECK(provision(grid_of({{300, 300, 100, 100}}), hours_by_day(4)).level == 1);
    CHECK(provision(grid_of({{299.9f, 300, 100, 100}}), hours_by_day(4)).level == 0);
    CHECK(provision(grid_of({{300, 300, 300}}), hours_by_day(3, 3)).level == 1);
    CHECK(provision(grid_of({{300, 300, 300}}), hours_by_day(3, 4)).level == 0);
    CHECK(provision(grid_of({{300, 300, 300}}), hours_by_day(3, 2)).level == 1);
    // Hours of the table that are no daylight hours do not count.
    CHECK(shares(provision(grid_of({{0, 0, 900, 900, 900}}), hours_by_day(2))) == std::vector<double>{0, 0, 0, 0});
}

TEST_CASE("below a rooflight the target is on 95 % of the plane, and there is no minimum") {
    std::vector<std::vector<float>> sensors(20, {300});
    sensors[0] = {0};
    CHECK(provision(grid_of(sensors), hours_by_day(1), true).level == 1);
    CHECK(provision(grid_of(sensors), hours_by_day(1)).level == 1);
    sensors[1] = {100};
    const Provision p = provision(grid_of(sensors), hours_by_day(1), true);
    CHECK(p.level == 0);
    CHECK(provision(grid_of(sensors), hours_by_day(1)).level == 1);
    CHECK(lines_of(p) ==
          "provision EN 17037 none: 300 lx on 90.0 % of the sensors in half of 1 daylight hours\n"
          "lacks     for minimum: 300 lx on 90.0 % where 95 % are asked\n");
}

TEST_CASE("a level within noise, or within hours without values, is either") {
    const Provision noisy = provision(grid_of({{300, 300}}, .1f), hours_by_day(2));
    CHECK(noisy.low == 0);
    CHECK(noisy.high == 1);
    CHECK(lines_of(noisy).find("EN 17037 undecided, none to minimum: 300 lx on 100.0 % (0.0 to 100.0)") !=
          std::string::npos);
    const Provision far = provision(grid_of({{400, 400}}, .01f), hours_by_day(2));
    CHECK(far.low == 1);
    CHECK(far.high == 1);
    const Provision unknown = provision(grid_of({{800, 800, 0, NAN}}), hours_by_day(4));
    CHECK(unknown.low == 3);  // half of the hours are known to do
    const Provision missing = provision(grid_of({{800, 0, 0, NAN}}), hours_by_day(4));
    CHECK(missing.low == 0);
    CHECK(missing.high == 3);
    report::Line line;
    add(line, missing);
    CHECK(line.names.front() == "provision");
    CHECK(line.cells[0].text == "undecided");
    CHECK(line.cells[1].text == "high");
    CHECK(line.names.size() == 3 + 4 * 3);
}

TEST_CASE("hours that are missing are named") {
    CHECK(
        error_text([] {
            provision(grid_of({{300, 300}}), hours_by_day(4));
        }) ==
        "floor: lacks 2 of the 4 hours that have the most diffuse light in site.epw, 0101_0230 first: EN 17037 counts "
        "those of the whole year");
}

TEST_CASE("a table with light where the weather file has none is another file's") {
    const DaylightHours d = daylight_hours(weather_of(0, [](int, int hour) { return hour < 9 ? 0. : 50.; }));
    CHECK(error_text([&] {
              hours_in(d, grid_of({{0, 0, 5}}));
          }) == "floor: 0101_0230 has light, for which site.wea has none: the table is of another weather file");
}

TEST_CASE("daylight hours are the half of the year with the most diffuse irradiance, of equal ones the earlier") {
    // Noon to one o'clock the brightest, the later hours of each day less, the morning without.
    const auto by_clock = [](int, int hour) { return hour < 12 ? 0. : 100. - hour; };
    const DaylightHours d = daylight_hours(weather_of(0, by_clock));
    CHECK(d.hours == 4380);
    CHECK(d.lit.size() + d.dark.size() == 4380);
    CHECK(d.lit.size() >= 365 * 6);  // at the equator the sun sets at six, at times some minutes later
    std::set<int> clock;
    for (const weather::Time& t : d.lit) clock.insert(int(t.hour));
    CHECK(clock == std::set<int>{12, 13, 14, 15, 16, 17, 18});
    const DaylightHours alike = daylight_hours(weather_of(0, [](int, int) { return 50; }));
    CHECK(name_of(alike.lit.front()) == "0101_0630");
    CHECK(name_of(alike.lit.back()) == "0702_1130");  // the first 182.5 days
}

TEST_CASE("polar day: nights of summer are daylight hours, winter has none") {
    const auto polar = [](int day, int) { return std::max(0., 200 * std::sin((day - 81) * 3.14159265 / 186)); };
    const DaylightHours d = daylight_hours(weather_of(90, polar));
    CHECK(d.dark.size() < 60);
    std::set<int> days, clock;
    for (const weather::Time& t : d.lit) days.insert(t.date.in_leap_year()), clock.insert(int(t.hour));
    CHECK(clock.size() == 24);
    CHECK(*days.begin() >= 81);
    CHECK(*days.rbegin() <= 270);
}

TEST_CASE("a file that does not say which hours are daylight is refused") {
    weather::Weather w = weather_of(0, [](int, int) { return 50.; });
    w.hours[12].diffuse_wm2 = 9999;
    CHECK(error_text([&] { daylight_hours(w); }) ==
          "site.wea:13: has no diffuse irradiance, by which daylight hours count");
    w.hours[12].diffuse_wm2 = 50, w.hours[0].diffuse_wm2 = 9999;  // by night it has none
    CHECK(daylight_hours(w).hours == 4380);
    w.hours.resize(48);
    CHECK(error_text([&] { daylight_hours(w); }) == "site.wea: has 2 days of hours; EN 17037 counts those of a year");
}
