// SPDX-License-Identifier: BSD-3-Clause
// See estimator.h.
#include "uncertainty/estimator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/processors.h"
#include "base/threads.h"
#include "base/wide.h"
#include "uncertainty/frame0.h"
#include "uncertainty/threshold_filter.h"

namespace uncertainty {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

WIDE_LOOP void add_multiple(float weight, const float* from, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] += weight * from[i];
}

WIDE_LOOP void add_squares(float weight, const float* part, const float* whole, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] += weight * (part[i] - whole[i]) * (part[i] - whole[i]);
}

Frames frames_of_parts(const GrowingMean& mean) {
    Frames out;
    for (const image::Part& p : *mean.parts) out.push_back(p.frames);
    return out;
}

void weighted_mean(const GrowingMean& mean, const Weights& weights, std::vector<float>& out) {
    out.assign(size_t(mean.width) * size_t(mean.height), 0);
    for (size_t p = 0; p < weights.size(); ++p)
        if (weights[p] != 0) add_multiple(float(weights[p]), (*mean.parts)[p].grey.data(), out.size(), out.data());
}

// Of each pixel of the whole mean; -1 where it does not count.
std::vector<float> variances(const GrowingMean& mean) {
    std::vector<float> out(mean.counts.size(), 0);
    const double n = double(image::frames_of(*mean.parts)), parts = double(mean.parts->size());
    for (const image::Part& p : *mean.parts)
        add_squares(float(double(p.frames) / (n * (parts - 1))), p.grey.data(), mean.whole, out.size(), out.data());
    for (size_t i = 0; i < out.size(); ++i)
        if (!mean.counts[i]) out[i] = -1;
    return out;
}

// Measures images 0 to count - 1, which make() fills, on all threads.
std::vector<Values> measure_all(int count, const std::function<void(int, std::vector<float>&)>& make,
                                const ThresholdFilter& filter, const Metrics& metrics) {
    std::vector<Values> out(static_cast<size_t>(count));
    std::atomic<int> next{0};
    base::on_threads(std::min(base::processors(), unsigned(count)), [&] {
        const Measure measure = metrics.measure();
        std::vector<float> image, filtered;
        for (int k = next++; k < count; k = next++) {
            make(k, image);
            if (!filter.empty()) filter.apply(image, filtered);
            out[size_t(k)] = measure(image, filter.empty() ? image : filtered);
        }
    });
    return out;
}

double mean_square_of_half_differences(const std::vector<Values>& pairs, size_t first, size_t quantity) {
    double sum = 0;
    for (int k = 0; k < frame0_pairs; ++k) {
        const size_t at = first + 2 * size_t(k);
        sum += std::pow((pairs[at][quantity] - pairs[at + 1][quantity]) / 2, 2) / frame0_pairs;
    }
    return sum;
}

}  // namespace

std::vector<Estimate> estimate(const GrowingMean& mean, const Metrics& metrics, const Values& whole) {
    const Frames frames = frames_of_parts(mean);
    const int64_t n = image::frames_of(*mean.parts);
    std::vector<Estimate> out(whole.size(), {nan, nan, 0, 0, false, n});
    if (frames.size() < 2) return out;

    const size_t size = size_t(mean.width) * size_t(mean.height);
    ThresholdFilter filter;
    if (metrics.threshold && metrics.filter_radius > 0) {
        const std::vector<float> variance = variances(mean);
        filter = {{mean.width, mean.height, mean.whole, variance.data()}, *metrics.threshold, metrics.filter_radius};
    }
    const bool moves_frame0 = mean.frame0_error && n > 2 && n <= frame0_matters;
    const float scale = float(std::sqrt(missing_share(n)));
    // The half-samples, the whole mean, and the pairs of frame 0.
    const int images = half_samples + 1 + (moves_frame0 ? 2 * frame0_pairs : 0);
    const auto make = [&](int k, std::vector<float>& image) {
        if (k < half_samples) return weighted_mean(mean, half_sample(frames, k), image);
        image.assign(mean.whole, mean.whole + size);
        const int pair = (k - half_samples - 1) / 2;
        const float up = (k - half_samples - 1) % 2 ? -scale : scale;
        for (size_t i = 0; k > half_samples && i < size; ++i)
            image[i] += up * float(random_sign(uint32_t(i), pair)) * (*mean.frame0_error)[i];
    };
    const std::vector<Values> seen = measure_all(images, make, filter, metrics);

    std::vector<Values> without;
    const auto by_jackknife = [](const Quantity& q) { return q.method == Quantity::Method::jackknife; };
    std::vector<float> image;
    if (std::any_of(metrics.quantities.begin(), metrics.quantities.end(), by_jackknife))
        for (size_t p = 0; p < frames.size(); ++p) {
            weighted_mean(mean, all_but(frames, p), image);
            without.push_back(metrics.measure_regions(image));
        }
    for (size_t c = 0; c < whole.size(); ++c) {
        const Quantity& q = metrics.quantities[c];
        std::vector<double> values;
        if (by_jackknife(q)) {
            for (const Values& v : without) values.push_back(v[c]);
            out[c] = jackknife(whole[c], values, frames, q.ratio);
        } else {
            for (int k = 0; k < half_samples; ++k) values.push_back(seen[size_t(k)][c]);
            const double decided = q.bias == NoiseBias::none ? whole[c] : seen[half_samples][c];
            out[c] = brr(decided, values, frames, q.bias, q.bias_error);
        }
        if (moves_frame0) add_error(out[c], mean_square_of_half_differences(seen, half_samples + 1, c), frame0_pairs);
        if (q.method == Quantity::Method::none) out[c].error = nan, out[c].unreliable = false;
    }
    return out;
}

}  // namespace uncertainty
