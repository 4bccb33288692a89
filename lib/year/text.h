// SPDX-License-Identifier: BSD-3-Clause
// A year in five lines, of views or of grids, or as a row of a table.
#pragma once
#include <string>
#include <vector>

#include "report/table.h"
#include "year/autonomy.h"

namespace year {

std::string count_text(const Bounded& n);        // "1203 (1190 to 1216)"
std::string percent_text(const Bounded& share);  // "62.1 % (60.2 to 64.0)"

// The command with an option more: behind its first word, since options come before scenes; at the end of "ptrace ...".
std::string with_option(const std::string& command, const std::string& option);

// Five lines a view, under its name where it has one, and a last one for several.  command: what shows a view's hour
// once it has -hours NAME.
std::string summary(const std::vector<View>& views, const std::vector<Verdict>& verdicts, const std::string& command);

// Of a year whose hours are not all there: the command that renders the others.  Else empty.
std::string rest_line(size_t to_come, const std::string& command, const std::vector<std::string>& tables);

report::Line line_of(const Verdict& verdict);

// A line for each: DGP, the view, the command that shows it.
std::string worst_lines(const std::vector<View>& views, size_t n, const std::string& command);

std::string summary(const GridYear& year, const Goals& goals);
report::Line line_of(const GridYear& year);
report::Line line_of(const GridYear& year, size_t sensor);

}  // namespace year
