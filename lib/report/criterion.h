// SPDX-License-Identifier: BSD-3-Clause
// A limit for a number, by which a report judges it: "EN 17037 medium: DGPf <= 0.40", "UGRf <= 19",
// "floor.mean >= 500".
#pragma once
#include <string>

namespace report {

struct Criterion {
    std::string name, metric;  // name: empty if it has none
    bool at_most = true;       // else at least
    double limit = 0;
};

// Throws Error (place) for what is none.
Criterion parse_criterion(const std::string& text, const std::string& place);

// "met", "not met", "undecided" where the interval holds the limit, "not known" without a value.  low, high: nan where
// there is no interval; then the value decides.
const char* judged(const Criterion& criterion, double value, double low, double high);

}  // namespace report
