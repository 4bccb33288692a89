// SPDX-License-Identifier: BSD-3-Clause
// Rules such as 'DGP 0.01, Ev 1%, class': tolerances of -until and -compare.
#pragma once
#include <string>
#include <vector>
#include "uncertainty/estimate.h"

namespace report {

struct Tolerance {
    std::string metric;
    double amount = 0;
    bool relative = false;  // amount is a fraction of the value
};

// Throws Error on a rule that cannot be read; place: which option, or which line of which file, says it.
std::vector<Tolerance> parse_tolerances(const std::string& rule, const std::string& place);

// -until: half the widths of 95 % intervals, and the word "class", that of DGP (uncertainty/stopping.h).
class UntilRule {
public:
    explicit UntilRule(const std::string& rule);  // throws Error (place -until)
    const std::vector<Tolerance>& tolerances() const { return tolerances_; }
    bool asks_class() const { return class_; }
    // At a look; estimates in the order of tolerances(), DGP's for the class.
    bool holds(const std::vector<uncertainty::Estimate>& estimates, const uncertainty::Estimate& dgp) const;
    // After it held: "DGP 0.3607 +- 0.0021, glare is perceptible".
    std::string reason(const std::vector<uncertainty::Estimate>& estimates, const uncertainty::Estimate& dgp) const;

private:
    std::vector<Tolerance> tolerances_;
    bool class_ = false;
};

}  // namespace report
