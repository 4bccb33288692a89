// SPDX-License-Identifier: BSD-3-Clause
// See months.h.
#include "year/months.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace year {
namespace {

template <class Year>
std::vector<int> months_in(const Year& year) {
    std::set<int> months;
    for (const auto& h : year.hours) months.insert(h.time.date.month);
    return {months.begin(), months.end()};
}

template <class Year>
Year hours_of_month(const Year& year, int month) {
    Year out;
    out.name = year.name, out.shared = year.shared;
    std::copy_if(year.hours.begin(), year.hours.end(), std::back_inserter(out.hours),
                 [&](const auto& h) { return h.time.date.month == month; });
    return out;
}

}  // namespace

std::vector<int> months_of(const View& view) { return months_in(view); }
std::vector<int> months_of(const Grid& grid) { return months_in(grid); }

View of_month(const View& view, int month) { return hours_of_month(view, month); }

Grid of_month(const Grid& grid, int month) {
    Grid out = hours_of_month(grid, month);
    out.strata = grid.strata;
    return out;
}

report::Line with_month(const report::Line& line, int month) {
    const char* const names[12] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    report::Line out;
    report::add(out, "month", report::text_cell(names[month - 1]));
    for (size_t i = 0; i < line.cells.size(); ++i) report::add(out, line.names[i], line.cells[i]);
    return out;
}

}  // namespace year
