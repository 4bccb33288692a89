// SPDX-License-Identifier: BSD-3-Clause
// The light of hours by random lines of weather: illuminances, RADIANCE's gendaylit -y, the sun of a year, and the sky
// in directions.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "base/angle.h"
#include "base/vec.h"
#include "base/warnings.h"
#include "generators/perez.h"
#include "generators/sun.h"
#include "scene_text.h"
#include "weather/sky.h"

namespace {

using namespace weather;
using base::degree;
using base::pi;
using base::Vec3;

// Sun and sky of a scene text.
struct SceneSky {
    double solar = 0, level = 0, horizon = 0, ground = 0, c[5] = {};
    Vec3 to_sun, disc;
    double disc_deg = 0;

    explicit SceneSky(const std::string& text) {
        const scene::Scene s = scene::read_scene({text}, {});
        for (const scene::Object& o : s.objects) {
            const auto v = s.reals(o);
            if (s.name(o) == "solar") solar = v[0];
            if (s.name(o) == "sun") disc = {v[0], v[1], v[2]}, disc_deg = v[3];
            if (s.name(o) == "groundfunc") ground = v[1];
            if (s.name(o) != "skyfunc") continue;
            level = v[0], horizon = ground = v[1], to_sun = {v[7], v[8], v[9]};
            for (int i = 0; i < 5; ++i) c[i] = v[size_t(i + 2)];
        }
        base::take_warnings();
    }
    // perezlum.cal, written out once more.
    double radiance(Vec3 d) const {
        const double cosine = dot(d, to_sun), gamma = std::acos(std::fmin(1, std::fmax(-1, cosine)));
        const double sky = level * (1 + c[0] * std::exp(c[1] / (d.z > .01 ? d.z : .01))) *
                           (1 + c[2] * std::exp(c[3] * gamma) + c[4] * cosine * cosine);
        const double weight = std::pow(d.z + 1.01, 20);
        return (weight * sky + (d.z < 0 ? ground : horizon)) / (weight + 1);
    }
    bool is_positive() const {
        for (int i = 0; i <= 40; ++i)
            for (int k = 0; k < 80; ++k)
                if (radiance(direction(i / 40., k / 40. * pi)) < 0) return false;
        return true;
    }
    static Vec3 direction(double z, double azimuth) {
        const double across = std::sqrt(1 - z * z);
        return {across * std::cos(azimuth), across * std::sin(azimuth), z};
    }
    // On the ground: even steps in t of heights 3t^2 - 2t^3, dense at the horizon and, as angles are, at the zenith.
    double horizontal() const {
        constexpr int steps = 240, around = 64;
        const double of_sun = std::atan2(to_sun.y, to_sun.x);  // both sides of it are alike
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            const double t = (i + .5) / steps, z = t * t * (3 - 2 * t), dz = 6 * t * (1 - t) / steps;
            for (int k = 0; k < around; ++k)
                sum += radiance(direction(z, of_sun + pi * (k + .5) / around)) * z * dz * 2 * pi / around;
        }
        return sum;
    }
    double horizontal_of_sun() const {
        const double r = std::sin(disc_deg / 2 * degree);
        return solar * pi * r * r * std::fmax(0, disc.z);
    }
};

// A line of weather anywhere, whose sun is up: any height of it, both irradiances 0 to what comes from outside.
struct Line {
    Weather w;
    Hour h;
    Sun sun;

