// SPDX-License-Identifier: BSD-3-Clause
// See shaded.h.
#include "shaded.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "image/stream.h"
#include "image/stream_parts.h"
#include "year/shades.h"

namespace {

using States = std::vector<year::StateTables>;

void choose_view(const std::string& name, States& states) {
    if (name.empty()) return;
    for (auto& [state, tables] : states) {
        std::vector<year::View>& views = tables.views;
        if (!tables.grids.empty()) continue;
        views.erase(std::remove_if(views.begin(), views.end(), [&](const year::View& v) { return v.name != name; }),
                    views.end());
        if (views.empty()) base::fail("-view", "no view is called \"" + name + "\"");
    }
}

void choose_state(const std::string& name, States& states) {
    if (name.empty()) return;
    std::string known;
    for (const year::StateTables& s : states) known += (known.empty() ? "" : ", ") + s.state;
    states.erase(std::remove_if(states.begin(), states.end(), [&](const auto& s) { return s.state != name; }),
                 states.end());
    if (states.empty()) base::fail("-state", "no state is called \"" + name + "\"; there are " + known);
}

// -closed: a second state beside the first one.
void add_closed(const Options& o, States& states) {
    if (o.closed.empty()) return;
    if (states.size() != 1) base::fail("-closed", "is a second state beside a table of one");
    if (states[0].state.empty()) states[0].state = "open";
    states.push_back({"closed", year::read_tables(o.closed)});
}

// -by: beside -closed a table without states is that of open shades.
States read_by(const Options& o, const std::string& open) {
    States by = year::read_states(o.by);
    if (!o.closed.empty() && by.size() == 1 && by[0].state.empty()) by[0].state = open;
    return by;
}

std::vector<year::ShadeRule> rules_of(const Options& o) {
    if (!o.shades.empty()) return year::read_shade_rules(o.shades);
    return year::parse_shade_rules(fmt::format("glare {:g}", o.close_dgp), "-close");
}

// mEDI of sensors and of views, which are single sensors there; none where a state lacks it.
std::vector<year::Grid> edi_with_shades(std::vector<year::Grid> open, States states, const year::ShadeYear& shades) {
    for (year::StateTables& s : states) {
        if (s.tables.edi.size() != open.size()) return {};
        s.tables.grids = s.tables.edi;
    }
    return open.empty() ? open : year::with_shades(std::move(open), year::ShadeStates(std::move(states)), shades);
}

}  // namespace

Counted read_counted(const Options& o) {
    States states = year::read_states(o.tables);
    choose_state(o.state, states);
    choose_view(o.view, states);
    add_closed(o, states);
    Counted c;
    if (o.closed.empty() && o.shades.empty()) {
        if (states.size() > 1)
            base::fail(o.tables.front(), fmt::format("has states \"{}\" and \"{}\": -shades says which hour has which, "
                                                     "-state names one",
                                                     states[0].state, states[1].state));
        c.tables = std::move(states[0].tables);
        if (!o.direct.empty()) c.direct = year::read_tables(o.direct).grids;
        return c;
    }
    if (states.size() < 2) base::fail("-shades", "the tables have one state (ptrace -state)");
    const year::ShadeStates counted(std::move(states));
    std::optional<year::ShadeStates> direct, by;
    if (!o.direct.empty()) direct.emplace(year::read_states(o.direct));
    if (!o.by.empty()) by.emplace(read_by(o, counted.all().front().state));
    const year::ShadeSources sources{by ? &*by : &counted, direct ? &*direct : nullptr};
    c.shades = year::control(counted, sources, rules_of(o));
    c.groups = year::group_years(*c.shades);
    c.tables = counted.open();
    c.tables.edi = edi_with_shades(std::move(c.tables.edi), counted.all(), *c.shades);
    c.tables.views = year::with_shades(std::move(c.tables.views), counted, *c.shades);
    c.tables.grids = year::with_shades(std::move(c.tables.grids), counted, *c.shades);
    if (direct) c.direct = direct->open().grids;
    if (!o.moves.empty()) image::write_bytes(o.moves, year::moves_table(*c.shades));
    return c;
}
