// SPDX-License-Identifier: BSD-3-Clause
// A year of sensors: tables, closed forms, and simulated years whose truth is known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "temp_folder.h"
#include "uncertainty/student.h"
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
// decade and more among the hours.  Relative errors have a part in common among the sensors of an hour, and are
// estimated with 15 degrees of freedom.
class SimulatedYears {
public:
    SimulatedYears(size_t sensors, size_t hours) : sensors_(sensors), hours_(hours) {}
    void draw(double error, double common) {
        truth = seen = Grid{"floor", {}};
        for (size_t h = 0; h < hours_; ++h) {
            const double sky = h % 10 == 0 ? 0 : 4000 * std::exp(1.2 * normal_(random_)), all = normal_(random_);
            std::vector<Lux> exact, noisy;
            for (size_t i = 0; i < sensors_; ++i) {
                const double e = sky * std::pow(30, -double(i) / double(sensors_)) * std::exp(.3 * normal_(random_));
                const double off = std::sqrt(common) * all + std::sqrt(1 - common) * normal_(random_);
                exact.push_back({float(e), 0});
                noisy.push_back(
                    {float(e * (1 + error * off)), float(t_ * e * error * std::sqrt(chi_(random_) / degrees))});
            }
            truth.hours.push_back({hour_number(int(h)), exact});
            seen.hours.push_back({hour_number(int(h)), noisy});
        }
    }
    Grid truth, seen;

private:
    static constexpr double degrees = 15;
    const double t_ = uncertainty::student_quantile(.05, degrees) / 1.95996;
    size_t sensors_, hours_;
    std::mt19937 random_{1};
    std::normal_distribution<double> normal_;
    std::chi_squared_distribution<double> chi_{degrees};
};

bool holds(const Between& interval, double truth) {
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
    const auto exactly = [](const Between& b, double value) {
        CHECK(b.value == doctest::Approx(value));
        CHECK(b.low == b.value);
        CHECK(b.high == b.value);
    };
    exactly(y.sensors[0].autonomy, .7);  // 300 to 999
    exactly(y.sensors[1].autonomy, .9);
    exactly(y.autonomy, .8);
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
    const Between& da = y.sensors[0].autonomy;
    CHECK((da.high - da.low) / 2 == doctest::Approx(expected).epsilon(.15));
    CHECK(holds(da, da.value));
    CHECK(summary(y, {}).find("sDA       100.0 % of the sensors have 300 lx in 50 % of the hours\n") !=
          std::string::npos);
}

TEST_CASE("of simulated years, 93 % or more lie within the intervals of DA, sDA, UDI and ASE; of sensors, 93 %") {
    constexpr size_t years = 100, sensors = 20, hours = 300;
    SimulatedYears simulated(sensors, hours);
    Goals goals;
    goals.sun_hours = 60;
    const std::pair<double, double> errors[] = {{.03, 0}, {.05, 1}, {.12, .1}};
    for (const auto& [error, common] : errors) {
        CAPTURE(error);
        CAPTURE(common);
        std::array<size_t, 7> held{};
        size_t da = 0, sun = 0;
        double width = 0;
        for (size_t k = 0; k < years; ++k) {
            simulated.draw(error, common);
            const GridYear truth = judge(simulated.truth, &simulated.truth, goals, .05),
                           seen = judge(simulated.seen, &simulated.seen, goals, .05);
            held[0] += holds(seen.autonomy, truth.autonomy.value);
            held[1] += holds(seen.spatial, truth.spatial.value);
            held[2] += holds(seen.exposed, truth.exposed.value);
            for (size_t u = 0; u < usefulness_kinds; ++u) held[3 + u] += holds(seen.useful[u], truth.useful[u].value);
            for (size_t i = 0; i < sensors; ++i) {
                da += holds(seen.sensors[i].autonomy, truth.sensors[i].autonomy.value);
                sun += holds(seen.sensors[i].sun_hours, truth.sensors[i].sun_hours.value);
            }
            width += (seen.spatial.high - seen.spatial.low) / years;
        }
        for (size_t k = 0; k < held.size(); ++k) {
            CAPTURE(k);
            CHECK(held[k] >= .93 * years - 2);
        }
        CHECK(da >= .93 * years * sensors);
        CHECK(sun >= .93 * years * sensors);
        CHECK(width <= .3);
    }
}
