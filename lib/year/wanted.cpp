// SPDX-License-Identifier: BSD-3-Clause
// See wanted.h.
#include "year/wanted.h"

#include <algorithm>

#include "base/error.h"
#include "base/number.h"

namespace year {

void Wanted::add(int minute, const std::string& cell, const std::string& place) {
    if (cell.empty() || cell == "-") {
        others_.insert(minute);
        return;
    }
    const size_t slash = cell.find('/');
    long long k = 0, n = 0;
    if (slash == std::string::npos || !base::parse_integer(cell.substr(0, slash), k) ||
        !base::parse_integer(cell.substr(slash + 1), n) || k < 1 || k > n || n > 366 * 1440)
        base::fail(place, "\"" + cell + "\" does not say which of how many hours a row is of (3/2600)");
    runs_[n][k].insert(minute);
    counted_.insert(minute);
}

size_t Wanted::missing() const {
    size_t missing = 0;
    for (const auto& [n, hours] : runs_) {
        size_t runs = 1, there = 0;
        for (const auto& [k, minutes] : hours) runs = std::max(runs, minutes.size()), there += minutes.size();
        missing += runs * size_t(n) - there;
    }
    const auto is_new = [&](int minute) { return counted_.count(minute) == 0; };
    const size_t found = size_t(std::count_if(others_.begin(), others_.end(), is_new));
    return missing > found ? missing - found : 0;
}

}  // namespace year
