// SPDX-License-Identifier: BSD-3-Clause
// Lines of named numbers as text: tab separated (default), comma separated, or one JSON object a line.
#pragma once
#include <string>
#include <vector>

namespace report {

enum class TableFormat { tsv, csv, jsonl };

struct Cell {
    std::string text;  // as it shall be printed
    bool number = true;
};
Cell number_cell(double value, int digits = 8);  // significant digits; nan and inf by name (null in JSON)
Cell text_cell(const std::string& text);

std::string header_line(const std::vector<std::string>& names,
                        TableFormat format);  // empty for JSON; else with newline
std::string table_line(const std::vector<std::string>& names, const std::vector<Cell>& cells, TableFormat format);

}  // namespace report
