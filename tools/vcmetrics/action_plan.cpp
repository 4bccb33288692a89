// SPDX-License-Identifier: BSD-3-Clause
// See action_plan.h.
#include "action_plan.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "glare/actions.h"

using namespace glare;

namespace {

// The settings that matter to its pictures: -i and -I are of luminance, and so are regions but for V.
glare::Plan plan_of_kind(const std::string& kind, glare::Plan ordinary) {
    ordinary.settings.external_ev.reset();
    if (kind == illuminance_by_V) return ordinary;
    ordinary.regions.reset(), ordinary.draw = {}, ordinary.settings.task_region.clear();
    return ordinary;
}

// A kind as it is planned.
struct Kind {
    std::string name;
    glare::Plan measured;
    std::vector<Column> columns;
    // Adds the columns that a name of ordinary ones stands for: their places.
    std::vector<size_t> add(const std::string& metric, ColumnChoice choice) {
        choice.names = {metric}, choice.hidden.clear();
        Requirements required = 0;
        std::vector<size_t> places;
        for (Column& c : choose_columns(choice, measured.settings, required)) {
            places.push_back(columns.size());
            columns.push_back(std::move(c));
        }
        measured.requirements |= required;
        return places;
    }
};

size_t kind_in(std::vector<Kind>& all, const std::string& name, const glare::Plan& ordinary) {
    const auto there = std::find_if(all.begin(), all.end(), [&](const Kind& k) { return k.name == name; });
    if (there != all.end()) return size_t(there - all.begin());
    all.push_back({name, plan_of_kind(name, ordinary), {}});
    all.back().measured.requirements = 0;
    return all.size() - 1;
}

}  // namespace

bool ActionPlan::has_ratio() const {
    return std::any_of(cells.begin(), cells.end(), [](const Cell& c) { return c.ratio; });
}

std::optional<size_t> ActionPlan::kind_of(const image::Header& h) const {
    for (size_t k = 0; h.action && k < kinds.size(); ++k)
        if (kinds[k].name == illuminance_of(*h.action)) return k;
    return std::nullopt;
}

SplitNames split_names(const std::vector<std::string>& names) {
    SplitNames out;
    for (const std::string& n : names) (action_column(n) ? out.of_actions : out.ordinary).push_back(n);
    return out;
}

std::vector<std::string> default_columns_of(const image::Action& action) {
    const std::string illuminance = illuminance_of(action);
    if (illuminance == illuminance_by_V) return {};
    return {illuminance};
}

void require_pictures_of(const std::string& illuminance, const image::Header& h, const std::string& place) {
    const std::string is = h.action ? illuminance_of(*h.action) : "";
    if (is == illuminance || (illuminance.empty() && is == illuminance_by_V)) return;
    if (is.empty()) base::fail(place, "is no picture of an action, as -metrics " + illuminance + " needs");
    base::fail(place,
               "is of action " + h.action->name + ", in which only " + is + " is measured (-metrics " + is + ")");
}

ActionPlan plan_actions(const std::vector<std::string>& names, const glare::Plan& ordinary,
                        const ColumnChoice& choice) {
    std::vector<Kind> kinds;
    ActionPlan out;
    const auto cell = [&](const ActionColumn& asked, size_t kind, size_t place) {
        Column column = kinds[kind].columns[place];
        column.name = asked.metric == "Ev" ? asked.name : column.name + "V";
        column.value = [](const Measurement&) { return std::nan(""); };  // of an ordinary picture
        return ActionPlan::Cell{std::move(column), kind, place, asked.ratio};
    };
    for (const std::string& name : names) {
        const ActionColumn asked = *action_column(name);
        const size_t kind = kind_in(kinds, asked.action, ordinary);
        for (const size_t place : kinds[kind].add(asked.metric, choice)) out.cells.push_back(cell(asked, kind, place));
    }
    if (out.has_ratio()) {
        const ActionColumn asked = *action_column(illuminance_by_V);
        const size_t kind = kind_in(kinds, asked.action, ordinary);
        out.by_V = cell(asked, kind, kinds[kind].add(asked.metric, choice)[0]);
    }
    for (Kind& k : kinds) out.kinds.push_back({k.name, make_plan(std::move(k.measured)), std::move(k.columns)});
    return out;
}
