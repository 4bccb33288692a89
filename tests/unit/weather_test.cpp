// SPDX-License-Identifier: BSD-3-Clause
// Weather files with their faults, the sun and sky of an hour against RADIANCE's, and which hours are meant.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "base/angle.h"
#include "base/error.h"
#include "scene_text.h"
#include "temp_folder.h"
#include "weather/choose.h"
#include "weather/sky.h"
#include "weather_year.h"

namespace {

using namespace weather;

std::string reading(const std::string& text) {
    Folder::write("w", text);
    return error_text([] { read_weather("w"); });
}

const std::string wea_head =
    "place Here\nlatitude 39.74\nlongitude 105.18\ntime_zone 105\nsite_elevation 1829\nweather_data_file_units 1\n";

// Hours of the text in this weather, and of how many days.
size_t count(const Weather& w, const std::string& words) { return choose_hours(w, words).hours.size(); }

}  // namespace

// Golden (west), Delhi (half an hour off) and Sydney (south): gendaylit -y's sun and sky to its printed digits, the sky
// up to its level.  Where the sun rises or sets within the hour RADIANCE takes the time of that from its declination
// without a year, and the sun is up to .4 degrees away.
TEST_CASE("200 hours have RADIANCE's sky and sun") {
    std::ifstream in(LUXPIPE_TESTS "/golden/weather/skies.tsv");
    int rows = 0, low = 0, equal = 0;
    for (std::string line; std::getline(in, line);) {
        if (line[0] == '#') continue;
        CAPTURE(line);
        std::istringstream row(line);
        Weather w;
        Hour h;
        row >> w.latitude_deg >> w.longitude_deg >> w.meridian_deg >> h.year >> h.time.date.month >> h.time.date.day >>
            h.time.hour >> h.direct_wm2 >> h.diffuse_wm2 >> h.dew_point_c;
        const auto light = light_of(w, h);
        REQUIRE(light);
        double solar = 0, level = 0, ground = 0, theirs[8] = {};
        row >> solar >> level >> ground;
        for (double& x : theirs) REQUIRE(bool(row >> x));
        double apart = 0;
        for (int i = 0; i < 3; ++i) apart = std::fmax(apart, std::fabs(light->to_sun[i] - theirs[5 + i]));
        ++rows;
        low += theirs[7] < std::sin(6 * base::degree);
        REQUIRE(apart < 7e-3);
        if (apart > 2e-6) continue;
        ++equal;
        REQUIRE(std::fabs(light->sun_radiance - solar) <= 1e-3 * solar);
        const double factor = light->level / level;
        REQUIRE((factor > .97 && factor < 1.06));
        REQUIRE(std::fabs(light->ground / ground - 1) < std::fabs(factor - 1) + 1e-3);
        for (int i = 0; i < 5; ++i)
            REQUIRE(std::fabs(light->perez[i] - theirs[i]) <= 1e-3 * std::fabs(theirs[i]) + 2e-6);
    }
    CHECK(rows == 200);
    CHECK(low > 10);
    CHECK(equal > 150);
}

TEST_CASE("EPW: header, hours by their middle, dew point, minutes that mean nothing") {
    const Folder folder;
    for (const std::string& text : {year_epw(), "\xef\xbb\xbf" + with_crlf(year_epw())}) {
        Folder::write("w.epw", text);
        const Weather w = read_weather("w.epw");
        CHECK(w.place == "Madeup");
        CHECK(w.latitude_deg == 39.74);
        CHECK(w.longitude_deg == 105.18);
        CHECK(w.meridian_deg == 105);
        CHECK(w.first_weekday == 6);
        REQUIRE(w.hours.size() == 8760);
        CHECK(name_of(w.hours[0].time) == "0101_0030");
        CHECK(name_of(w.hours[8759].time) == "1231_2330");
        CHECK(w.hours[12].dew_point_c == 2);
        CHECK(w.hours[12].line == 21);
    }
}

