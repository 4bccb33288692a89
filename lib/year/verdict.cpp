// SPDX-License-Identifier: BSD-3-Clause
// See verdict.h.
#include "year/verdict.h"

#include <algorithm>
#include <cmath>

#include "uncertainty/shared_counts.h"

namespace year {
namespace {

std::vector<uncertainty::Uncertain> values_of(const View& view) {
    std::vector<uncertainty::Uncertain> values;
    for (const Hour& h : view.hours) values.push_back(h.dgp);
    return values;
}

// Of an hour whose state of shades is in doubt that one counts that is most surely above the limit (side 1), or least
// surely (-1).
const Hour& state_of(const Hour& h, double limit, double side) {
    const Hour* farthest = &h;
    double chance = -1;
    for (const Hour& state : h.states) {
        const double above = uncertainty::chance_above(state.dgp, limit, side), here = side > 0 ? above : 1 - above;
        if (here > chance) farthest = &state, chance = here;
    }
    return *farthest;
}

View with_states(const View& view, double limit, double side) {
    View out{view.name, {}, view.shared};
    for (const Hour& h : view.hours) out.hours.push_back(state_of(h, limit, side));
    return out;
}

bool is_doubtful(const View& view) {
    return std::any_of(view.hours.begin(), view.hours.end(), [](const Hour& h) { return !h.states.empty(); });
}

std::vector<uncertainty::Shared> shared_values_of(const View& view) {
    std::vector<uncertainty::Shared> values;
    for (const Hour& h : view.hours) values.push_back({h.dgp, uncertainty::off(h.halves.codes)});
    return values;
}

// The fewest of an hour that has noise.
double strata_of(const View& view) {
    double least = uncertainty::strata;
    for (const Hour& h : view.hours)
        if (h.dgp.error > 0) least = std::min(least, h.halves.strata);
    return least;
}

}  // namespace

int class_of(double dgp) { return int(std::lower_bound(limits.begin(), limits.end(), dgp) - limits.begin()); }

const char* class_name(int k) {
    const char* const names[4] = {"high", "medium", "minimum", "none"};
    return names[k];
}

bool holds(const Hour& h, double limit) { return h.low() < limit && limit < h.high(); }

uncertainty::Interval hours_above(const View& view, double limit, double alpha) {
    if (is_doubtful(view))
        return {hours_above(with_states(view, limit, -1), limit, alpha).low,
                hours_above(with_states(view, limit, 1), limit, alpha).high};
    return view.shared ? uncertainty::count_above(shared_values_of(view), strata_of(view), limit, alpha)
                       : uncertainty::count_above(values_of(view), limit, alpha);
}

uncertainty::Interval exceeded_dgp(const View& view, size_t exceeding, double alpha) {
    if (is_doubtful(view)) {
        // Which state is the worst depends on the limit sought: it is found again with those that count there.
        constexpr int rounds = 3;
        uncertainty::Interval all{uncertainty::exceeded(values_of(view), exceeding), 0};
        all.high = all.low;
        for (int round = 0; round < rounds; ++round)
            all = {std::min(all.low, exceeded_dgp(with_states(view, all.low, -1), exceeding, alpha).low),
                   std::max(all.high, exceeded_dgp(with_states(view, all.high, 1), exceeding, alpha).high)};
        return all;
    }
    return view.shared ? uncertainty::exceeded_interval(shared_values_of(view), strata_of(view), exceeding, alpha)
                       : uncertainty::exceeded_interval(values_of(view), exceeding, alpha);
}

Verdict judge(const View& view, double alpha) {
    Verdict v;
    v.view = view.name;
    v.hours = view.hours.size();
    v.to_come = view.to_come;
    const auto count = [&](auto&& is) { return size_t(std::count_if(view.hours.begin(), view.hours.end(), is)); };
    v.dark = count([](const Hour& h) { return h.dark; });
    v.missing = count([](const Hour& h) { return h.is_missing; });
    v.undecided = count([](const Hour& h) {
        return std::any_of(limits.begin(), limits.end(), [&](double limit) { return holds(h, limit); });
    });
    for (size_t k = 0; k < limits.size(); ++k) {
        const uncertainty::Interval n = hours_above(view, limits[k], alpha);
        v.above[k] = {double(count([&](const Hour& h) { return h.dgp.value > limits[k]; })), n.low, n.high};
    }
    const size_t exceeding = size_t(exceeding_share * double(v.hours) + 1e-9);
    const uncertainty::Interval e = exceeded_dgp(view, exceeding, alpha);
    v.exceeded = {uncertainty::exceeded(values_of(view), exceeding), e.low, e.high};
    constexpr double rounding = 1e-9;
    v.best = class_of(e.low - rounding);
    v.worst = class_of(e.high - rounding);
    const auto share = [&](double n) { return 1 - n / double(v.hours); };
    v.autonomy = {share(v.above[1].value), share(v.above[1].high), share(v.above[1].low)};
    return v;
}

Bounded spatial_autonomy(const std::vector<Verdict>& verdicts) {
    constexpr double enough = .95;
    Bounded s;
    const double share = 1 / double(verdicts.size());
    for (const Verdict& v : verdicts) {
        s.value += share * (v.autonomy.value >= enough);
        s.low += share * (v.autonomy.low >= enough);
        s.high += share * (v.autonomy.high >= enough);
    }
    return s;
}

std::vector<Hour> worst_hours(const View& view, size_t n) {
    std::vector<Hour> hours = view.hours;
    n = std::min(n, hours.size());
    const auto worse = [](const Hour& a, const Hour& b) { return a.dgp.value > b.dgp.value; };
    std::partial_sort(hours.begin(), hours.begin() + long(n), hours.end(), worse);
    hours.resize(n);
    return hours;
}

}  // namespace year
