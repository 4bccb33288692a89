// SPDX-License-Identifier: BSD-3-Clause
// What views and sensors have in each state of the shades, and the groups whose states are combined there
// (ptrace -state): "shut", or "south/half+west/shut".
//
// Where each group has a state "black" and combinations are not there, the light of groups adds up: tables have the
// states of each group with all others black, and all black.  Sensors then have in any combination the sum over groups
// less what enters with all black, once too often for each group but one.  No group may light another one's panes.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "year/table.h"

namespace year {

struct ShadeGroup {
    std::string name;                 // empty: the only one
    std::vector<std::string> states;  // from the most open to the most closed one
};

using Setting = std::vector<size_t>;  // of each group, its state

class ShadeStates {
public:
    // Rows of tables come from the most open to the most closed state.  Throws Error (place: the state) for names that
    // do not combine states of the same groups.
    explicit ShadeStates(std::vector<StateTables> tables);

    std::vector<ShadeGroup> groups;
    const Tables& open() const { return tables_.front().tables; }  // all groups at their most open state
    const std::vector<StateTables>& all() const { return tables_; }
    std::string name_of(const Setting& setting) const;
    bool has(const std::string& state) const { return at_.count(state) > 0; }

    // Of a state by its name.  Throw Error (place: the state) where they are not in the tables.
    const Hour& hour(const std::string& state, const std::string& view, int minute) const;
    GridHour hour_of_grid(const std::string& state, const std::string& grid, int minute) const;

private:
    std::vector<StateTables> tables_;
    std::map<std::string, size_t> at_;
    bool adds_up_ = false;
    void add_up();
    GridHour sum_of_groups(const std::string& state, const std::string& grid, int minute) const;
    const StateTables& tables_of(const std::string& state) const;
};

}  // namespace year
