// SPDX-License-Identifier: BSD-3-Clause
// See criterion.h.
#include "report/criterion.h"

#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "base/split.h"

namespace report {

Criterion parse_criterion(const std::string& text, const std::string& place) {
    const size_t colon = text.rfind(": ");
    Criterion c;
    if (colon != std::string::npos) c.name = text.substr(0, colon);
    const std::vector<std::string> words =
        base::split_words(colon == std::string::npos ? text : text.substr(colon + 2));
    if (words.size() != 3 || (words[1] != "<=" && words[1] != ">=") || !base::parse_real(words[2], c.limit))
        base::fail(place, "\"" + text + "\" is not like \"EN 17037 medium: DGPf <= 0.40\"");
    c.metric = words[0];
    c.at_most = words[1] == "<=";
    return c;
}

const char* judged(const Criterion& c, double value, double low, double high) {
    if (!std::isfinite(value)) return "not known";
    if (!std::isfinite(low) || !std::isfinite(high)) low = high = value;
    const double best = c.at_most ? low : high, worst = c.at_most ? high : low;
    const auto holds = [&](double v) { return c.at_most ? v <= c.limit : v >= c.limit; };
    return holds(worst) ? "met" : holds(best) ? "undecided" : "not met";
}

}  // namespace report
