// SPDX-License-Identifier: BSD-3-Clause
// See shade_control.h.
#include "year/shade_control.h"

#include <algorithm>
#include <limits>
#include <map>

#include "base/error.h"

namespace year {
namespace {

uint64_t bit(size_t state) { return uint64_t(1) << state; }

// The first of n states that keeps it; the last one where none does.
template <class Look>
ShadeChoice most_open(size_t n, const Look& look) {
    ShadeChoice c{n - 1, 0, {}};
    bool found = false;
    for (size_t s = 0; s + 1 < n; ++s) {
        const Kept kept = look(s);
        if (kept.by_value && !found) c.best = s, found = true;
        if (kept.perhaps) c.may |= bit(s);
        if (kept.surely) return c;
    }
    c.may |= bit(n - 1);
    return c;
}

uint64_t kept_in(const ShadeChoice& c, size_t state) { return state < c.kept.size() ? c.kept[state] : 0; }

// All that f(a, b), which is one of both, may be.
template <class Of>
ShadeChoice combined(const ShadeChoice& a, const ShadeChoice& b, const Of& f) {
    ShadeChoice c{f(a.best, b.best), 0, {}, std::vector<uint64_t>(64, ~uint64_t(0))};
    for (size_t i = 0; a.may >> i; ++i)
        for (size_t k = 0; b.may >> k && (a.may & bit(i)); ++k) {
            if (!(b.may & bit(k))) continue;
            const size_t state = f(i, k);
            c.may |= bit(state);
            c.kept[state] &= (state == i ? kept_in(a, i) : 0) | (state == k ? kept_in(b, k) : 0);
        }
    return c;
}
size_t more_closed(size_t a, size_t b) { return std::max(a, b); }
size_t more_open(size_t a, size_t b) { return std::min(a, b); }

// Lists settings that have each of a group's possible states.
void spread(size_t group, const ShadeChoice& choice, std::vector<Setting>& settings) {
    const std::vector<Setting> before = settings;
    for (Setting& s : settings) s[group] = choice.best;
    for (size_t state = 0; choice.may >> state; ++state)
        if ((choice.may & bit(state)) && state != choice.best)
            for (Setting s : before) s[group] = state, settings.push_back(std::move(s));
}

// The same look in all settings that the other groups may have, the best first.
template <class Look>
Kept in_all(const std::vector<Setting>& settings, size_t group, size_t state, const Look& look) {
    Kept all;
    for (size_t i = 0; i < settings.size(); ++i) {
        Setting s = settings[i];
        s[group] = state;
        const Kept kept = look(s);
        if (i == 0) all = kept;
        all.surely = all.surely && kept.surely, all.perhaps = all.perhaps || kept.perhaps;
    }
    return all;
}

// What a rule asks for in an hour.  others: settings that the other groups may have; closed: all most closed.
struct Asking {
    const ShadeStates& states;
    const ShadeSources& sources;
    const std::vector<Setting>& others;
    const Setting& closed;
    size_t group, rule;
    weather::Time time;
};

ShadeChoice glare_asks(const ReadyRule& r, double limit, const Asking& a) {
    ShadeChoice c = most_open(r.states.size(), [&](size_t state) {
        return in_all(a.others, a.group, state, [&](const Setting& s) {
            return glare_kept(r, limit, *a.sources.glare, a.states.name_of(s), a.time);
        });
    });
    const bool counted = a.sources.glare == &a.states;  // not other views of -by
    if (counted && a.rule < 64) c.kept.assign(r.states.size() - 1, bit(a.rule));
    return c;
}

ShadeChoice asked_by(const ReadyRule& r, const Asking& a) {
    const auto of = [](size_t state) { return ShadeChoice{state, bit(state), {}}; };
    switch (r.rule.kind) {
    case ShadeRule::Kind::schedule: return of(state_at(r.schedule, a.time, r.states, r.rule.file));
    case ShadeRule::Kind::slats:
        return most_open(r.states.size(), [&](size_t state) { return sun_kept_out(r, state, a.time); });
    case ShadeRule::Kind::sun:
        return most_open(r.states.size(), [&](size_t state) {
            return in_all({a.closed}, a.group, state, [&](const Setting& s) {
                return sun_kept(r, *a.sources.direct, a.states.name_of(s), a.time);
            });
        });
    case ShadeRule::Kind::glare: break;
    }
    return glare_asks(r, r.rule.limit, a);
}

// before: what the rule has come to in the hour before; nothing in the first one.
ShadeChoice with_memory(const ReadyRule& r, const Asking& a, const std::optional<ShadeChoice>& before, bool same_day) {
    const ShadeChoice now = asked_by(r, a);
    if (!before) return now;
    ShadeChoice stays = *before;
    stays.kept.clear();  // it kept the limit an hour ago
    if (r.rule.until_morning) return same_day ? combined(now, stays, more_closed) : now;
    if (r.rule.until >= r.rule.limit) return now;
    return combined(now, combined(stays, glare_asks(r, r.rule.until, a), more_open), more_closed);
}

// All hours that any view or grid has.
std::vector<weather::Time> hours_in(const Tables& t) {
    std::map<int, weather::Time> all;
    for (const View& v : t.views)
        for (const Hour& h : v.hours) all.emplace(h.time.minute_of_year(), h.time);
    for (const Grid& g : t.grids)
        for (const GridHour& h : g.hours) all.emplace(h.time.minute_of_year(), h.time);
    std::vector<weather::Time> hours;
    for (const auto& [minute, time] : all) hours.push_back(time);
    return hours;
}

void require_groups(const std::vector<ShadeGroup>& groups, const std::vector<ShadeRule>& rules) {
    for (const ShadeRule& r : rules)
        if (!r.group.empty() &&
            std::none_of(groups.begin(), groups.end(), [&](const auto& g) { return g.name == r.group; }))
            base::fail(r.text, "no group is called \"" + r.group + "\"");
}

}  // namespace

ShadeYear control(const ShadeStates& counted, const ShadeSources& sources, const std::vector<ShadeRule>& rules) {
    const std::vector<ShadeGroup>& groups = counted.groups;
    require_groups(groups, rules);
    ShadeYear year{groups, rules, hours_in(counted.open()), {}};
    struct Applied {
        size_t number;
        ReadyRule rule;
        std::optional<ShadeChoice> before;
    };
    std::vector<std::vector<Applied>> applied(groups.size());
    Setting closed;
    for (size_t g = 0; g < groups.size(); ++g) {
        closed.push_back(groups[g].states.size() - 1);
        for (size_t r = 0; r < rules.size(); ++r)
            if (rules[r].group.empty() || rules[r].group == groups[g].name)
                applied[g].push_back({r, ready(rules[r], groups[g], sources), {}});
    }
    year.of_group.resize(groups.size());
    int day = 0;
    for (const weather::Time& time : year.hours) {
        const bool same_day = day == time.date.in_leap_year();
        day = time.date.in_leap_year();
        std::vector<Setting> settings{closed};
        for (size_t g = 0; g < groups.size(); ++g) {
            ShadeChoice choice;
            for (Applied& a : applied[g]) {
                a.before =
                    with_memory(a.rule, {counted, sources, settings, closed, g, a.number, time}, a.before, same_day);
                const std::optional<size_t> rule = a.before->best > choice.best ? a.number : choice.rule;
                choice = combined(choice, *a.before, more_closed);
                choice.rule = rule;
            }
            year.of_group[g].push_back(choice);
            spread(g, choice, settings);
        }
    }
    return year;
}

// A group has seen the room as it is where those after it are as closed as they were when it decided.
double most_dgp(const ShadeYear& year, size_t i, const Setting& setting, const std::string& view) {
    double most = std::numeric_limits<double>::infinity();
    for (size_t g = setting.size(); g-- > 0;) {
        const uint64_t kept = kept_in(year.of_group[g][i], setting[g]);
        for (size_t r = 0; r < std::min<size_t>(year.rules.size(), 64); ++r) {
            const std::vector<std::string>& at = year.rules[r].at;
            const bool is_read = at.empty() || std::find(at.begin(), at.end(), view) != at.end();
            if ((kept & bit(r)) && is_read) most = std::min(most, year.rules[r].limit);
        }
        if (setting[g] + 1 < year.groups[g].states.size()) break;
    }
    return most;
}

std::vector<Setting> settings_at(const ShadeYear& year, size_t i) {
    std::vector<Setting> settings{Setting(year.groups.size())};
    for (size_t g = 0; g < year.groups.size(); ++g) spread(g, year.of_group[g][i], settings);
    return settings;
}

}  // namespace year
