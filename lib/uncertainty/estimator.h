// SPDX-License-Identifier: BSD-3-Clause
// Estimates of quantities of a growing mean: each replicate image is measured by the function that measures any image.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "image/parts.h"
#include "uncertainty/frame0.h"
#include "uncertainty/replication.h"

namespace uncertainty {

// How the error of a quantity is estimated.
struct Quantity {
    enum class Method { none, half_samples, jackknife };
    Method method = Method::none;
    NoiseBias bias = NoiseBias::none;
    double bias_error = 0;  // q: standard error of the bias that is taken off, as a share of it
    bool ratio = false;     // jackknife: its bias is taken off
    int64_t least = 2;      // frames of the first estimate that has an error
};

using Values = std::vector<double>;  // of all quantities; nan for those that were not asked for
// `image`, and the image, perhaps the same, that decides which of its pixels are above the threshold.
using Measure = std::function<Values(std::vector<float>& image, std::vector<float>& classification)>;

struct GrowingMean {
    int width = 0, height = 0;
    const float* whole = nullptr;                     // L'(n)
    const std::vector<image::Part>* parts = nullptr;  // n frames in all
    Frame0Error frame0_error;                         // frame0.h
    std::vector<bool> counts;                         // by pixel: it is measured
};

struct Metrics {
    std::vector<Quantity> quantities;
    std::function<Measure()> measure;                                  // one for each thread
    std::function<Values(std::vector<float>& image)> measure_regions;  // of the jackknife's quantities
    std::optional<float> threshold;                                    // of sources, in the whole mean
    int filter_radius = 0;                                             // pixels (threshold_filter.h)
};

// Values from which the estimates follow: of the whole mean and of each replicate image.
struct Replicates {
    Frames frames;                        // of each part
    std::vector<image::SeedRanges> from;  // which frames these are
    Values whole;                         // by its own classification
    Values decided;                       // of the whole mean, by the classification of replicates
    std::vector<Values> half_samples;
    std::vector<Values> without;  // each part; empty: no quantity has the jackknife
    // Errors that are the same in all parts: images with e added and taken off by turns, e the error of a pixel with a
    // random sign.  Empty: there is no such error.
    std::vector<Values> frame0_pairs;   // frame0.h
    std::vector<Values> lasting_pairs;  // of what more frames do not change
    int64_t count() const;              // of frames
};

// whole: of all quantities.
Replicates replicate(const GrowingMean& mean, const Metrics& metrics, const Values& whole);

// nan where there are fewer than two parts.
std::vector<Estimate> estimate(const Replicates& replicates, const std::vector<Quantity>& quantities);

}  // namespace uncertainty
