// SPDX-License-Identifier: BSD-3-Clause
// See shade_text.h.
#include "year/shade_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace year {
namespace {

bool may_be(const ShadeChoice& c, size_t state) { return (c.may >> state & 1) != 0; }

// The fewest moves (side -1), or the most, through the states that hours may have.
double moves(const std::vector<ShadeChoice>& hours, size_t states, double side) {
    constexpr double never = 1e9;
    std::vector<double> cost(states, 0);  // of the ways that end in each state
    for (size_t i = 0; i < hours.size(); ++i) {
        std::vector<double> next(states, -side * never);
        for (size_t s = 0; s < states; ++s) {
            if (!may_be(hours[i], s)) continue;
            if (i == 0) next[s] = 0;
            for (size_t from = 0; i > 0 && from < states; ++from) {
                if (!may_be(hours[i - 1], from)) continue;
                const double n = cost[from] + double(from != s);
                if (side * n > side * next[s]) next[s] = n;
            }
        }
        cost = std::move(next);
    }
    return side < 0 ? *std::min_element(cost.begin(), cost.end()) : *std::max_element(cost.begin(), cost.end());
}

// All that it may be.
std::string states_of(const ShadeGroup& group, const ShadeChoice& c, const char* between) {
    std::string text;
    for (size_t s = 0; s < group.states.size(); ++s)
        if (may_be(c, s)) text += (text.empty() ? "" : between) + group.states[s];
    return text;
}

std::string name_of(const GroupYear& g) { return g.name.empty() ? "" : g.name + ": "; }

}  // namespace

std::string number_words(const Bounded& n) {
    return n.low == n.high ? fmt::format("{:.0f}", n.value)
                           : fmt::format("{:.0f} ({:.0f} to {:.0f})", n.value, n.low, n.high);
}

std::string share_words(const Bounded& n, size_t all) {
    const double percent = 100 / double(all);
    std::string text = fmt::format("{:.1f} %", percent * n.value);
    if (n.low < n.high) text += fmt::format(" ({:.1f} to {:.1f})", percent * n.low, percent * n.high);
    return text;
}

static std::string which_words(const ShadeRule& r, const char* all) {
    std::string text;
    for (const std::string& name : r.at) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? all : text;
}

std::string rule_words(const ShadeRule& r) {
    std::string text;
    switch (r.kind) {
    case ShadeRule::Kind::glare:
        text = fmt::format("the most open state in which the DGP of {} is at most {:g}; the last one where none is",
                           which_words(r, "all views"), r.limit);
        if (r.until < r.limit) text += fmt::format("; closed shades open again at {:g}", r.until);
        break;
    case ShadeRule::Kind::sun:
        text = fmt::format("the most open state in which at most {:g} % of the sensors of {} have {} of direct sun",
                           100 * r.share, which_words(r, "all grids"),
                           r.wm2 > 0 ? fmt::format("{:g} W/m2", r.wm2) : fmt::format("{:g} lx", r.lux));
        break;
    case ShadeRule::Kind::schedule: text = "the state that the file " + r.file + " names for the hour"; break;
    case ShadeRule::Kind::slats:
        text = fmt::format(
            "the most open state whose slats, {:g} wide and {:g} apart, keep out the sun of {}; the "
            "facade looks to {:g}°",
            r.slats.width, r.slats.spacing, r.file, r.slats.facade_deg);
        break;
    }
    if (r.until_morning) text += "; closed shades stay so until the morning";
    return (r.group.empty() ? "" : r.group + ": ") + text;
}

std::vector<GroupYear> group_years(const ShadeYear& year) {
    std::vector<GroupYear> all;
    for (size_t g = 0; g < year.groups.size(); ++g) {
        const std::vector<ShadeChoice>& hours = year.of_group[g];
        const size_t states = year.groups[g].states.size();
        GroupYear y{year.groups[g].name, year.groups[g].states, std::vector<Bounded>(states), {}, {}, hours.size(), 0};
        y.closed_by.resize(year.rules.size());
        for (size_t i = 0; i < hours.size(); ++i) {
            const ShadeChoice& c = hours[i];
            for (size_t s = 0; s < states; ++s)
                if (may_be(c, s)) y.hours[s].high += 1, y.hours[s].low += c.sure(), y.hours[s].value += c.best == s;
            y.doubtful += !c.sure();
            if (c.rule) ++y.closed_by[*c.rule];
            y.moves.value += i > 0 && c.best != hours[i - 1].best;
        }
        if (!hours.empty()) y.moves.low = moves(hours, states, -1), y.moves.high = moves(hours, states, 1);
        all.push_back(std::move(y));
    }
    return all;
}

std::string shade_lines(const std::vector<GroupYear>& groups, const std::vector<ShadeRule>& rules) {
    std::string text;
    for (const GroupYear& g : groups) {
        std::string states, why;
        for (size_t s = 0; s < g.states.size(); ++s)
            states += fmt::format("{}{} {}", s ? ", " : "", g.states[s], share_words(g.hours[s], g.all));
        for (size_t r = 0; r < rules.size(); ++r)
            if (rules[r].group.empty() || rules[r].group == g.name)
                why += fmt::format("{}{} in {} hours", why.empty() ? "" : ", ", rules[r].text, g.closed_by[r]);
        text += fmt::format("shades    {}{} of the hours\n", name_of(g), states);
        text += fmt::format("moves     {}{}, {} hours in doubt\n", name_of(g), number_words(g.moves), g.doubtful);
        text += fmt::format("why       {}{}\n", name_of(g), why.empty() ? "no rule" : why);
    }
    return text;
}

void add_shades(report::Line& line, const std::vector<GroupYear>& groups) {
    for (const GroupYear& g : groups) {
        const std::string group = g.name.empty() ? "" : g.name + "/";
        for (size_t s = 0; s < g.states.size(); ++s)
            report::add_bounds(line, group + g.states[s], g.hours[s].value, g.hours[s].low, g.hours[s].high);
        report::add_bounds(line, group + "moves", g.moves.value, g.moves.low, g.moves.high);
    }
}

std::string shade_words(const ShadeYear& year, size_t hour, size_t group) {
    const ShadeGroup& g = year.groups[group];
    const ShadeChoice& c = year.of_group[group][hour];
    return (g.name.empty() ? "shades" : g.name) + " " + g.states[c.best] +
           (c.rule ? ": " + year.rules[*c.rule].text : "") +
           (c.sure() ? "" : " (may be " + states_of(g, c, " or ") + ")");
}

std::string shade_words(const ShadeYear& year, size_t hour) {
    std::string text;
    for (size_t g = 0; g < year.groups.size(); ++g) text += (g ? "; " : "") + shade_words(year, hour, g);
    return text;
}

std::string moves_table(const ShadeYear& year) {
    std::string text = "sky\tgroup\tstate\tmay\trule\n";
    for (size_t i = 0; i < year.hours.size(); ++i)
        for (size_t g = 0; g < year.groups.size(); ++g) {
            const ShadeGroup& group = year.groups[g];
            const ShadeChoice& c = year.of_group[g][i];
            text += fmt::format("{}\t{}\t{}\t{}\t{}\n", weather::name_of(year.hours[i]),
                                group.name.empty() ? "-" : group.name, group.states[c.best], states_of(group, c, ","),
                                c.rule ? year.rules[*c.rule].text : "-");
        }
    return text;
}

}  // namespace year
