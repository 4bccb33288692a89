// SPDX-License-Identifier: BSD-3-Clause
// The results of a year of hours for a view.  Every number has an interval from the noise of its hours and from their
// pixels.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "year/table.h"

namespace year {

// DGP above which glare is perceptible, disturbing, intolerable; the classes of EN 17037 for glare protection ask that
// at most 5 % of the hours of use are above them: high, medium, minimum (J. Wienold et al., Cross-validation and
// robustness of daylight glare metrics, Lighting Research and Technology 51, 2019, name the limits).
constexpr std::array<double, 3> limits{.35, .40, .45};
constexpr double exceeding_share = .05;
int class_of(double dgp);       // how many limits are below it
const char* class_name(int k);  // 0 high, 1 medium, 2 minimum, 3 none

struct Bounded {
    double value = 0, low = 0, high = 0;
};

struct Verdict {
    std::string view;
    size_t hours = 0, dark = 0;
    size_t undecided = 0;          // hours whose interval holds a limit
    size_t missing = 0;            // of these, hours without values
    size_t to_come = 0;            // hours of the run that are not there
    std::array<Bounded, 3> above;  // hours above each limit
    Bounded exceeded;              // DGPe5: at most 5 % of the hours are above it
    int best = 0, worst = 0;       // class: equal where it is decided
    Bounded autonomy;              // share of the hours that are not above .40, dark ones included
};

// alpha: probability that an interval misses.
Verdict judge(const View& view, double alpha);

// Limits of how many hours are above a limit, and of the DGP that so many exceed.  Where hours of the view share their
// paths they are counted in half-samples (uncertainty/shared_counts.h).
uncertainty::Interval hours_above(const View& view, double limit, double alpha);
uncertainty::Interval exceeded_dgp(const View& view, size_t exceeding, double alpha);

// Does the interval of the hour, with its pixels' error, hold the limit?
bool holds(const Hour& hour, double limit);

// Share of the views whose autonomy is .95 or more (spatial glare autonomy).
Bounded spatial_autonomy(const std::vector<Verdict>& verdicts);

// The n hours of the largest DGP, the largest first.
std::vector<Hour> worst_hours(const View& view, size_t n);

}  // namespace year
