// SPDX-License-Identifier: BSD-3-Clause
// The parts of EN 17037 as lines and as columns of a table.
#pragma once
#include <string>

#include "report/table.h"
#include "year/provision.h"
#include "year/sunlight.h"

namespace year {

std::string level_words(int low, int high);              // "medium"; "undecided, none to minimum"
std::string sun_hours_words(const Bounded& hours);       // "2.08 h (2.00 to 2.17)"
std::string lacks_words(const Provision& p, int level);  // "medium: 500 lx on 41.0 % where 50 % are asked"

// The level and, below high, what lacks to the next one.
std::string lines_of(const Provision& provision);
void add(report::Line& line, const Provision& provision);
void add(report::Line& line, const DaylightShares& sensor);

std::string line_of(const Sunlight& sunlight);
void add(report::Line& line, const Sunlight& sunlight);

}  // namespace year