TEST_CASE("lines count by their date, in any order, with or without 29 February") {
    const Folder folder;
    Folder::write("w.wea", wea_head + "3 1 12.5 3 1\n2 29 12.5 2 1\n2 28 12.5 1 1\n\n");
    const Weather w = read_weather("w.wea");
    REQUIRE(w.hours.size() == 3);
    for (int i = 0; i < 3; ++i) CHECK(w.hours[size_t(i)].direct_wm2 == i + 1);
    CHECK(name_of(w.hours[1].time) == "0229_1230");
    CHECK(sun_of(w, w.hours[1]).altitude_deg == sun_of(w, w.hours[2]).altitude_deg);
    CHECK(w.step_min == 60);
    Folder::write("q.wea", wea_head + "3 1 12.125 3 1\n3 1 12.375 2 1\n3 1 12.625 1 1\n");
    CHECK(read_weather("q.wea").step_min == 15);
}

TEST_CASE("a fault is one line with file and line") {
    const Folder folder;
    CHECK(reading("") == "w: is empty");
    CHECK(reading("nothing\n") == "w: is neither EPW (LOCATION, ...) nor WEA (place ...)");
    CHECK(reading(wea_head) == "w: has no hours");
    CHECK(reading(wea_head + "1 1 1 0 0\n1 1 24 0 0\n") ==
          "w:8: the hour of a WEA line is the middle of its hour, 23.5 at most");
    CHECK(reading(wea_head + "2 30 1.5 0 0\n") == "w:7: this month has fewer days");
    CHECK(reading(wea_head + "13 1 1.5 0 0\n") == "w:7: the month 13 is not between 1 and 12");
    CHECK(reading(wea_head + "1 1 1.5 0 0\n1 1 1.5 0 0\n") == "w:8: the hour 0101_0130 was in line 7 already");
    CHECK(reading(wea_head + "1 1 1.5 x 0\n") == "w:7: the direct normal irradiance: \"x\" is not a number");
    CHECK(reading(wea_head + "1 1 1.5 0\n") == "w:7: the diffuse horizontal irradiance is missing");
    CHECK(reading("place p\nlongitude 5\n") == "w:2: \"longitude 5\" stands where latitude should");
    CHECK(reading("place p\nlatitude 95\n") == "w:2: latitude 95 is not between -90 and 90");
    std::string east = wea_head, lux = wea_head;
    CHECK(reading(east.replace(east.find("longitude 105"), 13, "longitude -105") + "1 1 1.5 0 0\n") ==
          "w: the longitude -105.18 west and the time zone of 105 west do not go together; is the sign of one of them "
          "wrong (-105.18 and -105)?");
    CHECK(reading(lux.replace(lux.find("units 1"), 7, "units 2") + "1 1 1.5 0 0\n") ==
          "w:6: only unit 1 is read: direct normal and diffuse horizontal irradiance in W/m2");
    CHECK(reading("LOCATION,a,b,c\n") == "w:1: the latitude is missing");
    CHECK(reading(year_epw().substr(0, 5000) + "\n2001,1,3,25,60,?,1,1\n")
              .find(": the hour 25 is not between 1 and 24") != std::string::npos);
}

TEST_CASE("a missing value matters while the sun is up") {
    const Folder folder;
    Folder::write("w.wea", wea_head + "6 21 1.5 9999 9999\n6 21 12.5 9999 100\n6 21 13.5 500 -1\n6 21 14.5 0 0\n");
    const Weather w = read_weather("w.wea");
    CHECK(!light_of(w, w.hours[0]));
    CHECK(error_text([&] { light_of(w, w.hours[1]); }) ==
          "w.wea:8: the direct normal irradiance of 0621_1230 is 9999 W/m2: missing, or wrong");
    CHECK(error_text([&] { light_of(w, w.hours[2]); }) ==
          "w.wea:9: the diffuse horizontal irradiance of 0621_1330 is -1 W/m2: missing, or wrong");
    CHECK(!light_of(w, w.hours[3]));
}

TEST_CASE("polar night and polar day") {
    Weather w;
    w.latitude_deg = 78;
    Hour h;
    h.direct_wm2 = 100;
    h.diffuse_wm2 = 50;
    h.time = {{12, 21}, 12.5};
    CHECK(!light_of(w, h));
    h.time = {{6, 21}, .5};
    CHECK(light_of(w, h));
    CHECK(sun_of(w, h).altitude_deg > 10);
}

