// SPDX-License-Identifier: BSD-3-Clause
// Intervals for numbers of a set of noisy values, as the sensors of a grid: mean, share above a limit, percentiles, the
// least.  Noise blurs a distribution: the least of noisy values is too low, and the share above a limit is off where
// many values lie near it.  So only the mean's interval comes from its own scatter; the other
// intervals come from values that are shifted by their errors.
#pragma once
#include <functional>
#include <vector>

#include "image/parts.h"
#include "uncertainty/estimate.h"

namespace uncertainty {

// Values and their standard errors, of the pixels first .. first + count - 1.
struct NoisyValues {
    std::vector<double> value, error;
    double degrees = 0;  // of freedom, of each error; 0: not known
    Estimate mean;
};

// whole: their mean over all frames.  A value's relative variance among parts is drawn toward the mean of all, with the
// weight of 8 degrees of freedom (an empirical Bayes estimate; sixteen parts alone cover too seldom).
NoisyValues noisy_values(const std::vector<image::Part>& parts, const float* whole, size_t first, size_t count,
                         double scale);

// The values of an interval itself, not its distance; nan where errors are not known.  alpha: probability to miss.
Interval point_limits(const NoisyValues& values, size_t i, double alpha);
Interval mean_limits(const NoisyValues& values, double alpha);
// Limits of a function that rises with each value.  Each value is shifted by one standard error, since errors of
// different values cancel, and by the part that all have in common: the limits of the mean.
Interval shifted_limits(const NoisyValues& values, double alpha, const std::function<double(std::vector<double>)>& of);
// The least value lies above the least lower limit and below the least upper limit, where limits hold for all values
// together (Bonferroni).
Interval least_limits(const NoisyValues& values, double alpha);

double share_from(const std::vector<double>& values, double limit);  // share of the values at the limit or above
double percentile(std::vector<double> values, double share);         // linear between ranks

}  // namespace uncertainty
