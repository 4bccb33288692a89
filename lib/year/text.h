// SPDX-License-Identifier: BSD-3-Clause
// A year in five lines, of views or of grids, or as a row of a table.
#pragma once
#include <string>
#include <vector>

#include "report/table.h"
#include "year/autonomy.h"

namespace year {

// Five lines a view, under its name where it has one, and a last one for several.  command: what shows a view's hour
// once " -hours NAME" stands behind it.
std::string summary(const std::vector<View>& views, const std::vector<Verdict>& verdicts, const std::string& command);

// In how many hours shades are closed.
std::string shades_line(const Between& closed, double limit);

std::vector<std::string> column_names();
std::vector<report::Cell> cells(const Verdict& verdict);

// A line for each: DGP, the view, the command that shows it.
std::string worst_lines(const std::vector<View>& views, size_t n, const std::string& command);

std::string summary(const GridYear& year, const Goals& goals);
std::vector<std::string> grid_column_names();
std::vector<report::Cell> cells(const GridYear& year);
// The columns and rows of single sensors.
std::vector<std::string> sensor_column_names();
std::vector<report::Cell> cells(const GridYear& year, size_t sensor);

}  // namespace year