TEST_CASE("hours by days, months, the clock, names and files") {
    const Folder folder;
    Folder::write("w.epw", year_epw());
    const Weather w = read_weather("w.epw");  // 1 January is a Sunday
    CHECK(count(w, "all") == 8760);
    CHECK(count(w, "Mo-Fr 8-18") == 260 * 10);
    CHECK(count(w, "mo-fri, 8-12, 13-17") == 260 * 8);
    CHECK(count(w, "2024 Mo-Fr 8-18") == 262 * 10 - 10);  // 29 February is a Thursday, and not in the file
    CHECK(count(w, "Sa-Mo") == (52 * 3 + 1) * 24);
    CHECK(count(w, "Nov-Feb 12-13") == 30 + 31 + 31 + 28);
    CHECK(count(w, "Jun 22-6") == 30 * 8);
    CHECK(count(w, "8:30-9:30 Jul") == 31);
    CHECK(count(w, "0621") == 24);
    CHECK(count(w, "1221-0105 12-13") == 16);
    CHECK(count(w, "21Mar-20Jun 12-13") == 92);
    CHECK(w.hours[choose_hours(w, "0621_1430").hours.at(0)].time.hour == 14.5);
    size_t shares = 0;
    for (int k = 1; k <= 7; ++k) shares += count(w, "Mo-Fr 8-18 " + std::to_string(k) + "/7");
    CHECK(shares == 2600);

    Folder::write("names", "sky\tframes\n0621_1430\t40\n0102_0030\t9\n");
    CHECK(count(w, "@names") == 2);
    CHECK(count(w, "@names Jun") == 1);
    std::string values, daysim = "# Daysim\n";
    for (int i = 0; i < 8760; ++i) values += i % 24 == 9 ? ".5\n" : "0\n";
    for (int hour = 0; hour < 24; ++hour) daysim += "3,1," + std::to_string(hour) + ".5," + (hour < 5 ? "1\n" : "0\n");
    Folder::write("values", values);
    Folder::write("daysim", daysim);
    CHECK(count(w, "@values") == 365);
    CHECK(w.hours[choose_hours(w, "@values Dec").hours.back()].time.hour == 9.5);
    CHECK(count(w, "@daysim") == 5);
    CHECK(name_of(w.hours[choose_hours(w, "@daysim").hours[0]].time) == "0301_0030");
}

TEST_CASE("lists of hours of the year, as Honeybee's sun-up-hours.txt") {
    const Folder folder;
    Folder::write("w.epw", year_epw());
    const Weather w = read_weather("w.epw");
    const auto first = [&](const std::string& words) { return name_of(w.hours[choose_hours(w, words).hours[0]].time); };
    Folder::write("sun-up-hours.txt", "8.5\n9.5\n2000\n8759.5\n");
    CHECK(count(w, "@sun-up-hours.txt") == 4);
    CHECK(first("@sun-up-hours.txt") == "0101_0830");
    CHECK(first("@sun-up-hours.txt Mar") == "0325_0830");
    CHECK(first("@sun-up-hours.txt Dec") == "1231_2330");
    std::string all;
    for (int i = 0; i < 8760; ++i) all += std::to_string(i) + "\n";
    Folder::write("all", all);
    CHECK(count(w, "@all") == 8760);
    Folder::write("beyond", "8.5\n8760\n");
    CHECK(error_text([&] { choose_hours(w, "@beyond"); }) == "beyond: the hour of the year 8760 is not in w.epw");
    Folder::write("leap.wea", wea_head + "2 28 12.5 1 1\n2 29 12.5 2 1\n3 1 12.5 3 1\n");
    Folder::write("three", "1404.5\n1428.5\n1452.5\n");  // of a leap year
    CHECK(count(read_weather("leap.wea"), "@three") == 3);
    Folder::write("q.wea", wea_head + "3 1 12.125 3 1\n3 1 12.375 2 1\n3 1 12.625 1 1\n");
    Folder::write("two", "1428.25\n1428.6\n");
    CHECK(count(read_weather("q.wea"), "@two") == 2);
}

