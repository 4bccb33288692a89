// SPDX-License-Identifier: BSD-3-Clause
// Two tables of metrics side by side: what a build server asks after each change.
// Recorded tables are read as vcmetrics wrote them (tsv, csv, jsonl) or as evalglare printed them; evalglare's names
// become ours.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>
#include "comfort/until.h"

namespace comfort {

struct NumberTable {
    std::string name;                       // where it came from
    std::vector<std::string> names;         // metrics; frame, seconds and file are left out
    std::vector<std::vector<double>> rows;  // one value for each name
};

// Nothing if the file does not look like text of metrics (then it should be pictures); throws Error if it is malformed.
std::optional<NumberTable> read_numbers(const std::string& path);

// The defaults of -compare, then those of `rules` ("DGP 0.01, Ev 1%"; "all 1%" for every metric).
// Relative ones are of the larger of the two values.
Tolerance tolerance_for(const std::string& metric, const std::vector<Tolerance>& rules);

struct Difference {
    size_t row;
    std::string metric;
    double first, second;
    Tolerance tolerance;
    bool within;
};
// Throws Error if one side lacks a metric or a row of the other.
std::vector<Difference> compare_tables(const NumberTable& first, const NumberTable& second,
                                       const std::vector<Tolerance>& rules);

}  // namespace comfort
