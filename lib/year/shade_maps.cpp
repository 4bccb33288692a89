// SPDX-License-Identifier: BSD-3-Clause
// See shade_maps.h.
#include "year/shade_maps.h"

#include "year/day_cells.h"
#include "year/plot.h"
#include "year/shade_text.h"

namespace year {
namespace {

// From the pale open state to the dark most closed one.
display::Colour colour_of_state(size_t state, size_t states) {
    const display::Colour open{228, 236, 215}, shut{38, 70, 96};
    display::Colour c;
    for (size_t k = 0; k < c.size(); ++k)
        c[k] = uint8_t(open[k] + (int(shut[k]) - int(open[k])) * int(state) / std::max(1, int(states) - 1));
    return c;
}

// Below its heading.
void add_states(display::Canvas& c, const ShadeGroup& group) {
    constexpr int letter = 7, box = 16, gap = 20;
    int x = DayCells::left;
    for (size_t s = 0; s < group.states.size(); ++s) {
        c.of(colour_of_state(s, group.states.size())).push_back({x, c.height, 12, 12});
        c.words.push_back({x + box, c.height, group.states[s]});
        x += box + gap + letter * int(group.states[s].size());
    }
    c.of(colour_of_state(0, 2)).push_back({x, c.height, 12, 12, true});
    c.words.push_back({x + box, c.height, "in doubt"});
}

}  // namespace

void add_shade_maps(display::Canvas& c, const ShadeYear& year) {
    constexpr int heading = 24, bottom = 28;
    const DayCells cells(year.hours);
    for (size_t g = 0; g < year.groups.size(); ++g) {
        const ShadeGroup& group = year.groups[g];
        c.words.push_back({DayCells::left, c.height + 6, "shades" + (group.name.empty() ? "" : " " + group.name)});
        c.height += heading;
        for (size_t i = 0; i < year.hours.size(); ++i) {
            const ShadeChoice& choice = year.of_group[g][i];
            const display::Rectangle r = cells.at(year.hours[i], c.height, !choice.sure());
            c.of(colour_of_state(choice.best, group.states.size())).push_back(r);
            c.spots.push_back({{r}, time_words(year.hours[i]) + ": " + shade_words(year, i, g)});
        }
        cells.add_clock(c, c.height);
        c.height += cells.height() + 6;
        add_states(c, group);
        c.height += bottom;
    }
}

}  // namespace year