TEST_CASE("which fraction of a schedule counts") {
    const Folder folder;
    Folder::write("w.epw", year_epw());
    const Weather w = read_weather("w.epw");
    std::string values;
    for (int i = 0; i < 8760; ++i)
        values += i % 24 == 9 ? "1\n" : i % 24 == 10 ? ".1\n" : i % 24 == 11 ? "0.05\n" : "0\n";
    Folder::write("values", values);
    CHECK(count(w, "@values") == 2 * 365);
    CHECK(choose_hours(w, "@values", .5).hours.size() == 365);
    CHECK(choose_hours(w, "@values", .05).hours.size() == 3 * 365);
    Folder::write("daysim", "3,1,9.5,.05\n3,1,10.5,1\n3,1,11.5,0\n");
    CHECK(count(w, "@daysim") == 2);
    CHECK(choose_hours(w, "@daysim", .1).hours.size() == 1);
}

TEST_CASE("paths of @file with blanks and commas") {
    const Folder folder;
    Folder::write("w.epw", year_epw());
    const Weather w = read_weather("w.epw");
    for (const char* name : {"plain", "a,b.csv", "a b.csv", "in use, 1.csv"}) {
        Folder::write(name, "0621_1430\n0102_0030\n");
        CHECK(count(w, std::string("Jun @") + name) == 1);
        CHECK(count(w, std::string("@") + name + ",Jan 0-1") == 1);
        CHECK(count(w, std::string("@") + name + " @plain") == 2);
    }
    CHECK(error_text([&] { choose_hours(w, "@no,b.csv"); }).find("no: cannot be read") == 0);
}

TEST_CASE("daylight saving shifts the clock, and the note says so") {
    const Folder folder;
    Folder::write("w.epw", year_epw());
    const Weather w = read_weather("w.epw");
    const Choice winter = choose_hours(w, "8-18"), summer = choose_hours(w, "8-18 dst=29Mar-25Oct");
    CHECK(winter.note == "1 January is a Sunday, standard time is UTC-7");
    CHECK(summer.note ==
          "1 January is a Sunday, standard time is UTC-7, the clock is an hour ahead from 29 Mar to 25 Oct");
    const auto first_of = [&](const Choice& c, const char* day) {
        for (size_t i : c.hours)
            if (name_of(w.hours[i].time).substr(0, 4) == day) return w.hours[i].time.hour;
        return -1.;
    };
    CHECK(first_of(summer, "0328") == 8.5);
    CHECK(first_of(summer, "0329") == 7.5);
    CHECK(first_of(summer, "1024") == 7.5);
    CHECK(first_of(summer, "1025") == 8.5);
    // As the file states it, by dates and by weekdays: 2nd Sunday in March of a year that begins with a Sunday is the
    // 12th.
    for (const char* dates : {"3/12,11/5", " 3/12, 11/5 ", "12-Mar,5-Nov", "Mar 12,November 5", "12 Mar,5 Nov",
                              "2nd Sunday in March,1st Sunday in November", "2nd sunday In mar,First Sunday of Nov",
                              "\"Second Sunday in March\",\"1st Sunday in November\""}) {
        CAPTURE(dates);
        std::string text = year_epw();
        Folder::write("dst.epw", text.replace(text.find("No,0,0,0"), 8, std::string("No,") + dates + ",0"));
        CHECK(choose_hours(read_weather("dst.epw"), "8-18 dst").note ==
              "1 January is a Sunday, standard time is UTC-7, the clock is an hour ahead from 12 Mar to 5 Nov");
    }
    std::string text = year_epw();
    Folder::write("dst.epw",
                  text.replace(text.find("No,0,0,0"), 8, "No,Last Sunday in March,last Sunday in October,0"));
    CHECK(choose_hours(read_weather("dst.epw"), "dst 2024").note ==
          "1 January is a Monday, standard time is UTC-7, the clock is an hour ahead from 31 Mar to 27 Oct");
    text = year_epw();
    Folder::write("dst.epw", text.replace(text.find("No,0,0,0"), 8, "No,in spring,in autumn,0"));
    CHECK(error_text([&] { choose_hours(read_weather("dst.epw"), "dst"); }) ==
          "-hours: dst.epw: daylight saving: \"in spring\" is no date; say its dates: dst=29Mar-25Oct");
    CHECK(count(w, "Su dst=1Jan-31Dec") == count(w, "Su"));                // 31 December, a Sunday, has its last hour
    CHECK(first_of(choose_hours(w, "Mo dst=0102-0110"), "0108") == 23.5);  // a Sunday by standard time
    CHECK(count(w, "8-18 dst=25Oct-29Mar") == 3650);                       // south
}

