// SPDX-License-Identifier: BSD-3-Clause
// Rules such as 'DGP 0.01, Ev 1% or 0.1, class': tolerances of -until and -tolerance.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "uncertainty/estimate.h"

namespace report {

// The wider of an amount and a share of the value.
struct Tolerance {
    std::string metric;
    double amount = 0, share = 0;
    double of(double value) const;
    std::string text() const;  // "1% or 0.1"
};

// Throws Error on a rule that cannot be read; place: the option, or the file and line, that contains it.
std::vector<Tolerance> parse_tolerances(const std::string& rule, const std::string& place);

// Errors that the size of pixels makes in the metrics of a rule, and in DGP for the class: columns NAME.px.  None: not
// known, or nothing.
struct PixelErrors {
    std::vector<std::optional<uncertainty::Estimate>> of_tolerances;
    std::optional<uncertainty::Estimate> of_class;
};

// -until: half the widths of 95 % intervals, and the words "class" and "classf", those of DGP and DGPf
// (uncertainty/stopping.h).  The errors of noise and of pixels together must be within a tolerance, and must not change
// the class.
class UntilRule {
public:
    explicit UntilRule(const std::string& rule);  // throws Error (place -until)
    const std::vector<Tolerance>& tolerances() const { return tolerances_; }
    const std::string& class_of() const { return class_of_; }  // DGP or DGPf; empty: the class is not asked for
    // At a look; estimates in the order of tolerances(), that of class_of() for the class.
    bool holds(const std::vector<uncertainty::Estimate>& estimates, const uncertainty::Estimate& dgp,
               const PixelErrors& pixels = {}) const;
    // After it held: "DGP 0.3607 +- 0.0021 of noise; at this size it reads 0.0083 low, glare is perceptible".
    std::string reason(const std::vector<uncertainty::Estimate>& estimates, const uncertainty::Estimate& dgp,
                       const PixelErrors& pixels = {}) const;
    // Why no number of frames will do for pictures of this size, and what will; empty: some may.
    std::string out_of_reach(const std::vector<uncertainty::Estimate>& estimates, const uncertainty::Estimate& dgp,
                             const PixelErrors& pixels, int width, int height) const;

private:
    std::vector<Tolerance> tolerances_;
    std::string class_of_;
};

}  // namespace report
