// SPDX-License-Identifier: BSD-3-Clause
// The clock of a weather file: told where its sun is off beyond doubt, silent elsewhere, in years made for the purpose.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "made_weather.h"
#include "scene_text.h"
#include "temp_folder.h"
#include "weather/clock.h"
#include "weather/sky.h"

namespace {

using namespace weather;

struct Place {
    const char* name;
    double latitude, longitude, zone;
};
const Place places[] = {{"north east", 48.1, 11.6, 1},
                        {"north west", 39.74, -105.18, -7},
                        {"south east", -33.9, 151.2, 10},
                        {"south west", -22.9, -43.2, -3}};

MadeWeather at(const Place& p) {
    MadeWeather m;
    m.latitude = p.latitude, m.longitude = p.longitude, m.zone = p.zone;
    return m;
}

Weather read(const MadeWeather& made) {
    Folder::write("w.epw", made.epw());
    return read_weather("w.epw");
}

}  // namespace

TEST_CASE("a sun shifted by quarters of an hour is told, and by how much; one that is not is silent") {
    const Folder folder;
    for (const Place& p : places)
        for (int quarters = -3; quarters <= 3; ++quarters) {
            CAPTURE(std::string(p.name));
            CAPTURE(quarters);
            MadeWeather made = at(p);
            made.shift_h = quarters / 4.;
            Weather w = read(made);
            const auto error = clock_error(w);
            REQUIRE(bool(error) == (quarters != 0));
            if (!error) continue;
            CHECK(std::fabs(error->shift_h - made.shift_h) < .06);
            CHECK(error->as_placed > 2 * error->shifted);
            w.shift_h = made.shift_h;
            CHECK(!clock_error(w));
            CHECK(std::fabs(sun_of(w, w.hours[4070]).altitude_deg -
                            std::asin(MadeWeather::sine_of(p.latitude, p.longitude,
                                                           w.hours[4070].time.hour - p.zone + made.shift_h, 170)) *
                                180 / 3.14159265358979) < 1.5);
        }
}

TEST_CASE("noise of 5 %: three quarters of an hour are told, none is silent") {
    const Folder folder;
    for (const Place& p : places)
        for (unsigned seed = 1; seed <= 10; ++seed)
            for (const double shift : {-.75, 0., .75}) {
                CAPTURE(std::string(p.name));
                CAPTURE(seed);
                CAPTURE(shift);
                MadeWeather made = at(p);
                made.seed = seed, made.noise = .05, made.shift_h = shift;
                const auto error = clock_error(read(made));
                REQUIRE(bool(error) == (shift != 0));
                if (error) CHECK(std::fabs(error->shift_h - shift) < .1);
            }
}

TEST_CASE("instruments that read too much or too little do not look like a clock") {
    const Folder folder;
    for (const Place& p : places)
        for (const double shift : {0., .5}) {
            CAPTURE(std::string(p.name));
            MadeWeather made = at(p);
            made.global_gain = 1.05, made.direct_gain = .95, made.overcast_afternoon = .4, made.noise = .02;
            made.shift_h = shift;
            const auto error = clock_error(read(made));
            REQUIRE(bool(error) == (shift != 0));
        }
}

TEST_CASE("years that cannot tell are silent") {
    const Folder folder;
    MadeWeather made;
    made.shift_h = .75;
    made.days = 10;
    CHECK(!clock_error(read(made)));
    made.days = 365, made.overcast = 1;
    CHECK(!clock_error(read(made)));
    made.overcast = .4, made.latitude = -90, made.longitude = 0, made.zone = 12;  // a pole
    CHECK(!clock_error(read(made)));
    made = MadeWeather();
    made.shift_h = .75;
    made.line_of = [](std::vector<std::string> fields) {
        fields[13] = "9999";
        return MadeWeather::joined(fields);
    };
    CHECK(!clock_error(read(made)));
}

TEST_CASE("the equator, the tropics and the far north") {
    const Folder folder;
    for (const Place& p : {Place{"Singapore", 1.3, 103.8, 8}, Place{"Quito", -.2, -78.5, -5},
                           Place{"Tromso", 69.6, 18.9, 1}, Place{"Ushuaia", -54.8, -68.3, -3}})
        for (const double shift : {-.5, 0., .5}) {
            CAPTURE(std::string(p.name));
            CAPTURE(shift);
            MadeWeather made = at(p);
            made.shift_h = shift;
            const auto error = clock_error(read(made));
            REQUIRE(bool(error) == (shift != 0));
            if (error) CHECK(std::fabs(error->shift_h - shift) < .06);
        }
}
