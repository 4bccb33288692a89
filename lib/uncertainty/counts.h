// SPDX-License-Identifier: BSD-3-Clause
// How many of many values lie above a limit, and which value so many of them exceed, where each value is known with an
// error of its own.  Errors of different values are independent, so that a count is a sum of independent events of
// unequal chance: a Poisson-binomial distribution (Y. Hong, On computing the distribution function for the Poisson
// binomial distribution, Computational Statistics and Data Analysis 59, 2013).
#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "uncertainty/estimate.h"

namespace uncertainty {

// A standard error, known with some degrees of freedom; an error that is unknown but not larger than `bound`; and one
// between 0 and `jump`, which has a sign.  The truth is surely between `least` and `most`.
struct Uncertain {
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    double value = 0, error = 0, bound = 0, jump = 0;
    double degrees = infinite, least = -infinite, most = infinite;
    // The value with all that is unknown downward (side -1) or upward (1), and `errors` standard errors more.
    double at(double side, double errors = 0) const {
        const double far = value + side * (bound + errors * error) + (side * jump > 0 ? jump : 0);
        return std::clamp(far, least, most);
    }
};

// The probability that the true value is above the limit, with its unknown error at `side` (-1 to 1) of the bound.
double chance_above(const Uncertain& value, double limit, double side = 0);

// P(N = 0), P(N = 1) ... of the number of events that happen.
std::vector<double> count_distribution(const std::vector<double>& chances);

// Limits that the number of values above `limit` leaves on each side with the probability alpha / 2.
Interval count_above(const std::vector<Uncertain>& values, double limit, double alpha);

// The same for values from `from` on and below `to`, which may be infinite; of errors without a bound.
Interval count_within(const std::vector<Uncertain>& values, double from, double to, double alpha);

// The same for the smallest x that no more than `exceeding` of the values are above.
double exceeded(const std::vector<Uncertain>& values, size_t exceeding);
Interval exceeded_interval(const std::vector<Uncertain>& values, size_t exceeding, double alpha);

}  // namespace uncertainty
