// SPDX-License-Identifier: BSD-3-Clause
// Widths against what was asked for (precision.h).
#include "comfort/precision.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "base/error.h"

namespace comfort {
namespace {

bool narrow_enough(const Tolerance& t, const Estimate& e) {
    const double limit = t.amount * (t.relative ? std::fabs(e.value) : 1);
    return !e.tails && e.half_width(PrecisionRule::outside, e.frames) <= limit;  // a nan is not
}

bool inside_one_class(const Estimate& e, int look) {
    const Interval off = e.around(PrecisionRule::outside / (double(look) * (look + 1)), e.frames);
    return std::isfinite(off.half_width()) && dgp_class(e.value + off.low) == dgp_class(e.value + off.high);
}

}  // namespace

PrecisionRule::PrecisionRule(const std::string& rule) {
    std::string others;
    std::istringstream parts(rule);
    for (std::string part; std::getline(parts, part, ',');) {
        std::istringstream words(part);
        std::string word, more;
        if (words >> word && word == "class" && !(words >> more)) class_ = true;
        else others += (others.empty() ? "" : ",") + part;
    }
    if (!others.empty() || !class_) tolerances_ = parse_tolerances(others);
}

bool PrecisionRule::holds(int look, int64_t frames, const std::vector<Estimate>& estimates, const Estimate& dgp) const {
    bool all = frames >= least_frames;
    for (size_t k = 0; k < tolerances_.size(); ++k) all = all && narrow_enough(tolerances_[k], estimates[k]);
    return all && (!class_ || inside_one_class(dgp, look));
}

std::string PrecisionRule::reason(const std::vector<Estimate>& estimates, const Estimate& dgp) const {
    std::string out;
    for (size_t k = 0; k < tolerances_.size(); ++k)
        out += fmt::format("{}{} {:.4g} +- {:.2g}", out.empty() ? "" : ", ", tolerances_[k].metric, estimates[k].value,
                           estimates[k].half_width(outside, estimates[k].frames));
    if (class_) out += fmt::format("{}glare is {}", out.empty() ? "" : ", ", dgp_classes[dgp_class(dgp.value)]);
    return out;
}

}  // namespace comfort
