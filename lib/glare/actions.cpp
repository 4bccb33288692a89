// SPDX-License-Identifier: BSD-3-Clause
// See actions.h.
#include "glare/actions.h"

#include "base/error.h"
#include "base/split.h"
#include "glare/columns.h"

namespace glare {
namespace {

const std::string of_user = "E_";

// "desk.meanV".
bool is_of_region_by_V(const std::string& name) {
    for (const char* const number : {".meanV", ".medianV", ".minV", ".maxV"})
        if (base::ends_with(name, number)) return true;
    return false;
}

// Regions, sets of pixels and pairs are not known here: their names have a dot.
bool may_be_column(const std::string& name) {
    ColumnChoice choice;
    choice.names = {name}, choice.pairs_come = choice.regions_come = true;
    Requirements ignored;
    if (name.find('.') != std::string::npos) return !is_of_region_by_V(name);
    try {
        choose_columns(choice, {}, ignored);
        return true;
    } catch (const base::Error&) {
        return false;
    }
}

}  // namespace

std::optional<ActionColumn> action_column(const std::string& name) {
    for (const auto& [action, symbol] : alpha_opic) {
        const std::string edi = symbol + std::string("EDI");
        if (name == edi) return ActionColumn{name, edi, "Ev", false};
        if (name == symbol + std::string("DER")) return ActionColumn{name, edi, "Ev", true};
    }
    if (base::begins_with(name, of_user) && name.size() > of_user.size()) return ActionColumn{name, name, "Ev", false};
    if (name.size() < 2 || name.back() != 'V' || may_be_column(name)) return std::nullopt;
    const std::string metric = name.substr(0, name.size() - 1);
    if (!may_be_column(metric)) return std::nullopt;
    return ActionColumn{name, illuminance_by_V, metric, false};
}

std::string illuminance_of(const image::Action& a) {
    if (a.unit == "lx" && a.name == "V") return illuminance_by_V;
    for (const auto& [action, symbol] : alpha_opic)
        if (a.unit == "lx" && a.name == action) return symbol + std::string("EDI");
    return of_user + a.name;
}

std::string command_for(const std::string& illuminance) {
    std::string action = illuminance == illuminance_by_V ? "V" : illuminance.substr(of_user.size());
    for (const auto& [name, symbol] : alpha_opic)
        if (illuminance == symbol + std::string("EDI")) action = name;
    return "ptrace -action " + action;
}

std::string action_column_names() {
    std::string out;
    for (const auto& a : alpha_opic) out += a.symbol + std::string("EDI ");
    for (const auto& a : alpha_opic) out += a.symbol + std::string("DER ");
    return out + "EvV";
}

}  // namespace glare
