// SPDX-License-Identifier: BSD-3-Clause
// Do intervals of a year of moving shades hold the truth?  Simulated years of some states, whose errors all hours have
// in part in common; shades are moved by what is seen, and in truth by what is true.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <map>

#include "uncertainty_shared_year.h"
#include "year/autonomy.h"
#include "year/shade_text.h"
#include "year/shades.h"

namespace {

using namespace year;

constexpr size_t hours = 300, sensors = 4;
constexpr int years = 40;

struct Shades {
    std::vector<std::pair<const char*, double>> states;  // and what they let through
    double error;                                        // of an hour, relative
    bool alike;  // hours of all states have one truth but for that; else each has its own
};
const Shades three{{{"open", 1}, {"half", .6}, {"shut", .25}}, .02, false},
    slats{{{"open", 1}, {"half", .6}, {"35", .57}, {"50", .54}, {"shut", .51}}, .04, true};

// Tables of the states, as they are and as they are seen.
struct Drawn {
    std::vector<StateTables> truth, seen;
};

weather::Time hour_number(size_t i) { return {weather::date_of(int(1 + i / 10)), 8.5 + double(i % 10)}; }

uncertainty::HalfCodes codes_of(const uncertainty::Shared& s, double strata) {
    return uncertainty::halves_of({s.off.begin(), s.off.end()}, strata).codes;
}

Drawn draw(SharedYears& random, const Shades& shades) {
    Drawn out;
    const SharedYear all = shades.alike ? random.draw(hours) : SharedYear{};
    for (const auto& [name, share] : shades.states) {
        StateTables truth{name, {}}, seen{name, {}};
        View desk{"desk", {}}, seen_desk{"desk", {}, true};
        const SharedYear glare = random.draw(hours);
        for (size_t i = 0; i < hours; ++i) {
            const double scale = share * .0005 *  // a quarter of the open hours is above .40
                                 (shades.alike ? all.truth[i] / glare.truth[i] : 1);
            Hour h;
            h.time = hour_number(i);
            h.dgp.value = scale * glare.truth[i];
            desk.hours.push_back(h);
            const uncertainty::Shared& s = glare.seen[i];
            h.dgp = {scale * s.of.value, scale * s.of.error, 0, 0, s.of.degrees};
            h.halves = {codes_of(s, glare.strata), glare.strata};
            h.paths = name;
            seen_desk.hours.push_back(h);
        }
        Grid floor{"floor", {}}, seen_floor{"floor", {}, true, glare.strata};
        for (size_t i = 0; i < hours; ++i) floor.hours.push_back({hour_number(i), {}});
        seen_floor.hours = floor.hours;
        for (size_t k = 0; k < sensors; ++k) {
            const SharedYear light = random.draw(hours);
            for (size_t i = 0; i < hours; ++i) {
                const uncertainty::Shared& s = light.seen[i];
                floor.hours[i].sensors.push_back({float(share * light.truth[i]), 0});
                GridHour& h = seen_floor.hours[i];
                h.sensors.push_back({float(share * s.of.value), float(share * s.of.error)});
                h.halves.push_back(codes_of(s, light.strata));
                h.degrees = s.of.degrees, h.strata = light.strata, h.paths = name;
            }
        }
        truth.tables.views = {desk}, truth.tables.grids = {floor};
        seen.tables.views = {seen_desk}, seen.tables.grids = {seen_floor};
        out.truth.push_back(truth), out.seen.push_back(seen);
    }
    return out;
}

using Results = std::map<std::string, Bounded>;

Results results_of(const std::vector<StateTables>& tables, const std::string& rules) {
    const ShadeStates s(tables);
    const ShadeYear y = control(s, {&s, nullptr}, parse_shade_rules(rules, "-shades"));
    const Verdict v = judge(with_shades(s.open().views, s, y)[0], .05);
    const GridYear g = judge(with_shades(s.open().grids, s, y)[0], nullptr, Goals{}, .05);
    const GroupYear shades = group_years(y)[0];
    Results r{{"above .35", v.above[0]},
              {"above .40", v.above[1]},
              {"DGPe5", v.exceeded},
              {"autonomy", v.autonomy},
              {"DA", g.autonomy},
              {"sDA", g.spatial},
              {"UDI below", g.useful[below]},
              {"UDI", g.useful[autonomous]},
              {"UDI low", g.useful[supplementary]},
              {"open", shades.hours[0]},
              {"half", shades.hours[1]},
              {"shut", shades.hours.back()},
              {"moves", shades.moves}};
    return r;
}

void study(const std::string& rules, const Shades& shades) {
    CAPTURE(rules);
    SharedYears random(7, 16, shades.error, {.5, .2, .3});
    std::map<std::string, int> held;
    std::map<std::string, double> width;
    for (int k = 0; k < years; ++k) {
        const Drawn d = draw(random, shades);
        const Results truth = results_of(d.truth, rules), seen = results_of(d.seen, rules);
        for (const auto& [name, b] : seen) {
            const double t = truth.at(name).value;
            held[name] += b.low <= t + 1e-9 && t - 1e-9 <= b.high;
            width[name] += (b.high - b.low) / 2 / years;
        }
    }
    for (const auto& [name, n] : held) {
        INFO(name << ": " << n << " of " << years << ", half-width " << width[name]);
        CHECK(n >= 93 * years / 100);
    }
}

}  // namespace

TEST_CASE("intervals of what glare moves hold the truth in 93 % of simulated years or more") {
    study("glare .40", three);
}
TEST_CASE("so do those of shades that stay closed for the day") { study("glare .40 until morning", three); }
TEST_CASE("and of slats that hardly differ, so that many hours are in doubt") { study("glare .40", slats); }
