// SPDX-License-Identifier: BSD-3-Clause
// A year by months: the hours of one of them, to be counted as a year is.
#pragma once
#include <vector>

#include "report/table.h"
#include "year/table.h"

namespace year {

// Months that have hours, 1 to 12, rising.
std::vector<int> months_of(const View& view);
std::vector<int> months_of(const Grid& grid);

View of_month(const View& view, int month);
Grid of_month(const Grid& grid, int month);

report::Line with_month(const report::Line& line, int month);  // a first column "month": Jan

}  // namespace year
