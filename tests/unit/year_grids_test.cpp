// SPDX-License-Identifier: BSD-3-Clause
// A year of sensors: tables, closed forms, and simulated years whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "temp_folder.h"
#include "year/provision.h"
#include "year/text.h"

namespace {

using namespace year;

const std::string head = "sky\tgrid\tpoint\tE\tlo\thi\n";

std::string row(const char* hour, const char* grid, int point, double e, double half) {
    char text[200];
    std::snprintf(text, sizeof text, "%s\t%s\t%d\t%g\t%g\t%g\n", hour, grid, point, e, e - half, e + half);
    return text;
}

weather::Time hour_number(int i) { return {weather::date_of(1 + i / 24), i % 24 + .5}; }

// n hours, the first sensor from 0 to 1000 lx, the second one always 3 times as bright.
Grid ramp(int n, double relative_error) {
    Grid g{"floor", {}};
    for (int i = 0; i < n; ++i) {
        const float e = 1000 * float(i) / float(n), s = float(relative_error);
        g.hours.push_back({hour_number(i), {{e, s * e}, {3 * e, 3 * s * e}}});
    }
    return g;
}

// Years of sensors whose illuminance falls with their distance from the window by a factor of 30 and spreads over a
// decade and more among the hours.  Each of sixteen parts of the frames has an error of which a share is common to all
// sensors of an hour, and another one to all hours.
class SimulatedYears {
public:
    SimulatedYears(size_t sensors, size_t hours) : sensors_(sensors), hours_(hours) {}
    void draw(double error, double of_hour, double of_year) {
        truth = seen = Grid{"floor", {}};
        seen.shared = of_year > 0, seen.strata = uncertainty::strata;
        std::array<double, parts> all{};
        for (double& a : all) a = normal_(random_);
        for (size_t h = 0; h < hours_; ++h) {
            const double sky = h % 10 == 0 ? 0 : 4000 * std::exp(1.2 * normal_(random_));
            std::array<double, parts> off{};
            for (size_t p = 0; p < parts; ++p)
                off[p] = std::sqrt(of_hour) * normal_(random_) + std::sqrt(of_year) * all[p];
            GridHour exact{hour_number(int(h)), {}}, noisy{hour_number(int(h)), {}};
            noisy.degrees = parts - 1, noisy.strata = uncertainty::strata;
            for (size_t i = 0; i < sensors_; ++i) {
                const double e = sky * std::pow(30, -double(i) / double(sensors_)) * std::exp(.3 * normal_(random_));
                exact.sensors.push_back({float(e), 0});
                add_sensor(e, 4 * error, 1 - of_hour - of_year, off, noisy);
            }
            truth.hours.push_back(exact);
            seen.hours.push_back(noisy);
        }
    }
    Grid truth, seen;

private:
    static constexpr size_t parts = 16;
    void add_sensor(double e, double error, double own, const std::array<double, parts>& off, GridHour& hour) {
        std::array<double, parts> part{};
        double mean = 0, squares = 0;
        for (size_t p = 0; p < parts; ++p) {
            part[p] = e * (1 + error * (off[p] + std::sqrt(own) * normal_(random_)));
            mean += part[p] / parts;
        }
        for (const double x : part) squares += (x - mean) * (x - mean) / (parts - 1) / parts;
        std::vector<double> halves(uncertainty::half_samples, 0.);
        for (size_t k = 0; k < halves.size(); ++k)
            for (size_t p = 0; p < parts; ++p) halves[k] += weights_[k][p] * part[p];
        hour.sensors.push_back({float(mean), float(std::sqrt(squares))});
        hour.halves.push_back(uncertainty::halves_of(halves, uncertainty::strata).codes);
    }

