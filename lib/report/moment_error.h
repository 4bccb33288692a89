// SPDX-License-Identifier: BSD-3-Clause
// The error that columns of filled pixels (filled.h) have from that of the variance inside of pixels, which is
// estimated once, in frame 0: the same in all replicates of frames.
// Each pixel's variance has a known error e (image/moments.h).  Pairs of measurements with variances v + e and v - e,
// with a random sign for each pixel, give the column's error: the mean square of half their differences (balanced
// repeated replication with random signs; Wolter, Introduction to Variance Estimation, 2007, chapter 3).
#pragma once
#include <vector>
#include "glare/columns.h"
#include "uncertainty/estimator.h"

namespace report {

constexpr int moment_pairs = 4;

// Two values of each column from each pair, 0 for columns that are not of filled pixels; empty: none is known.
std::vector<uncertainty::Values> moment_values(const glare::Reading& whole, const std::vector<glare::Column>& columns);

}  // namespace report
