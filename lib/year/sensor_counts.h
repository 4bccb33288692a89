// SPDX-License-Identifier: BSD-3-Clause
// What a sensor's hours come to, as a number with limits and half-samples, and means of such numbers over sensors.
// Where hours have paths of their own a sensor's errors are independent from hour to hour, so that its number of hours
// is a Poisson-binomial count (uncertainty/counts.h); where hours share them it is counted in half-samples
// (uncertainty/shared_counts.h).
//
// Errors of different sensors have a part in common: a mean over sensors, or a share of them, is counted in
// half-samples in both cases.  Limits are at least those of independent sensors, and at most the means of their limits
// or the shares at their limits, which hold for any correlation that errors of light can have and are the limits of
// tables without half-samples.
#pragma once
#include <utility>
#include <vector>

#include "uncertainty/shared_counts.h"
#include "year/verdict.h"

namespace year {

constexpr double count_rounding = 1e-9;

// A number of a sensor with its limits, and what it is in each half-sample.
struct Number {
    Bounded limits;
    uncertainty::Images images;
    double down = 0, up = 0;  // by how much less or more it may be where the state of shades is in doubt
};

// Some hours of a sensor.
struct SensorHours {
    std::vector<uncertainty::Shared> known;
    std::vector<std::pair<size_t, uncertainty::Shared>> instead;  // what one of `known` may be as well
    size_t missing = 0;   // for which the weather file has no values: any light is possible
    bool shared = false;  // the hours have paths in common
    double strata = 0;    // of their half-samples; 0: these are not known
};
std::vector<size_t> all_hours(const Grid& grid);
SensorHours hours_of(const Grid& grid, const std::vector<size_t>& which, size_t sensor);

// How many standard errors an interval has on each side.
double errors_of(double alpha, double degrees);

// Hours from `from` lx on and below `to`, times `scale`.
Number count(const SensorHours& hours, double from, double to, double alpha, double scale);

// The sum of what each hour has of `full` lx, at most 1, times `scale`.
Number credit(const SensorHours& hours, double full, double alpha, double scale);

// 1 where a number is `least` or more.
Number reached(const Number& n, double least);

// The mean over the sensors; strata: of the half-samples of all hours that are counted, 0 where some lack them or are
// missing.
Bounded mean(const std::vector<Number>& sensors, double strata, double alpha);
double strata_over(const Grid& grid, const std::vector<size_t>& which);

}  // namespace year
