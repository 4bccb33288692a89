// SPDX-License-Identifier: BSD-3-Clause
// The ratio of two quantities, each with replicates of its own, which may share their paths: if their parts hold the
// same frames of the same seeds, ratios of replicates are the replicates of the ratio, so that what both have too much
// of does not count.  Else both errors count as independent, which is too wide where paths are shared.
#pragma once
#include <vector>

#include "uncertainty/estimator.h"

namespace uncertainty {

// A quantity of some replicates, and its estimate.
struct Measured {
    const Replicates* replicates;
    size_t quantity;
    Estimate estimate;
};

// Quantities without bias, estimated by half-samples.
Estimate ratio(const Measured& over, const Measured& under);

// Of each half-sample; empty where the parts differ.
std::vector<double> ratio_of_half_samples(const Measured& over, const Measured& under);

}  // namespace uncertainty
