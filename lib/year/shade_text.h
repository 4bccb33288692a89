// SPDX-License-Identifier: BSD-3-Clause
// What a year of moving shades comes to: in how many hours a group has each state, how often it moves, and why.
#pragma once
#include <string>
#include <vector>

#include "report/table.h"
#include "year/shade_control.h"
#include "year/verdict.h"

namespace year {

struct GroupYear {
    std::string name;
    std::vector<std::string> states;
    std::vector<Bounded> hours;     // in each state
    Bounded moves;                  // from one hour to the next
    std::vector<size_t> closed_by;  // hours, of each rule
    size_t all = 0, doubtful = 0;   // hours
};

std::vector<GroupYear> group_years(const ShadeYear& year);

std::string number_words(const Bounded& n);             // "731 (655 to 790)"
std::string share_words(const Bounded& n, size_t all);  // "61.2 % (60.3 to 62.5)"
std::string rule_words(const ShadeRule& rule);          // a sentence

// "shades    south: open 71.2 % ..."; three lines a group.
std::string shade_lines(const std::vector<GroupYear>& groups, const std::vector<ShadeRule>& rules);
void add_shades(report::Line& line, const std::vector<GroupYear>& groups);

// "shades half: glare .40 (may be open or half)"; of several groups "south half: glare .40; west open".
std::string shade_words(const ShadeYear& year, size_t hour);
std::string shade_words(const ShadeYear& year, size_t hour, size_t group);

// A row for each hour and group: its state, the states that it may have, the rule that closes it.
std::string moves_table(const ShadeYear& year);

}  // namespace year
