// SPDX-License-Identifier: BSD-3-Clause
// See until.h.
#include "report/until.h"
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <sstream>
#include "base/error.h"
#include "base/number.h"
#include "glare/columns.h"
#include "uncertainty/stopping.h"

namespace report {

using uncertainty::Estimate;

std::vector<Tolerance> parse_tolerances(const std::string& rule, const std::string& place) {
    std::vector<Tolerance> out;
    std::istringstream parts(rule);
    for (std::string part; std::getline(parts, part, ',');) {
        std::istringstream words(part);
        Tolerance t;
        std::string amount, more;
        if (words >> t.metric && t.metric == "class")
            base::fail(place, "class takes no tolerance, and cannot be used with -compare");
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

UntilRule::UntilRule(const std::string& rule) {
    std::string others;
    std::istringstream parts(rule);
    for (std::string part; std::getline(parts, part, ',');) {
        std::istringstream words(part);
        std::string word, more;
        if (words >> word && word == "class" && !(words >> more)) class_ = true;
        else others += (others.empty() ? "" : ",") + part;
    }
    if (!others.empty() || !class_) tolerances_ = parse_tolerances(others, "-until");
}

bool UntilRule::holds(const std::vector<Estimate>& estimates, const Estimate& dgp) const {
    const auto narrow = [](const Tolerance& t, const Estimate& e) {
        return uncertainty::narrow_enough(e, t.amount * (t.relative ? std::fabs(e.value) : 1));
    };
    return std::equal(tolerances_.begin(), tolerances_.end(), estimates.begin(), narrow) &&
           (!class_ || uncertainty::class_is_known(dgp, glare::dgp_class));
}

std::string UntilRule::reason(const std::vector<Estimate>& estimates, const Estimate& dgp) const {
    std::string out;
    for (size_t k = 0; k < tolerances_.size(); ++k)
        out += fmt::format("{}{} {:.4g} +- {:.2g}", out.empty() ? "" : ", ", tolerances_[k].metric, estimates[k].value,
                           estimates[k].half_width(uncertainty::alpha, estimates[k].frames));
    if (class_)
        out += fmt::format("{}glare is {}", out.empty() ? "" : ", ", glare::dgp_classes[glare::dgp_class(dgp.value)]);
    return out;
}

}  // namespace report
