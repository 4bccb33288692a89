// SPDX-License-Identifier: BSD-3-Clause
// When numbers are certain enough to stop: 'DGP 0.01, Ev 1%' means half the width of their 95 % intervals.
//
// Looking again and again until an interval happens to be narrow makes it miss more often than 5 %.  A rule on widths
// alone never looks at the value, so that little is lost (Chow and Robbins 1965; Glynn and Whitt 1992 for simulations),
// and that little goes with few looks, a whole block of the sampler at least, and the widest interval of the last
// looks.
//
// "class" is another matter: whether DGP lies inside one class depends on its value, and one look too many finds it by
// luck.  So look k may be wrong with probability 0.05/(k (k + 1)), which sum to 0.05 over all looks there can be.
#pragma once
#include <string>
#include <vector>
#include "comfort/certainty.h"
#include "comfort/until.h"

namespace comfort {

class PrecisionRule {
public:
    static constexpr double outside = 0.05;
    static constexpr int64_t least_frames = 64;

    // 'DGP 0.01, Ev 1%' and the word "class" as one of them.  Throws Error (place -until).
    explicit PrecisionRule(const std::string& rule);
    const std::vector<Tolerance>& tolerances() const { return tolerances_; }
    bool asks_class() const { return class_; }
    // At a look; estimates in the order of tolerances(), DGP's for the class.
    bool holds(int look, int64_t frames, const std::vector<Estimate>& estimates, const Estimate& dgp) const;
    // What the numbers are known to, after it held: "DGP 0.3607 +- 0.0021, class perceptible".
    std::string reason(const std::vector<Estimate>& estimates, const Estimate& dgp) const;

private:
    std::vector<Tolerance> tolerances_;
    bool class_ = false;
};

}  // namespace comfort
