// SPDX-License-Identifier: BSD-3-Clause
// Does a state of the shades keep the limit of a rule in an hour?
#pragma once
#include <map>
#include <string>
#include <vector>

#include "weather/weather.h"
#include "year/shade_rules.h"
#include "year/shade_schedule.h"
#include "year/shade_states.h"

namespace year {

// By its values, surely, or not even perhaps.
struct Kept {
    bool by_value = true, surely = true, perhaps = true;
};

// What rules read.
struct ShadeSources {
    const ShadeStates* glare = nullptr;   // tables of views
    const ShadeStates* direct = nullptr;  // tables of sensors under direct sun alone; null: there are none
};

// A rule with the files that it names, for one group.
struct ReadyRule {
    ShadeRule rule;
    std::vector<std::string> states;  // of the group
    ShadeSchedule schedule;
    weather::Weather weather;
    std::map<int, size_t> weather_at;  // its hours, by minute of the year
};
// Throws Error (place: the rule) where tables lack what it reads.
ReadyRule ready(const ShadeRule& rule, const ShadeGroup& group, const ShadeSources& sources);

// All its views in one of the states of ptrace -state.
Kept glare_kept(const ReadyRule& rule, double limit, const ShadeStates& views, const std::string& state,
                const weather::Time& time);
Kept sun_kept(const ReadyRule& rule, const ShadeStates& direct, const std::string& state, const weather::Time& time);
// state: the number of the group's.
Kept sun_kept_out(const ReadyRule& rule, size_t state, const weather::Time& time);

}  // namespace year