    size_t sensors_, hours_;
    const std::vector<uncertainty::Weights> weights_ = [] {
        std::vector<uncertainty::Weights> all;
        for (int k = 0; k < uncertainty::half_samples; ++k)
            all.push_back(uncertainty::half_sample(uncertainty::Frames(parts, 1), k));
        return all;
    }();
    std::mt19937 random_{1};
    std::normal_distribution<double> normal_;
};

bool holds(const Bounded& interval, double truth) {
    return interval.low <= truth + 1e-9 && truth - 1e-9 <= interval.high;
}

}  // namespace

TEST_CASE("sensors by hours are read from tables, later values replace earlier ones") {
    TempFolder folder;
    const std::string a = folder.holding(
        "a.tsv", head + row("0622_1430", "floor", 0, 100, 10) + row("0622_1430", "floor", 1, 200, 10) +
                     row("0621_0430", "floor", 0, 0, std::nan("")) + row("0621_0430", "floor", 1, 0, std::nan("")) +
                     head + row("0621_0430", "desk", 0, 0, std::nan("")) + row("0622_1430", "desk", 0, 30, 3));
    const std::string b =
        folder.holding("b.tsv", head + row("0622_1430", "floor", 0, 110, 1) + row("0622_1430", "floor", 1, 210, 1));
    const Tables t = read_tables({a, b});
    REQUIRE(t.grids.size() == 2);
    CHECK(t.views.empty());
    const Grid& floor = t.grids[0];
    CHECK(floor.name == "floor");
    REQUIRE(floor.hours.size() == 2);
    CHECK(name_of(floor.hours[0].time) == "0621_0430");
    CHECK(is_dark(floor.hours[0]));
    REQUIRE(floor.sensors() == 2);
    CHECK(floor.hours[1].sensors[1].value == 210);
    CHECK(double(floor.hours[1].sensors[1].error) == doctest::Approx(1 / 1.96).epsilon(1e-4));
    CHECK(t.grids[1].hours[1].sensors[0].value == 30);
}

TEST_CASE("tables that are not whole are refused") {
    TempFolder folder;
    const auto said = [&](const std::string& rows) {
        const std::string file = folder.holding("t.tsv", rows);
        const std::string text = error_text([&] { read_tables({file}); });
        return text.compare(0, file.size(), file) == 0 ? text.substr(file.size() - 5) : text;
    };
    const std::string one = row("0622_1430", "floor", 0, 100, 10);
    CHECK(said(head + one + row("0622_1430", "floor", 2, 1, 0)) ==
          "t.tsv: floor at 0622_1430: point 2 where 1 comes next");
    CHECK(said(head + row("0622_1430", "floor", 1, 1, 0)) == "t.tsv: floor at 0622_1430: point 1 where 0 comes next");
    CHECK(said(head + one + row("0622_1530", "floor", 0, 1, 0) + row("0622_1530", "floor", 1, 1, 0)) ==
          "floor: 0622_1530 has other sensors than 0622_1430");
    CHECK(said(head + row("0622_1430", "floor", 0, 5, std::nan(""))) ==
          "0622_1430: has no interval: it needs two frames or more, and vcmetrics -ci 95");
    CHECK(said(head + row("noon", "floor", 0, 5, 1)) == "t.tsv: \"noon\" is not the name of an hour (0621_1430)");
    CHECK(said("sky\tgrid\tx\tE\tlo\thi\n0622_1430\tfloor\t0\t1\t1\t1\n") ==
          "t.tsv: has no column point (vcmetrics -each without -points)");
    CHECK(said("grid\tpoint\tE\tlo\thi\nfloor\t0\t1\t1\t1\n") ==
          "t.tsv: has no column sky with the names of hours (ptrace -wea)");
}

