// SPDX-License-Identifier: BSD-3-Clause
// Metrics without the bias of noise, to first order.  DGP and its relatives select bright pixels and square their
// luminance, RAMMG sums absolute differences: of noisy pixels all come out too large (or too small, where noise carries
// pixels of a source below the threshold).  How much follows from pictures of half the frames, which are noisier in a
// known proportion r: if x(n) = x + bias and x(n/2) = x + r bias, then  x = (r x(n) - x(n/2)) / (r - 1).
//
// What is selected and squared goes with the variance, r = 2: so do sums over glare sources, of which the metrics are
// made (GlareTerm::weight).  Absolute differences of noise go with its deviation, r = sqrt 2: so does RAMMG.
// A single hot pixel drops out of the sums: it is twice as bright in one half of the halves, and not in the others.
//
// The halves are the six pairs of four parts (batches.h), each with the frames it holds as its weight.
#pragma once
#include "comfort/batches.h"
#include "comfort/measure.h"

namespace comfort {

// The noise of the halves over that of the whole: power 1 of the variance, 1/2 of the deviation.
double noise_of_halves(const Batches::Parts& parts, double power);
constexpr double least_noise_of_halves = 1.2;  // below, halves tell too little: 1 is a single batch, 5/3 are two

// From its value of the whole and the weighted mean of the halves'.
double extrapolated(double whole, double halves, double noise_of_halves);

struct HalvesSources {
    GlareTerms terms;       // their weights sum to 1 for a source that all halves have
    double direct_lux = 0;  // weighted mean
};
HalvesSources sources_of_halves(SourceFinder& finder, const Batches::Parts& parts, const Settings& settings,
                                double threshold);

}  // namespace comfort
