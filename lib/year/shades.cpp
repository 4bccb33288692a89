// SPDX-License-Identifier: BSD-3-Clause
// See shades.h.
#include "year/shades.h"

#include <algorithm>
#include <map>

#include "year/shade_text.h"

namespace year {
namespace {

// By minute of the year.
std::map<int, size_t> hours_by_minute(const ShadeYear& year) {
    std::map<int, size_t> hours;
    for (size_t i = 0; i < year.hours.size(); ++i) hours[year.hours[i].minute_of_year()] = i;
    return hours;
}

// It may be as any of these, the first of which is the best.  The value stays; what is unknown reaches to the farthest
// of the others on each side, and has a sign where one side is farther.
Hour any_of(const std::vector<Hour>& hours) {
    Hour all = hours[0];
    double low = all.dgp.at(-1), high = all.dgp.at(1);
    for (const Hour& h : hours) {
        low = std::min(low, h.dgp.at(-1)), high = std::max(high, h.dgp.at(1));
        all.dgp.least = std::min(all.dgp.least, h.dgp.least), all.dgp.most = std::max(all.dgp.most, h.dgp.most);
        if (h.dgp.error > all.dgp.error)
            all.dgp.error = h.dgp.error, all.dgp.degrees = h.dgp.degrees, all.halves = h.halves;
        all.is_known = all.is_known && h.is_known;
        all.dark = all.dark && h.dark, all.is_missing = all.is_missing || h.is_missing;
    }
    const double down = all.dgp.value - low, up = high - all.dgp.value;
    all.dgp.bound = std::max(0., std::min(down, up));
    all.dgp.jump = up > down ? up - all.dgp.bound : all.dgp.bound - down;
    all.states = hours;
    return all;
}

}  // namespace

std::vector<View> with_shades(std::vector<View> views, const ShadeStates& states, const ShadeYear& year) {
    const std::map<int, size_t> hours = hours_by_minute(year);
    bool shared = false;
    for (const View& v : views) shared = shared || v.shared;
    for (View& view : views)
        for (Hour& h : view.hours) {
            const int minute = h.time.minute_of_year();
            std::vector<Hour> may;
            const size_t i = hours.at(minute);
            for (const Setting& s : settings_at(year, i)) {
                may.push_back(states.hour(states.name_of(s), view.name, minute));
                uncertainty::Uncertain& dgp = may.back().dgp;
                dgp.most = std::max(dgp.least, std::min(dgp.most, most_dgp(year, i, s, view.name)));
                shared = shared || !may.back().paths.empty();
            }
            h = may.size() > 1 ? any_of(may) : may[0];
            h.shades = shade_words(year, i);
        }
    for (View& view : views) {
        view.shared = shared;
        for (const Hour& h : view.hours)
            if (shared && h.dgp.error > 0) require_half_samples(h.time, h.halves.strata);
    }
    return views;
}

std::vector<Grid> with_shades(std::vector<Grid> grids, const ShadeStates& states, const ShadeYear& year) {
    const std::map<int, size_t> hours = hours_by_minute(year);
    for (Grid& grid : grids) {
        for (GridHour& h : grid.hours) {
            const int minute = h.time.minute_of_year();
            std::vector<GridHour> may;
            for (const Setting& s : settings_at(year, hours.at(minute)))
                may.push_back(states.hour_of_grid(states.name_of(s), grid.name, minute));
            h = std::move(may[0]);
            h.instead.assign(may.begin() + 1, may.end());
        }
        for (const StateTables& state : states.all())
            for (const Grid& g : state.tables.grids)
                if (g.name == grid.name)
                    grid.shared = grid.shared || g.shared, grid.strata = std::min(grid.strata, g.strata);
    }
    return grids;
}

}  // namespace year
