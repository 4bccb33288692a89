// SPDX-License-Identifier: BSD-3-Clause
// See shades.h.
#include "year/shades.h"

#include <algorithm>
#include <map>

#include "base/error.h"

namespace year {
namespace {

enum class State { open, either, closed };

// By minute of the year.
std::map<int, State> states_of(const std::vector<View>& open, double limit) {
    std::map<int, State> states;
    for (const View& view : open)
        for (const Hour& h : view.hours) {
            State& s = states[h.time.minute_of_year()];
            s = std::max(s, holds(h, limit) ? State::either : h.dgp.value > limit ? State::closed : State::open);
        }
    return states;
}

const Hour& hour_at(const std::vector<View>& views, const std::string& name, const weather::Time& time) {
    const auto view = std::find_if(views.begin(), views.end(), [&](const View& v) { return v.name == name; });
    if (view == views.end()) base::fail("-closed", "has no view \"" + name + "\"");
    for (const Hour& h : view->hours)
        if (h.time.minute_of_year() == time.minute_of_year()) return h;
    base::fail("-closed", "has no " + name_of(time) + ", in which shades may be closed");
}

Hour either_of(Hour a, const Hour& b) {
    const double low = std::min(a.dgp.at(-1), b.dgp.at(-1)), high = std::max(a.dgp.at(1), b.dgp.at(1));
    const Hour& wider = a.dgp.error < b.dgp.error ? b : a;
    a.halves = wider.halves;
    a.dgp = {(low + high) / 2, wider.dgp.error, (high - low) / 2, 0, wider.dgp.degrees};
    a.is_known = a.is_known && b.is_known;
    return a;
}

}  // namespace

Shaded with_shades(std::vector<View> open, const std::vector<View>& closed, double limit) {
    const std::map<int, State> states = states_of(open, limit);
    const auto count = [&](State least) {
        return double(std::count_if(states.begin(), states.end(), [&](const auto& s) { return s.second >= least; }));
    };
    std::map<int, bool> above;
    for (const View& view : open)
        for (const Hour& h : view.hours) above[h.time.minute_of_year()] |= h.dgp.value > limit;
    const auto is_above = [](const auto& a) { return a.second; };
    Shaded out{
        std::move(open),
        {double(std::count_if(above.begin(), above.end(), is_above)), count(State::closed), count(State::either)}};
    for (View& view : out.views)
        for (Hour& h : view.hours) {
            const State s = states.at(h.time.minute_of_year());
            if (s == State::open) continue;
            const Hour& other = hour_at(closed, view.name, h.time);
            h = s == State::closed ? other : either_of(h, other);
        }
    const auto is_shared = [](const View& v) { return v.shared; };
    const bool shared = std::any_of(closed.begin(), closed.end(), is_shared) ||
                        std::any_of(out.views.begin(), out.views.end(), is_shared);
    for (View& view : out.views) {
        view.shared = shared;
        for (const Hour& h : view.hours)
            if (shared && h.dgp.error > 0) require_half_samples(h.time, h.halves.strata);
    }
    return out;
}

}  // namespace year
