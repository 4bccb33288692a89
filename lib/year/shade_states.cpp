// SPDX-License-Identifier: BSD-3-Clause
// See shade_states.h.
#include "year/shade_states.h"

#include <algorithm>

#include "base/error.h"
#include "base/split.h"
#include "year/light_sums.h"

namespace year {
namespace {

const std::string black = "black";

std::string place_of(const std::string& state) { return "state " + (state.empty() ? "-" : state); }

// "south/half" as group and state.
std::pair<std::string, std::string> parts_of(const std::string& word) {
    const size_t slash = word.find('/');
    if (slash == std::string::npos) return {"", word};
    return {word.substr(0, slash), word.substr(slash + 1)};
}

// The hour of the item of this name.
template <class Item>
const auto& find_hour(const std::vector<Item>& items, const std::string& name, int minute, const std::string& state,
                      const char* kind) {
    const auto item = std::find_if(items.begin(), items.end(), [&](const Item& i) { return i.name == name; });
    if (item == items.end()) base::fail(place_of(state), std::string("has no ") + kind + " \"" + name + "\"");
    const auto hour = std::lower_bound(item->hours.begin(), item->hours.end(), minute,
                                       [](const auto& h, int m) { return h.time.minute_of_year() < m; });
    if (hour == item->hours.end() || hour->time.minute_of_year() != minute) {
        const weather::Time time{weather::date_of(minute / 1440 + 1), minute % 1440 / 60.};
        base::fail(place_of(state), "has no " + name_of(time) + ", in which shades may have it");
    }
    return *hour;
}

}  // namespace

ShadeStates::ShadeStates(std::vector<StateTables> tables) : tables_(std::move(tables)) {
    for (size_t k = 0; k < tables_.size(); ++k) {
        const std::string& name = tables_[k].state;
        const std::vector<std::string> words = base::split_list(name, '+');
        if (k == 0)
            for (const std::string& word : words) groups.push_back({parts_of(word).first, {}});
        if (k == 0 && words.empty()) groups.push_back({"", {""}});
        for (size_t g = 0; g < words.size(); ++g) {
            const auto [group, state] = parts_of(words[g]);
            if (words.size() != groups.size() || group != groups[g].name)
                base::fail(place_of(name), "has other groups than " + tables_[0].state);
            std::vector<std::string>& known = groups[g].states;
            if (std::find(known.begin(), known.end(), state) == known.end()) known.push_back(state);
        }
        at_[name] = k;
    }
    add_up();
}

// No group has the state black; the first tables have the sums of the most open ones.
void ShadeStates::add_up() {
    std::vector<ShadeGroup> lit = groups;
    for (ShadeGroup& g : lit) {
        const auto found = std::find(g.states.begin(), g.states.end(), black);
        if (groups.size() < 2 || found == g.states.end()) return;
        g.states.erase(found);
        if (g.states.empty()) return;
    }
    std::swap(groups, lit);
    const std::string open = name_of(Setting(groups.size(), 0));
    if (adds_up_ = !has(open); !adds_up_) return std::swap(groups, lit);
    StateTables sums = tables_.front();
    sums.state = open;
    for (Grid& grid : sums.tables.grids)
        for (GridHour& h : grid.hours) h = sum_of_groups(open, grid.name, h.time.minute_of_year());
    tables_.insert(tables_.begin(), std::move(sums));
    for (auto& [name, k] : at_) ++k;
    at_[open] = 0;
}

GridHour ShadeStates::sum_of_groups(const std::string& state, const std::string& grid, int minute) const {
    const std::vector<std::string> words = base::split_list(state, '+');
    const auto at = [&](size_t lit) {  // this group alone, or none
        std::string name;
        for (size_t g = 0; g < groups.size(); ++g)
            name += (g ? "+" : "") + (g == lit ? words[g] : groups[g].name + "/" + black);
        return &find_hour(tables_of(name).tables.grids, grid, minute, name, "grid");
    };
    std::vector<std::pair<double, const GridHour*>> parts{{1 - double(groups.size()), at(groups.size())}};
    for (size_t g = 0; g < groups.size(); ++g) parts.emplace_back(1, at(g));
    return sum_of(parts);
}

std::string ShadeStates::name_of(const Setting& setting) const {
    std::string name;
    for (size_t g = 0; g < groups.size(); ++g) {
        const ShadeGroup& group = groups[g];
        name += (g ? "+" : "") + group.name + (group.name.empty() ? "" : "/") + group.states[setting[g]];
    }
    return name;
}

const StateTables& ShadeStates::tables_of(const std::string& state) const {
    const auto found = at_.find(state);
    if (found == at_.end()) base::fail(place_of(state), "is not in the tables");
    return tables_[found->second];
}

const Hour& ShadeStates::hour(const std::string& state, const std::string& view, int minute) const {
    return find_hour(tables_of(state).tables.views, view, minute, state, "view");
}

GridHour ShadeStates::hour_of_grid(const std::string& state, const std::string& grid, int minute) const {
    if (adds_up_ && !has(state)) return sum_of_groups(state, grid, minute);
    return find_hour(tables_of(state).tables.grids, grid, minute, state, "grid");
}

}  // namespace year
