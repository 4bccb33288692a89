// SPDX-License-Identifier: BSD-3-Clause
// Lines of named numbers as text: tab separated (default), comma separated, one JSON object a line, or for a reader.
#pragma once
#include <string>
#include <vector>

namespace report {

enum class TableFormat {
    tsv,
    csv,
    jsonl,
    aligned,  // as wide as the names, on a terminal
};

struct Cell {
    std::string text;  // as it shall be printed
    bool number = true;
};
Cell number_cell(double value, int digits = 8);  // significant digits; nan and inf by name (null in JSON)
Cell text_cell(const std::string& text);
// As many digits as half an interval leaves meaning, two of its own, without a power of ten; nan or 0: four digits.
std::string rounded(double value, double half_width);
// "2806 +- 17": as many digits as half an interval leaves meaning, two of its own.  nan: four digits alone.
std::string with_error(double value, double half_width);

// Each cell with the name of its column.
struct Line {
    std::vector<std::string> names;
    std::vector<Cell> cells;
};
void add(Line& line, const std::string& name, const Cell& cell);
inline void add(Line& line, const std::string& name, double value) { add(line, name, number_cell(value)); }
void add_bounds(Line& line, const std::string& name, double value, double low, double high);  // NAME, NAME.lo, NAME.hi

std::string header_line(const std::vector<std::string>& names,
                        TableFormat format);  // empty for JSON; else with newline
std::string table_line(const Line& line, TableFormat format);
std::string table(const std::vector<Line>& lines, TableFormat format);  // all have the names of the first one

}  // namespace report
