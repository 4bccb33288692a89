// SPDX-License-Identifier: BSD-3-Clause
// Hours that are to come: rows say which of how many of their run they are ("1817/2600", report/errors.h), so that a
// year that was cut off is known from a whole one.  Rows of hours that were named say nothing: they are some of a year.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace year {

class Wanted {
public:
    // cell: of an hour; "" or "-" where its run does not say.  Throws Error (place).
    void add(int minute_of_year, const std::string& cell, const std::string& place);
    // How many hours are not there yet.
    size_t missing() const;

private:
    // Runs with so many hours: of each number the hours that have it, two of them where there are two such runs.
    std::map<int64_t, std::map<int64_t, std::set<int>>> runs_;
    std::set<int> counted_, others_;
};

}  // namespace year
