// SPDX-License-Identifier: BSD-3-Clause
// EPW files as people's programs spell them: a random spelling of a file is read as the plain one.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include "made_weather.h"
#include "scene_text.h"
#include "temp_folder.h"
#include "weather/choose.h"
#include "weather/sky.h"

namespace {

using namespace weather;

using Random = std::mt19937;

bool chance(Random& random) { return random() % 2 == 0; }

Weather read(const std::string& text) {
    Folder::write("w.epw", text);
    return read_weather("w.epw");
}

// A name with commas and quotes, quoted or as it is.
std::string spelled(Random& random, const std::string& name, bool may_hold_commas) {
    const char* const more[] = {"", " Intl.", " AP", ", Rep.", ", city of", " \"old\""};
    const size_t k = random() % 6;
    if (k < 3) return name + more[k];
    if (k < 5 && may_hold_commas && chance(random)) return name + more[k];
    std::string quoted;
    for (const char c : name + more[k]) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return '"' + quoted + '"';
}

std::string number_spelled(Random& random, const std::string& number) {
    switch (random() % 4) {
    case 0: return " " + number;
    case 1: return number + " ";
    case 2: return '"' + number + '"';
    default: return number;
    }
}

// No light.
bool is_night(const std::vector<std::string>& fields) {
    return fields[13] == "0" && fields[14] == "0" && fields[15] == "0";
}

}  // namespace

TEST_CASE("300 random spellings of a file are that file") {
    const Folder folder;
    Random random(1);
    for (int k = 0; k < 300; ++k) {
        MadeWeather made;
        made.days = 3, made.seed = unsigned(k);
        made.latitude = int(random() % 120) - 60, made.longitude = int(random() % 340) - 170;
        made.zone = std::round(made.longitude / 15);
        const Weather plain = read(made.epw());
        made.location = "LOCATION," + spelled(random, "Madeup", true) + "," + spelled(random, "State", true) + "," +
                        spelled(random, "Country", true) + ",TMYx," + std::to_string(random() % 100);
        for (const double x : {made.latitude, made.longitude, made.zone, 10.})
            made.location += "," + number_spelled(random, fmt::format("{}", x));
        if (chance(random)) made.location += chance(random) ? "," : ",,";
        if (chance(random)) made.location = "\"LOCATION\"" + made.location.substr(8);
        made.line_of = [&](std::vector<std::string> fields) {
            if (is_night(fields) && chance(random)) fields[14] = "";
            if (is_night(fields) && chance(random)) fields[15] = "9999";
            if (chance(random)) fields[6] = "";
            for (std::string& f : fields)
                if (!f.empty() && random() % 8 == 0) f = number_spelled(random, f);
            if (random() % 8 == 0) fields.resize(16);
            return MadeWeather::joined(fields);
        };
        CAPTURE(made.location);
        const Weather w = read(made.epw());
        REQUIRE(w.latitude_deg == plain.latitude_deg);
        REQUIRE(w.longitude_deg == plain.longitude_deg);
        REQUIRE(w.meridian_deg == plain.meridian_deg);
        REQUIRE(w.hours.size() == plain.hours.size());
        for (size_t i = 0; i < w.hours.size(); ++i) {
            const auto light = light_of(w, w.hours[i]), expected = light_of(plain, plain.hours[i]);
            REQUIRE(light.has_value() == expected.has_value());
            if (light) REQUIRE(sky_text(w, w.hours[i], *light) == sky_text(plain, plain.hours[i], *expected));
        }
    }
}

TEST_CASE("minutes of parts of an hour are ends or beginnings") {
    const Folder folder;
    for (const int parts : {2, 4, 6, 12}) {
        const int step = 60 / parts;
        std::vector<std::string> names[2];
        for (const bool ends : {true, false}) {
            MadeWeather made;
            made.days = 2;
            made.line_of = [&](std::vector<std::string> fields) {
                std::string lines;
                for (int k = 0; k < parts; ++k) {
                    fields[4] = std::to_string((k + ends) * step);
                    lines += MadeWeather::joined(fields);
                }
                return lines;
            };
            std::string text = made.epw();
            text.replace(text.find("PERIODS,1,1"), 11, "PERIODS,1," + std::to_string(parts));
            for (const Hour& h : read(text).hours) names[ends].push_back(name_of(h.time));
        }
        CHECK(names[0].size() == size_t(48 * parts));
        CHECK(names[0] == names[1]);
    }
}

TEST_CASE("sites: poles, solar time, and signs that got lost") {
    const Folder folder;
    const auto said = [](double latitude, double longitude, double zone) {
        MadeWeather made;
        made.days = 1, made.latitude = latitude, made.longitude = longitude, made.zone = zone;
        return error_text([&] { read(made.epw()); });
    };
    CHECK(said(-90, 0, 12) == "");
    CHECK(said(-89.98, 0, 12) == "");
    CHECK(said(48, 8.2, .547) == "");     // solar time
    CHECK(said(28.6, 77.2, 5.5) == "");   // India
    CHECK(said(27.7, 85.4, 5.75) == "");  // Nepal
    CHECK(said(-43.9, -176.5, 12.75) == "");
    CHECK(said(1, 173, 12) == "");
    CHECK(said(52, 21, -1) == "");  // far, but a zone: nothing to tell it by
    CHECK(
        said(48, 8.2, -.547) ==
        "w.epw: the longitude -8.2 west and the time zone of 8.205 west do not go together: one that is no quarter of "
        "an hour is that of solar time, whose meridian is the longitude; is the sign of one of them wrong (-8.2 and "
        "-8.205)?");
    CHECK(said(40, 105.2, -7).find("is the sign of one of them wrong (-105.2 and -105)?") != std::string::npos);
    CHECK(said(40, -60, -7.1).find("whose meridian is the longitude") != std::string::npos);
}

TEST_CASE("hours without values: those of the sun that have no irradiance") {
    const Folder folder;
    for (const char* value : {"", "9999", "-999", "99999"}) {
        CAPTURE(value);
        MadeWeather made;
        made.days = 2;
        made.line_of = [&](std::vector<std::string> fields) {
            if (fields[2] == "2") fields[15] = value;
            return MadeWeather::joined(fields);
        };
        const Weather w = read(made.epw());
        for (const Hour& h : w.hours)
            CHECK(lacks_values(w, h) == (h.time.date.day == 2 && sun_of(w, h).altitude_deg > 0));
        const Choice all = choose_hours(w, "all"), one = choose_hours(w, "0102_1130 0102_1230");
        CHECK(all.named.empty());
        CHECK(one.named.size() == 2);
    }
}
