// SPDX-License-Identifier: BSD-3-Clause
// The counts of counts.h for values whose errors are alike, such as hours of one set of paths.  The number of values
// above a limit is a quantity as any other: it is counted in each half-sample, whose differences give its variance
// (replication.h), whatever the correlation of the errors.  A count of few values is granular, so that half-samples may
// all have the same one: the limits of independent errors, which are the least that there can be, count, too.
#pragma once
#include "uncertainty/counts.h"
#include "uncertainty/halves.h"

namespace uncertainty {

struct Shared {
    Uncertain of;
    std::array<double, half_samples> off{};  // of each half-sample, in standard errors
    double half(size_t k) const { return of.value + of.error * off[k]; }
};

std::vector<Uncertain> apart(const std::vector<Shared>& values);  // as if their errors were independent

// A quantity of all frames and of each half-sample.
struct Images {
    double whole = 0;
    std::array<double, half_samples> halves{};
};

// Student's limits, from half-samples of so many strata.
Interval limits_of(const Images& quantity, double strata, double alpha);
Interval widest(const Interval& a, const Interval& b);

// Of errors without a bound.
Images counts_within(const std::vector<Shared>& values, double from, double to);
Interval count_within(const std::vector<Shared>& values, const Images& counts, double strata, double from, double to,
                      double alpha);

Interval count_above(const std::vector<Shared>& values, double strata, double limit, double alpha);
Interval exceeded_interval(const std::vector<Shared>& values, double strata, size_t exceeding, double alpha);

}  // namespace uncertainty