TEST_CASE("exact values are counted exactly, from each limit on") {
    Goals goals;
    goals.sun_lux = 900, goals.sun_hours = 99;
    const Grid grid = ramp(1000, 0);
    const GridYear y = judge(grid, &grid, goals, .05);
    const auto exactly = [](const Bounded& b, double value) {
        CHECK(b.value == doctest::Approx(value));
        CHECK(b.low == b.value);
        CHECK(b.high == b.value);
    };
    exactly(y.sensors[0].autonomy, .7);  // 300 to 999
    exactly(y.sensors[1].autonomy, .9);
    exactly(y.autonomy, .8);
    exactly(y.sensors[0].credited, (300 * 299 / 2 / 300. + 700) / 1000);  // the ramp below 300 lx has half of it
    exactly(y.sensors[1].credited, (100 * 99 / 2 / 100. + 900) / 1000);
    exactly(y.credited, (y.sensors[0].credited.value + y.sensors[1].credited.value) / 2);
    exactly(y.sensors[0].excessive, 0);  // 3000 lx
    exactly(judge(ramp(1000, 0), nullptr, Goals{50}, .05).sensors[0].excessive, .5);
    exactly(y.spatial, 1);
    exactly(y.sensors[0].useful[below], .1);
    exactly(y.sensors[0].useful[supplementary], .2);
    exactly(y.sensors[0].useful[autonomous], .7);
    exactly(y.sensors[0].useful[exceeded], 0);
    exactly(y.sensors[0].sun_hours, 100);
    exactly(y.exposed, 1);
    CHECK(y.dark == 1);
    goals.sun_hours = 100;  // more than so many
    goals.autonomy_share = .7 + 1e-6;
    const GridYear stricter = judge(grid, &grid, goals, .05);
    exactly(stricter.exposed, .5);
    exactly(stricter.spatial, .5);
    goals.autonomy_share = .7;
    exactly(judge(grid, nullptr, goals, .05).spatial, 1);
    CHECK(!judge(grid, nullptr, goals, .05).sun_hours);
}

TEST_CASE("a sensor's count has the width of independent errors, its limits hold the value") {
    const GridYear y = judge(ramp(1000, .05), nullptr, {}, .05);
    // Of a ramp of one hour a lx the variance is the sum of p (1 - p): s / sqrt(pi) with s = 15 lx.
    const double expected = 1.96 * std::sqrt(15 / std::sqrt(3.14159265)) / 1000;
    const Bounded& da = y.sensors[0].autonomy;
    CHECK((da.high - da.low) / 2 == doctest::Approx(expected).epsilon(.15));
    CHECK(holds(da, da.value));
    CHECK(summary(y, {}).find("sDA       100.0 % of the sensors have 300 lx in 50 % of the hours\n") !=
          std::string::npos);
}

namespace {

struct Coverage {
    std::array<size_t, 10> held{};     // DA, sDA, ASE, UDI, EN 17037's plane of 300 lx, cDA, DAmax
    size_t da = 0, sun = 0;            // of sensors
    double spatial = 0, autonomy = 0;  // widths
};

Coverage study(SimulatedYears& simulated, const std::array<double, 3>& error, size_t years, bool by_halves) {
    Coverage c;
    Goals goals;
    goals.sun_hours = 60;
    for (size_t k = 0; k < years; ++k) {
        simulated.draw(error[0], error[1], error[2]);
        Grid grid = simulated.seen;
        if (!by_halves) grid.shared = false, grid.strata = 0;
        const GridYear truth = judge(simulated.truth, &simulated.truth, goals, .05),
                       seen = judge(grid, &grid, goals, .05);
        c.held[0] += holds(seen.autonomy, truth.autonomy.value);
        c.held[1] += holds(seen.spatial, truth.spatial.value);
        c.held[2] += holds(seen.exposed, truth.exposed.value);
        for (size_t u = 0; u < usefulness_kinds; ++u) c.held[3 + u] += holds(seen.useful[u], truth.useful[u].value);
        DaylightHours all{"", grid.hours.size(), {}, {}};
        for (const GridHour& h : grid.hours) all.lit.push_back(h.time);
        c.held[7] += holds(judge_provision(grid, all, false, .05).plane[1],
                           judge_provision(simulated.truth, all, false, .05).plane[1].value);
        c.held[8] += holds(seen.credited, truth.credited.value);
        c.held[9] += holds(seen.excessive, truth.excessive.value);
        for (size_t i = 0; i < seen.sensors.size(); ++i) {
            c.da += holds(seen.sensors[i].autonomy, truth.sensors[i].autonomy.value);
            c.sun += holds(seen.sensors[i].sun_hours, truth.sensors[i].sun_hours.value);
        }
        c.spatial += (seen.spatial.high - seen.spatial.low) / double(years);
        c.autonomy += (seen.autonomy.high - seen.autonomy.low) / double(years);
    }
    return c;
}

}  // namespace