    explicit Line(std::mt19937& random) {
        const auto below = [&](double x) { return std::uniform_real_distribution<double>(0, x)(random); };
        const auto from = [&](double a, double b) { return a + below(b - a); };
        const double wanted = below(90);
        do {
            w.latitude_deg = from(-90, 90);
            w.longitude_deg = from(-180, 180);
            w.meridian_deg = std::round(w.longitude_deg / 15) * 15;
            h.year = int(from(1950, 2051));
            h.time = {date_of(random() % 20 ? int(from(1, 367)) : leap_day), std::floor(below(24)) + .5};
            sun = sun_of(w, h);
        } while (std::fabs(sun.altitude_deg - wanted) > 1 || sun.altitude_deg <= 0);
        const double sine = std::sin(sun.altitude_deg * degree), outside = 1320;
        h.direct_wm2 = random() % 5 ? below(outside) : 0;
        h.diffuse_wm2 = random() % 10 ? below(std::fmax(1, (outside - h.direct_wm2) * sine)) : 0;
        if (random() % 3 == 0) h.dew_point_c = from(-30, 30);
        if (h.direct_wm2 + h.diffuse_wm2 == 0) h.diffuse_wm2 = 1;
    }
    std::string gendaylit() const {
        std::string text = fmt::format("!gendaylit {} {} {} -y {} -a {} -o {} -m {} -W {} {} -i 60", h.time.date.month,
                                       h.time.date.day, h.time.hour, h.year, w.latitude_deg, w.longitude_deg,
                                       w.meridian_deg, h.direct_wm2, h.diffuse_wm2);
        if (h.dew_point_c < 70) text += fmt::format(" -d {}", h.dew_point_c);
        return text + "\n";
    }
};

void check_near(double is, double expected, double relative, double absolute = 0) {
    CAPTURE(is);
    CAPTURE(expected);
    REQUIRE(std::fabs(is - expected) <= relative * std::fabs(expected) + absolute);
}

// To the sun by Meeus' series of another length (Astronomical Algorithms, chapters 7, 12 and 25), at a moment of UTC.
Vec3 meeus(const Weather& w, int year, Date date, double utc_h) {
    const int before = (14 - date.month) / 12, y = year + 4800 - before, m = date.month + 12 * before - 3;
    const int day = date.day + (153 * m + 2) / 5 + 365 * y + y / 4 - y / 100 + y / 400 - 32045;
    const double days = day - .5 + utc_h / 24 - 2451545, t = days / 36525;
    const double anomaly = (357.52911 + 35999.05029 * t) * degree, node = (125.04 - 1934.136 * t) * degree;
    const double centre = (1.914602 - .004817 * t) * std::sin(anomaly) + .019993 * std::sin(2 * anomaly) +
                          .000289 * std::sin(3 * anomaly);
    const double at = (280.46646 + 36000.76983 * t + centre - .00569 - .00478 * std::sin(node)) * degree;
    const double tilt = (23.4392911 - .0130042 * t + .00256 * std::cos(node)) * degree;
    const double ascension = std::atan2(std::cos(tilt) * std::sin(at), std::cos(at));
    const double sine = std::sin(tilt) * std::sin(at), cosine = std::sqrt(1 - sine * sine);
    const double angle = (280.46061837 + 360.98564736629 * days - w.longitude_deg) * degree - ascension;
    const double north = w.latitude_deg * degree;
    return {-cosine * std::sin(angle), std::cos(north) * sine - std::sin(north) * cosine * std::cos(angle),
            std::sin(north) * sine + std::cos(north) * cosine * std::cos(angle)};
}

}  // namespace

TEST_CASE("the sun of any year from 1901 to 2099 stands within .02 degrees of Meeus'") {
    std::mt19937 random(12);
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        Line line(random);
        line.h.year = 1901 + int(random() % 199);
        if (line.h.time.date.in_leap_year() == leap_day) continue;
        line.w.step_min = 0;  // where it stands at this moment
        const Sun sun = sun_of(line.w, line.h);
        const double up = sun.altitude_deg * degree, east = sun.azimuth_deg * degree;
        const Vec3 ours{std::cos(up) * std::sin(east), std::cos(up) * std::cos(east), std::sin(up)};
        const Vec3 theirs = meeus(line.w, line.h.year, line.h.time.date, line.h.time.hour + line.w.meridian_deg / 15);
        worst = std::fmax(worst, length(ours - theirs) / degree);
    }
    CHECK(worst < .02);
    MESSAGE(worst, " degrees at most");
}

