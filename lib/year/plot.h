// SPDX-License-Identifier: BSD-3-Clause
// The heat map of a year: days from the left to the right, hours from the top down, the colour by DGP; hours whose
// interval holds a limit are hatched.  Below them the states of shades that move, of each group.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "year/shade_control.h"
#include "year/verdict.h"

namespace year {

// One map below the other; the ending of the name says whether it is .svg or .png.
void write_plot(const std::string& path, const std::vector<View>& views, double alpha,
                const ShadeYear* shades = nullptr);

// "21 Jun, 14:30".
std::string time_words(const weather::Time& time);
// "21 Jun, 14:30: DGP 0.362 (0.361 to 0.363); shades half: glare .40".
std::string words_of(const Hour& hour);

// The same as SVG in which each hour says its DGP and is a link.
using LinkOf = std::function<std::string(size_t view, const Hour& hour)>;
std::string plot_text(const std::vector<View>& views, double alpha, const ShadeYear* shades, const LinkOf& link);

}  // namespace year