TEST_CASE("of simulated years, 93 % or more lie within the intervals of DA, sDA, UDI and ASE; of sensors, 93 %") {
    constexpr size_t years = 100, sensors = 20, hours = 300;
    SimulatedYears simulated(sensors, hours);
    const std::array<double, 3> errors[] = {{.03, 0, 0}, {.05, 1, 0}, {.12, .1, 0}, {.04, .2, .5}};
    for (const auto& error : errors)
        for (const bool by_halves : {true, false}) {
            if (!by_halves && error[2] > 0) continue;
            CAPTURE(error[0]);
            CAPTURE(error[1]);
            CAPTURE(error[2]);
            CAPTURE(by_halves);
            const Coverage c = study(simulated, error, years, by_halves);
            for (size_t k = 0; k < c.held.size(); ++k) {
                CAPTURE(k);
                CHECK(c.held[k] >= .93 * years - 2);
            }
            CHECK(c.da >= .93 * years * sensors);
            CHECK(c.sun >= .93 * years * sensors);
            CHECK(c.spatial <= .3);
        }
}

TEST_CASE("half-samples know how far errors of sensors are alike; hours that share paths need them") {
    SimulatedYears simulated(20, 300);
    const std::array<double, 3> own{.05, .1, 0}, shared{.04, .2, .5};
    CHECK(study(simulated, own, 20, true).autonomy < .6 * study(simulated, own, 20, false).autonomy);
    const Coverage without = study(simulated, shared, 60, false), with = study(simulated, shared, 60, true);
    CHECK(without.held[0] < .8 * 60);
    CHECK(without.da < .85 * 60 * 20);
    CHECK(with.held[0] >= .9 * 60);
    CHECK(with.da >= .93 * 60 * 20);
}

TEST_CASE("credit below the limit has the width of its hours' errors, and reaches over the bend at the limit") {
    // Hours of 100 lx: the sum of n has the error sqrt(n) e / 300.
    Grid flat{"floor", {}};
    for (int i = 0; i < 400; ++i) flat.hours.push_back({hour_number(i), {{100, 10}}});
    const Bounded below = judge(flat, nullptr, {}, .05).credited;
    CHECK(below.value == doctest::Approx(1 / 3.));
    CHECK((below.high - below.low) / 2 == doctest::Approx(1.96 * 10 / 300 / 20).epsilon(.001));
    // At the limit noise costs what lies above it: the mean of half a normal distribution, s / sqrt(2 pi), or more.
    for (GridHour& h : flat.hours) h.sensors[0] = {300, 10};
    const Bounded at = judge(flat, nullptr, {}, .05).credited;
    CHECK(at.high == 1);
    CHECK(at.low < 1 - 1.96 * 10 / 300 / 2 / 20 + 1e-6);
}

TEST_CASE("an hour without values may be any: it widens every share by itself") {
    Grid grid = ramp(1000, .01);
    const GridYear all = judge(grid, nullptr, {}, .05);
    for (Lux& e : grid.hours[500].sensors) e = {NAN, NAN};
    const GridYear y = judge(grid, nullptr, {}, .05);
    CHECK(y.missing == 1);
    CHECK(y.autonomy.low == doctest::Approx(all.autonomy.low - .001));
    CHECK(y.autonomy.high == doctest::Approx(all.autonomy.high));
    CHECK(y.useful[below].low == doctest::Approx(all.useful[below].low));
    CHECK(y.useful[below].high == doctest::Approx(all.useful[below].high + .001));
}