TEST_CASE("2,000 lines have Perez' illuminances, light in each, and gendaylit -y's sun and sky up to a factor") {
    std::mt19937 random(59);
    int alike = 0, black = 0, negative = 0, leap = 0;
    for (int i = 0; i < 2000; ++i) {
        const Line line(random);
        const std::string command = line.gendaylit();
        CAPTURE(command);
        const auto light = light_of(line.w, line.h);
        REQUIRE(light);
        const SceneSky ours(sky_text(line.w, line.h, *light)), theirs(command);
        const double sine = std::sin(line.sun.altitude_deg * degree);
        const generators::PerezSky perez(line.h.time.date.of_year(), std::acos(sine),
                                         line.h.dew_point_c < 70 ? line.h.dew_point_c : 10.97353115);
        const auto k = generators::clamp(perez.clearness(line.h.direct_wm2, line.h.diffuse_wm2));
        const double sun_lux = line.h.direct_wm2 * perez.direct_efficacy(k) * sine,
                     sky_lux = line.h.diffuse_wm2 * perez.diffuse_efficacy(k);
        const double sun = 179 * ours.horizontal_of_sun(), sky = 179 * ours.horizontal();
        check_near(sun, sun_lux, 1e-4);
        check_near(sky, sky_lux, 1e-4);
        REQUIRE(sun + sky > 0);
        REQUIRE(ours.is_positive());

        leap += line.h.time.date.in_leap_year() == leap_day;
        black += theirs.solar + theirs.level == 0;
        negative += !theirs.is_positive();
        if (line.sun.altitude_deg > 87 || theirs.solar + theirs.level == 0 || !theirs.is_positive()) continue;
        REQUIRE(!light->even_gradation);
        REQUIRE(!light->even_indicatrix);
        ++alike;
        check_near(ours.solar, theirs.solar, 6e-4);
        for (int j = 0; j < 3; ++j) check_near(ours.to_sun[j], theirs.to_sun[j], 0, 1e-6);
        for (int j = 0; j < 3; ++j) check_near(ours.disc[j], theirs.disc[j], 0, 1e-6);
        for (int j = 0; j < 5; ++j) check_near(ours.c[j], theirs.c[j], 1e-6, 1e-6);
        const double of_sun = .2 * 6.8e-5 / pi * ours.solar * sine;
        if (theirs.level == 0) check_near(ours.ground, theirs.ground, 1e-3);
        else check_near(ours.ground, (theirs.ground - of_sun) * ours.level / theirs.level + of_sun, 1e-3);
    }
    CHECK(alike > 1700);
    CHECK(black > 20);
    CHECK(negative < 40);
    CHECK(leap > 50);
    MESSAGE(alike, " alike, ", black, " black and ", negative, " negative in gendaylit, ", leap, " on 29 February");
}

TEST_CASE("the sky in a direction is that of the scene text") {
    std::mt19937 random(1);
    for (int i = 0; i < 50; ++i) {
        const Line line(random);
        const auto light = light_of(line.w, line.h);
        const SceneSky text(sky_text(line.w, line.h, *light));
        for (int k = 0; k < 100; ++k) {
            const double z = std::uniform_real_distribution<double>(-1, 1)(random);
            const Vec3 d = SceneSky::direction(z, double(random() % 1000));
            check_near(sky_radiance(*light, {float(d.x), float(d.y), float(d.z)}), text.radiance(d), 1e-5);
        }
    }
}

TEST_CASE("an hour that gendaylit leaves black") {
    Weather w;
    w.latitude_deg = 45, w.longitude_deg = -8, w.meridian_deg = -15;
    Hour h;
    h.time = {{1, 2}, 8.5};
    h.direct_wm2 = 441.62, h.diffuse_wm2 = 45;
    const auto light = light_of(w, h);
    REQUIRE(light);
    CHECK(light->even_gradation);
    CHECK(light->sun_radiance > 1e6);  // 441.62 W/m2 of 35 lm/W, on 6.8e-5 sr
    CHECK(light->sky_irradiance > 20);
}
