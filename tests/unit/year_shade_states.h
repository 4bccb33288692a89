// SPDX-License-Identifier: BSD-3-Clause
// Tables of states of shades for tests, and what rules make of them in letters.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "year/shade_control.h"

namespace year {

inline weather::Time hour_number(int i) { return {weather::date_of(1 + i / 24), i % 24 + .5}; }

inline Hour hour_of_dgp(int i, double dgp, double error = .001) {
    Hour h;
    h.time = hour_number(i);
    h.dgp = {dgp, error, 0};
    return h;
}

// Views "desk" with these DGP, hour by hour, in each state.
inline ShadeStates states_of(const std::vector<std::pair<std::string, std::vector<double>>>& states,
                             double error = .001) {
    std::vector<StateTables> tables;
    for (const auto& [name, dgps] : states) {
        View desk{"desk", {}};
        for (size_t i = 0; i < dgps.size(); ++i) desk.hours.push_back(hour_of_dgp(int(i), dgps[i], error));
        tables.push_back({name, {}});
        tables.back().tables.views = {desk};
    }
    return ShadeStates(std::move(tables));
}

inline ShadeYear controlled(const ShadeStates& s, const std::string& rules, const ShadeStates* direct = nullptr) {
    return control(s, {&s, direct}, parse_shade_rules(rules, "-shades"));
}

// The state of each hour by its first letter; "a|b" where it may be either.
inline std::string letters(const ShadeYear& y, size_t group = 0) {
    std::string text;
    for (const ShadeChoice& c : y.of_group[group]) {
        std::string may;
        for (size_t s = 0; s < y.groups[group].states.size(); ++s)
            if (c.may >> s & 1) may += (may.empty() ? "" : "|") + y.groups[group].states[s].substr(0, 1);
        text += (text.empty() ? "" : " ") + may;
    }
    return text;
}

}  // namespace year
