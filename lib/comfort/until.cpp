// SPDX-License-Identifier: BSD-3-Clause
// Reads a rule and looks at the last lines (until.h).
#include "comfort/until.h"
#include <cmath>
#include <sstream>
#include "base/error.h"
#include "base/number.h"

namespace comfort {

std::vector<Tolerance> parse_tolerances(const std::string& rule, const std::string& place) {
    std::vector<Tolerance> out;
    std::istringstream parts(rule);
    for (std::string part; std::getline(parts, part, ',');) {
        std::istringstream words(part);
        Tolerance t;
        std::string amount, more;
        if (words >> t.metric && t.metric == "class")
            base::fail(place, "class takes no tolerance, and cannot be used with -window or -compare");
        if (!(words >> amount))
            base::fail(place, "\"" + part + "\" is not a rule; write for example 'DGP 1%, Ev 0.5%'");
        if (words >> more && more == "%") amount += more, more.clear();
        t.relative = amount.back() == '%';
        if (t.relative) amount.pop_back();
        if (!more.empty() || !base::parse_real(amount, t.amount) || t.amount < 0)
            base::fail(place, "\"" + part + "\" has no tolerance such as 1% or 0.01");
        if (t.relative) t.amount /= 100;
        out.push_back(t);
    }
    if (out.empty()) base::fail(place, "the rule is empty; write for example 'DGP 1%, Ev 0.5%'");
    return out;
}

StoppingRule::StoppingRule(std::vector<Tolerance> tolerances, int window)
    : tolerances_(std::move(tolerances)), window_(size_t(window)) {
    if (window < 2) base::fail("-window", "a window must have at least two lines");
}

void StoppingRule::add(const std::vector<double>& values) {
    lines_.push_back(values);
    if (lines_.size() > window_) lines_.pop_front();
}

bool StoppingRule::holds() const {
    if (lines_.size() < window_) return false;
    for (size_t k = 0; k < tolerances_.size(); ++k) {
        double mean = 0;
        for (const auto& line : lines_) mean += line[k] / double(lines_.size());
        const double limit =
            tolerances_[k].amount * (tolerances_[k].relative ? std::fabs(mean) : 1) + 1e-12 * std::fabs(mean);
        for (const auto& line : lines_)
            if (!(std::fabs(line[k] - mean) <= limit)) return false;  // a nan never settles
    }
    return true;
}

}  // namespace comfort
