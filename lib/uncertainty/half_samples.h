// SPDX-License-Identifier: BSD-3-Clause
// Balanced half-samples of up to sixteen parts of a growing mean (P. J. McCarthy, Replication: an approach to the
// analysis of data from complex surveys, 1966, and Pseudo-replication: half samples, Rev. Int. Stat. Inst. 37, 1969).
// Of 2 h parts, p and p + h are the two units of a stratum (2 s and 2 s + 1 where the frames of parts differ by more
// than a factor of 2); an odd one out is a stratum by itself.  Half-sample k takes one part of each stratum by row k of
// the Hadamard matrix of order 8; half-sample k + 8 takes the others.
//
// Samples are points of a base-2 sequence (kernels/sampling/sampler.h), of which every eighth one has the same first
// three digits: the units of a stratum are alike, as in collapsed strata of systematic samples (Wolter 2007, chapter
// 8), so that their differences do not count what the sequence spreads evenly.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace uncertainty {

constexpr int strata = 8, half_samples = 16;

using Frames = std::vector<int64_t>;  // of each part
using Weights = std::vector<double>;  // of each part's mean, with the sum 1

// Element of the Hadamard matrix of order 8 (Sylvester): 1 or -1.
int hadamard(int row, int column);

// An empty half-sample, of fewer than two parts, has no weights.
Weights half_sample(const Frames& frames, int k);
// All parts but one.
Weights all_but(const Frames& frames, size_t part);

// (sum w)^2 / sum w^2, w the frames of a stratum (Satterthwaite 1946, as Wolter has it in chapter 3).
double degrees_of_freedom(const Frames& frames);

// Noise of half-samples over that of the whole mean, in variance: all frames times the mean of 1/frames over
// half-samples.
double variance_ratio(const Frames& frames);

}  // namespace uncertainty
