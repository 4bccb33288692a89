// SPDX-License-Identifier: BSD-3-Clause
// Which state shades have in each hour, by rules (shade_rules.h), and which they may have: where an interval holds the
// limit of a rule an hour may be either, and so may be those after it that depend on it.
//
// Groups decide in their order.  Glare is looked at with the groups before it as they stand and those after it at their
// most closed state; direct sun with all others at their most closed state, since each answers for its own.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "year/shade_looks.h"

namespace year {

struct ShadeChoice {
    size_t best = 0;                  // the state by the values in the middle of their intervals
    uint64_t may = 1;                 // a bit for each state that it may have; best among them
    std::optional<size_t> rule;       // that closed it
    std::vector<uint64_t> kept = {};  // by state: a bit for each rule of glare whose limit is kept if shades have it
    bool sure() const { return (may & (may - 1)) == 0; }
};

struct ShadeYear {
    std::vector<ShadeGroup> groups;
    std::vector<ShadeRule> rules;
    std::vector<weather::Time> hours;                // by time
    std::vector<std::vector<ShadeChoice>> of_group;  // of each hour
};

// Throws Error (place: the rule) where tables lack what a rule reads.
ShadeYear control(const ShadeStates& counted, const ShadeSources& sources, const std::vector<ShadeRule>& rules);

// The settings that shades may have in hour i, the best first.
std::vector<Setting> settings_at(const ShadeYear& year, size_t i);

// The DGP that a view does not exceed in hour i if shades have this setting: who controls them by glare takes a state
// other than the most closed one only where it keeps the limit.
double most_dgp(const ShadeYear& year, size_t i, const Setting& setting, const std::string& view);

}  // namespace year
