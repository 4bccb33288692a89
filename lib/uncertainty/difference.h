// SPDX-License-Identifier: BSD-3-Clause
// The difference of a quantity in two runs, b less a, with its error.
// Runs with the same seed share noise where their scenes are alike (common random numbers; Law, Simulation Modeling and
// Analysis, 2015, section 11.2).  If their parts hold the same frames, differences of replicates are the replicates
// of the difference, and its bias and error follow as those of any quantity (replication.h).  Else both errors count
// as independent.
#pragma once
#include "uncertainty/estimator.h"

namespace uncertainty {

// The parts of both hold the same frames of the same seeds.
bool same_frames(const Replicates& a, const Replicates& b);

// b less a.
std::vector<Estimate> difference(const Replicates& a, const Replicates& b, const std::vector<Quantity>& quantities);

// The replicates of some quantities alone, in this order.
Replicates select(const Replicates& of, const std::vector<size_t>& quantities);

}  // namespace uncertainty
