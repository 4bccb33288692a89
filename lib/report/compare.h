// SPDX-License-Identifier: BSD-3-Clause
// Two tables of metrics side by side: what a build server asks after each change.
#pragma once
#include <string>
#include <vector>
#include "report/number_table.h"
#include "report/until.h"

namespace report {

// The tolerance of the metric's row, or the last one in `rules` ("DGP 0.01, Ev 1%"; "all 1%" for every metric).
Tolerance tolerance_for(const std::string& metric, const std::vector<Tolerance>& rules);

// A share refers to the larger of the two values.
bool within(const Tolerance& tolerance, double first, double second);

// The table with these metrics alone, in their order; throws Error if it lacks one of them, which `whose` has.
NumberTable only(const NumberTable& table, const std::vector<std::string>& metrics, const std::string& whose);

// The row of `second` for each row of `first`.  Rows that have names on both sides (the picture's file, its view, its
// frame) are paired by them, others by their order, and so are two single rows.  Throws Error if one side lacks a row.
std::vector<size_t> pair_rows(const NumberTable& first, const NumberTable& second);

}  // namespace report
