// SPDX-License-Identifier: BSD-3-Clause
// Intervals for numbers of a set of noisy values, such as the sensors of a grid: mean, share above a limit,
// percentiles, the least.  Noise blurs a distribution: the least of noisy values is too low, and the share above a
// limit is off where many values lie near it.  So only the mean's interval comes from its own scatter; the other
// intervals come from values that are shifted by their errors.
//
// Errors of many values cancel in a share or percentile, and their blur moves it by up to one standard error, or more
// where values differ by less than their errors (blur_errors in points.cpp); where one value decides, its own t
// standard errors count.  Between them: of the errors e_i of values near the number, with weights w_i of the normal
// density of their distance from it, r^2 = var(sum w_i e_i) / (sum w_i s_i)^2 among parts is the share that does not
// cancel (1 for one value, or for errors that all have in common; 1/n for n independent ones), and values are shifted
// by sqrt(1 - r^2) + t r standard errors: blur and noise.
#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "image/parts.h"
#include "uncertainty/estimate.h"
#include "uncertainty/halves.h"

namespace uncertainty {

// Values and their standard errors, of the pixels first .. first + count - 1.
struct NoisyValues {
    std::vector<double> value, error;
    double degrees = 0;  // of freedom, of each error; 0: not known
    Estimate mean;
    double strata = 0;                  // of the parts
    std::vector<Weights> half_weights;  // of the parts in each half-sample
    // Of each part: its weight, so that the weighted squares of errors sum to a variance, and value less mean.
    std::vector<std::pair<double, std::vector<float>>> parts;
};

// whole: their mean over all frames.  A value's relative variance among parts is drawn toward the mean of all (sixteen
// parts alone cover too seldom), with the weight of up to 8 degrees of freedom: of fewer, the more variances differ.
NoisyValues noisy_values(const std::vector<image::Part>& parts, const float* whole, size_t first, size_t count,
                         double scale);

// The values of an interval itself, not its distance; nan where errors are not known.  alpha: probability to miss.
Interval point_limits(const NoisyValues& values, size_t i, double alpha);
Halves point_halves(const NoisyValues& values, size_t i);
Interval mean_limits(const NoisyValues& values, double alpha);
// Limits of a function that rises with each value and hangs on those near `at`: a percentile, the share above a limit.
// tail: the share of values beyond it, at most a half; 0: of none.
Interval shifted_limits(const NoisyValues& values, double alpha, double at, double tail,
                        const std::function<double(std::vector<double>)>& of);
// The least value lies above the least lower limit and below the least upper limit, where limits hold for all values
// together (Bonferroni); the greatest likewise.
Interval least_limits(const NoisyValues& values, double alpha);
Interval greatest_limits(const NoisyValues& values, double alpha);

double share_from(const std::vector<double>& values, double limit);  // share of the values at the limit or above
double percentile(std::vector<double> values, double share);         // linear between ranks

}  // namespace uncertainty
