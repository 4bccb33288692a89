// SPDX-License-Identifier: BSD-3-Clause
// Shades that move, on the page of a year (page.h): in how many hours each group has each state, how often it moves,
// and by which rules.
#include <fmt/format.h>

#include "base/printable.h"
#include "year/page.h"
#include "year/shade_text.h"

namespace year {

using base::escaped;

static std::string rules_table(const std::vector<ShadeRule>& rules, const std::vector<GroupYear>& groups) {
    std::string out =
        "<table><thead><tr><th>Rule</th><th class=\"what\">In words</th><th>Closes</th></tr></thead><tbody>\n";
    for (size_t r = 0; r < rules.size(); ++r) {
        std::string closes;
        for (const GroupYear& g : groups)
            if (rules[r].group.empty() || rules[r].group == g.name)
                closes += fmt::format("{}{}{} hours", closes.empty() ? "" : "<br>",
                                      g.name.empty() ? "" : escaped(g.name) + " in ", g.closed_by[r]);
        out += fmt::format("<tr><td><code>{}</code></td><td class=\"what\">{}</td><td>{}</td></tr>\n",
                           escaped(rules[r].text), escaped(rule_words(rules[r])), closes);
    }
    return out + "</tbody></table>\n";
}

std::string shades_section(const Page& page) {
    if (!page.shades) return "";
    const std::vector<GroupYear> groups = group_years(*page.shades);
    std::string out =
        "<h2>Shades that move</h2>\n<table><thead><tr><th>Group</th><th>Share of the hours in each state</th>"
        "<th>Moves</th><th>Hours in doubt</th></tr></thead><tbody>\n";
    for (const GroupYear& g : groups) {
        std::string states;
        for (size_t s = 0; s < g.states.size(); ++s)
            states += fmt::format("{}{} {}", s ? "<br>" : "", escaped(g.states[s]), share_words(g.hours[s], g.all));
        out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                           g.name.empty() ? "all" : escaped(g.name), states, number_words(g.moves), g.doubtful);
    }
    out += "</tbody></table>\n" + rules_table(page.shades->rules, groups);
    return out +
           "<p class=\"note\">Of several rules the most closed state counts; an hour is counted for the rule that asks "
           "for it. Where the interval of a number holds the limit of a rule shades may have either state: such hours "
           "are "
           "in doubt, and in brackets stands what all of them leave open.</p>\n";
}

}  // namespace year
