// SPDX-License-Identifier: BSD-3-Clause
// Rules by which shades close, as text: one a line or between semicolons, "#" begins a comment.
//     glare .40                                  the most open state whose DGP is at most .40 in all views
//     glare .40 at desk1,desk2 until .35         of these views; once closed it opens at .35
//     sun 2% 1000 until morning                  in which at most 2 % of the sensors have 1000 lx of direct sun
//     sun 0% 150W at facade weather site.epw     in which no sensor on the facade has 150 W/m2 of direct sun
//     schedule shades.tsv                        the state that a file names
//     slats 180 .05 .042 tilts -,0,35 weather site.epw   whose slats keep out the sun
// "south:" in front of a rule: of this group alone.  The most closed state that a rule asks for counts.
#pragma once
#include <string>
#include <vector>

#include "year/slats.h"

namespace year {

struct ShadeRule {
    enum class Kind { glare, sun, schedule, slats };
    Kind kind = Kind::glare;
    std::string group;               // empty: each group
    std::string text;                // as it was written
    double limit = .4;               // DGP
    double until = .4;               // DGP at which it opens again
    double share = .02, lux = 1000;  // of sensors, of direct sun
    double wm2 = 0;                  // in place of lux, by the efficacy of the sun in the weather file; 0: none
    bool until_morning = false;      // once closed it opens with the next day
    std::vector<std::string> at;     // views or grids; empty: all
    std::string file;                // a schedule's, or of the weather
    Slats slats;
    std::vector<std::string> tilts;  // of each state in degrees; "-": no slats
};

// Throws Error (place: the name, and the line of a file) for what is no rule.
std::vector<ShadeRule> parse_shade_rules(const std::string& text, const std::string& name);
// The rules of this file, else the words themselves.
std::vector<ShadeRule> read_shade_rules(const std::string& file_or_words);

}  // namespace year
