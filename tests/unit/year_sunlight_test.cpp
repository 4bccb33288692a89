// SPDX-License-Identifier: BSD-3-Clause
// EN 17037's exposure to sunlight: steps counted by hand, the sun's height in closed form, days that are not whole.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "temp_folder.h"
#include "year/en17037_text.h"

namespace {

using namespace year;
using Dates = std::vector<weather::Date>;
using Minutes = std::function<bool(int minute)>;

constexpr double latitude_deg = 52.52;
const weather::Date equinox{3, 21};

// Steps of whole days, at the meridian of the zone: the sun is highest at noon, the equation of time apart.
weather::Weather steps(const Dates& dates, double latitude = latitude_deg, int step_min = 5) {
    weather::Weather w;
    w.path = "day.wea", w.latitude_deg = latitude, w.step_min = step_min;
    for (const weather::Date& date : dates)
        for (int m = 0; m < 24 * 60; m += step_min) {
            weather::Hour h;
            h.time = {date, m / 60.}, h.direct_wm2 = 800, h.diffuse_wm2 = 80, h.line = uint32_t(w.hours.size() + 7);
            w.hours.push_back(h);
        }
    return w;
}

// A row for each step; a point has sun in these minutes of the day.
Grid table(const weather::Weather& day, const std::vector<Minutes>& points) {
    Grid g{"room", {}};
    for (const weather::Hour& h : day.hours) {
        g.hours.push_back({h.time, {}});
        for (const Minutes& has_sun : points)
            g.hours.back().sensors.push_back({has_sun(int(std::lround(60 * h.time.hour))) ? 20000.f : 0.f, 0});
    }
    return g;
}

Minutes from(int first, int steps) {
    return [=](int minute) { return minute >= first && minute < first + 5 * steps; };
}
bool always(int) { return true; }

constexpr int noon = 12 * 60;

}  // namespace

TEST_CASE("sunlit steps of five minutes are counted: 18, 36 and 48 of them are the levels") {
    const weather::Weather day = steps({equinox});
    const auto level = [&](int n) {
        const Sunlight s = judge_sunlight(table(day, {from(noon - 120, n)}), {0}, day, 11);
        CHECK(s.hours.value == doctest::Approx(n / 12.));
        CHECK(s.low == s.high);
        return s.low;
    };
    CHECK(level(0) == 0);
    CHECK(level(17) == 0);
    CHECK(level(18) == 1);
    CHECK(level(35) == 1);
    CHECK(level(36) == 2);
    CHECK(level(47) == 2);
    CHECK(level(48) == 3);
    CHECK(line_of(judge_sunlight(table(day, {from(noon - 120, 18)}), {0}, day, 11)) ==
          "sunlight  EN 17037 minimum: 1.50 h on 21 Mar, sun at 11 degrees or more, steps of 5 min\n");
}

TEST_CASE("the sun counts from its lowest height on: cos H = sin h / cos latitude at the equinox") {
    const weather::Weather day = steps({equinox});
    for (const double lowest : {5., 11., 13., 30.}) {
        const double sine = std::sin(lowest * 3.14159265 / 180) / std::cos(latitude_deg * 3.14159265 / 180);
        const double hours = 2 * std::acos(sine) * 12 / 3.14159265;
        const Sunlight s = judge_sunlight(table(day, {always}), {0}, day, lowest);
        CHECK(std::fabs(s.hours.value - hours) < 5 / 60. + .08);  // a step; at 30 degrees .25 degrees of declination
    }
    CHECK(judge_sunlight(table(day, {always}), {0}, day, 38).hours.value == 0);  // above the sun at noon
}

TEST_CASE("openings of a room add up where the sun is not at both") {
    const weather::Weather day = steps({equinox});
    const Grid room = table(day, {from(noon - 60, 12), from(noon - 30, 12)});
    CHECK(judge_sunlight(room, {0}, day, 11).hours.value == doctest::Approx(1));
    CHECK(judge_sunlight(room, {0, 1}, day, 11).hours.value == doctest::Approx(1.5));
}

TEST_CASE("the day with most sun counts, whatever the order of days") {
    const weather::Weather days = steps({{2, 1}, equinox, {3, 1}});
    const Sunlight s = judge_sunlight(table(days, {always}), {0}, days, 11);
    CHECK(day_text(s.date) == "21 Mar");
    CHECK(s.days == 3);
    CHECK(line_of(s).find(" on 21 Mar, the best of 3 days, sun at 11") != std::string::npos);
}

TEST_CASE("a step in which frames see and miss the sun may be either") {
    const weather::Weather day = steps({equinox});
    Grid g = table(day, {from(noon - 45, 18)});
    for (GridHour& h : g.hours)
        if (std::lround(60 * h.time.hour) == noon - 45) h.sensors[0] = {9000, 2000};
    const Sunlight s = judge_sunlight(g, {0}, day, 11);
    CHECK(s.hours.low == doctest::Approx(17 / 12.));
    CHECK(s.hours.high == doctest::Approx(1.5));
    CHECK(s.low == 0);
    CHECK(s.high == 1);
    CHECK(line_of(s).find("undecided, none to minimum: 1.46 h (1.42 to 1.50)") != std::string::npos);
}

TEST_CASE("polar night has no sunlight, and needs no rows") {
    const weather::Weather night = steps({{2, 1}}, 78);
    const Sunlight s = judge_sunlight(table(steps({equinox}), {always}), {0}, night, 5);
    CHECK(s.hours.high == 0);
    CHECK(s.low == 0);
}

TEST_CASE("days that are not whole, of another season or in long steps are refused") {
    const auto said = [](const weather::Weather& day, const Grid& g) {
        return error_text([&] { judge_sunlight(g, {0}, day, 11); });
    };
    const weather::Weather day = steps({equinox});
    const Grid g = table(day, {always});
    CHECK(said(steps({{4, 1}}), g) == "day.wea:7: 1 Apr: EN 17037 takes a day from 1 February to 21 March");
    CHECK(said(steps({{1, 31}}), g) == "day.wea:7: 31 Jan: EN 17037 takes a day from 1 February to 21 March");
    CHECK(said(steps({equinox}, latitude_deg, 10), g) == "day.wea: has steps of 10 minutes: five or less are wanted");
    weather::Weather part = day;
    part.hours.erase(part.hours.begin(), part.hours.begin() + 12 * 12);
    CHECK(said(part, g) ==
          "day.wea:151: the sun is higher than 11 degrees before this step, where the file has none 5 minutes away");
    part.hours.erase(part.hours.begin() + 3, part.hours.begin() + 5);
    part.hours.insert(part.hours.begin(), day.hours.begin(), day.hours.begin() + 12 * 12);
    CHECK(said(part, g) ==
          "day.wea:153: the sun is higher than 11 degrees after this step, where the file has none 5 minutes away");
    CHECK(said(day, table(part, {always})) == "room: has no row of 0321_1215, which day.wea has");
}
