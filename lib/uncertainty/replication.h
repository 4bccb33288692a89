// SPDX-License-Identifier: BSD-3-Clause
// Bias and standard error of a quantity from its values of replicates (Wolter, Introduction to Variance Estimation,
// 2007, chapters 3 and 4).
#pragma once
#include <vector>

#include "uncertainty/estimate.h"
#include "uncertainty/half_samples.h"

namespace uncertainty {

// The bias of a quantity grows with noise: of a square with its variance, an absolute difference with its deviation.
enum class NoiseBias { none, variance, deviation };

// Balanced repeated replication (McCarthy 1966).  replicates: the quantity of each half-sample's mean.
//     bias b = (mean of replicates - whole) / (r - 1), r the noise of half-samples over that of the whole
//     error^2 = mean of odd^2 + mean of (even - mean even)^2 + (q b)^2
// odd and even: half the difference and half the sum of a half-sample's value and its complement's.  The error of the
// bias that is taken off is q of it.
//
// A pixel near the threshold makes a quantity jump.  The side of the whole is noise then, not bias, and taking b off
// would double that noise.  So b max(0, 1 - 2 v/b^2) is taken off (positive-part shrinkage, James and Stein 1961), v
// the variance of (even - whole)/(r - 1) among rows, and the rest of b counts as error.  Half-samples lie beyond the
// jump as often as the truth does (Efron and Tibshirani, The problem of regions, Annals of Statistics 26, 1998): the
// 92 % interval holds all of their values, the 95 % interval some of the noise that the truth has beside them.  With s
// strata, 1/(2 (s + 1)) of runs see no half-sample beyond a jump at the threshold itself.
Estimate brr(double whole, const std::vector<double>& replicates, const Frames& frames, NoiseBias bias, double q);

// Delete-one jackknife for groups of unequal size (Busing, Meijer and van der Leeden, Statistics and Computing 9,
// 1999), with the skewness of the groups.  without: the quantity of the mean without each part.  With n frames, m_j in
// part j and x_j = (n - m_j)/m_j (whole - without_j):
//     error^2 = 1/n sum m_j (x_j - mean x)^2 / (parts - 1)
// ratio: the jackknife's bias is taken off, too.
Estimate jackknife(double whole, const std::vector<double>& without, const Frames& frames, bool ratio);

// Adds an independent error: its variance and degrees of freedom (Welch 1947, Satterthwaite 1946).
void add_error(Estimate& to, double variance, double degrees);

}  // namespace uncertainty
