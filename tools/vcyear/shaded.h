// SPDX-License-Identifier: BSD-3-Clause
// The tables that vcyear counts: those of the only state, or the hours as they are in the states that shades have.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "year/shade_control.h"
#include "year/shade_text.h"

struct Counted {
    year::Tables tables;
    std::vector<year::Grid> direct;  // -direct: under direct sun alone, with open shades
    std::optional<year::ShadeYear> shades;
    std::vector<year::GroupYear> groups;  // of shades

    std::string shade_lines() const { return shades ? year::shade_lines(groups, shades->rules) : ""; }
};

// Reads all tables and writes -moves.
Counted read_counted(const Options& options);
