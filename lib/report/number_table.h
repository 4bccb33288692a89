// SPDX-License-Identifier: BSD-3-Clause
// A table of metrics as numbers.  Recorded tables are read as vcmetrics wrote them (tsv, csv, jsonl) or as evalglare
// printed them; evalglare's names become ours.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace report {

struct NumberTable {
    std::string name;                       // where it came from
    std::vector<std::string> names;         // metrics
    std::vector<std::string> labels;        // columns that name a row: file, view, sky, grid, point ...
    std::vector<std::string> notes;         // columns of words about a row (errors.h)
    std::vector<std::vector<double>> rows;  // one value for each metric
    std::vector<std::string> row_names;     // one for each row: what its labels say; empty without labels

    void add_row(const std::vector<double>& values, const std::vector<std::string>& label);
};

// Nothing if the file does not look like text of metrics (then it should be pictures); throws Error if it is malformed.
std::optional<NumberTable> read_numbers(const std::string& path);

// A row as it is read: what its metrics, labels and notes say.
struct NumberRow {
    const std::vector<double>& values;
    const std::vector<std::string>&labels, &notes;
};
// The table has the columns' names, and no rows.
using RowUse = std::function<void(const NumberTable& table, const NumberRow& row)>;
// The same for tables too long to keep; false if the file does not look like text of metrics.
bool each_row(const std::string& path, const RowUse& use);

// "office.hdr" of "out/office.hdr": by this a row is known wherever the picture lay when it was measured.
std::string name_in_folder(const std::string& path);

}  // namespace report