TEST_CASE("names are to the nearest minute, and either neighbour of a half is taken") {
    const Folder folder;
    // Of each length of step: middles in 12 digits, and in three decimals as Ladybug has them.
    for (const int step : {1, 2, 3, 4, 5, 6, 10, 12, 15, 20, 30, 60})
        for (const int digits : {12, 3}) {
            CAPTURE(step);
            CAPTURE(digits);
            std::string text = wea_head;
            for (int i = 0; i < 1440 / step; ++i)
                text += fmt::format("6 21 {:.{}f} 1 1\n", (i + .5) * step / 60, digits);
            Folder::write("steps.wea", text);
            const Weather w = read_weather("steps.wea");
            REQUIRE(w.hours.size() == size_t(1440 / step));
            for (int i = 0; i < 1440 / step; ++i) {
                const int minute = i * step + step / 2;
                const auto name = [](int m) { return fmt::format("0621_{:02}{:02}", m / 60, m % 60); };
                REQUIRE(name_of(w.hours[size_t(i)].time) == name(minute));
                REQUIRE(choose_hours(w, name(minute)).hours == std::vector<size_t>{size_t(i)});
                if (step > 2 && minute + 1 < 1440)
                    REQUIRE(choose_hours(w, name(minute + 1)).hours == std::vector<size_t>{size_t(i)});
            }
        }
    Folder::write("w.wea", wea_head + "6 21 12.333 800 100\n6 21 12.667 800 100\n");
    const Weather w = read_weather("w.wea");
    CHECK(name_of(w.hours[0].time) == "0621_1220");
    CHECK(name_of({{6, 21}, 23.9999}) == "0621_2359");
    CHECK(count(w, "0621_1220 0621_1240") == 2);
    Folder::write("names", "0621_1219 a name that was cut\n");
    CHECK(count(w, "@names") == 1);
    CHECK(error_text([&] { choose_hours(w, "0621_1222"); }) == "-hours: 0621_1222 is not an hour of w.wea");
}

TEST_CASE("hours that mean nothing") {
    const Folder folder;
    Folder::write("w.epw", year_epw());
    const Weather w = read_weather("w.epw");
    const auto said = [&](const char* words) { return error_text([&] { choose_hours(w, words); }); };
    CHECK(said("Mo-Xy") ==
          "-hours: \"Mo-Xy\" is no day (Mo-Fr), month (Jun), time (8-18), date (21Jun), share (3/16) or @file");
    CHECK(said("18-18") ==
          "-hours: \"18-18\" is no day (Mo-Fr), month (Jun), time (8-18), date (21Jun), share (3/16) or @file");
    CHECK(said("0229") == "-hours: \"0229\" means no hour of w.epw");
    CHECK(said("0321 12") == "-hours: \"12\" is a moment; hours are a span, as 12-13");
    CHECK(said("8:30") == "-hours: \"8:30\" is a moment; hours are a span, as 8:30-9:30");
    CHECK(said("0621_1400") == "-hours: 0621_1400 is not an hour of w.epw");
    CHECK(said("17/16") == "-hours: \"17/16\" is not a share such as 3/16");
    CHECK(said("dst") == "-hours: w.epw states no daylight saving; say its dates: dst=29Mar-25Oct");
    Folder::write("short", "1\n0\n");
    CHECK(said("@short") == "short: has 2 values, not 8760 or 8784, and no rising hours of the year");
    Folder::write("mixed", "1\n0621_1430\n");
    CHECK(said("@mixed") == "mixed: needs lines of one kind: names of hours, numbers, or month,day,hour,value");
    Folder::write("unknown", "0621_1430\n0229_1430\n");
    CHECK(said("@unknown") == "unknown:2: 0229_1430 is not an hour of w.epw");
}
