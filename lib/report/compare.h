// SPDX-License-Identifier: BSD-3-Clause
// Two tables of metrics side by side: what a build server asks after each change.
#pragma once
#include <string>
#include <vector>
#include "report/number_table.h"
#include "report/until.h"

namespace report {

// The default tolerance of -compare, or the one in `rules` ("DGP 0.01, Ev 1%"; "all 1%" for every metric).
// A share refers to the larger of the two values.
Tolerance tolerance_for(const std::string& metric, const std::vector<Tolerance>& rules);

// Throws Error on a rule for a metric that is none of these, so that a typing error does not pass as a wide tolerance.
void require_known(const std::vector<Tolerance>& rules, const std::vector<std::string>& names);

// The table with these metrics alone, in their order; throws Error if it lacks one.
NumberTable only(const NumberTable& table, const std::vector<std::string>& metrics);

struct Difference {
    std::string row;  // its name, or its number from 1
    std::string metric;
    double first, second;
    Tolerance tolerance;
    bool within;
};
// Rows that have names on both sides (the picture's file, its view, its frame) are paired by them, others by their
// order, and so are two single rows.  Throws Error if one side lacks a metric or a row of the other.
std::vector<Difference> compare_tables(const NumberTable& first, const NumberTable& second,
                                       const std::vector<Tolerance>& rules);

}  // namespace report
