// SPDX-License-Identifier: BSD-3-Clause
// See estimator.h.
#include "uncertainty/estimator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/processors.h"
#include "base/threads.h"
#include "base/wide.h"
#include "uncertainty/threshold_filter.h"

namespace uncertainty {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding_of_parts = 1e-5;  // of the value: parts are differences of floats

WIDE_LOOP void add_multiple(float weight, const float* from, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] += weight * from[i];
}

WIDE_LOOP void add_squares(float weight, const float* part, const float* whole, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] += weight * (part[i] - whole[i]) * (part[i] - whole[i]);
}

void weighted_mean(const GrowingMean& mean, const Weights& weights, std::vector<float>& out) {
    out.assign(size_t(mean.width) * size_t(mean.height), 0);
    for (size_t p = 0; p < weights.size(); ++p)
        if (weights[p] != 0) add_multiple(float(weights[p]), (*mean.parts)[p].grey.data(), out.size(), out.data());
}

// Variance of each pixel of the whole mean; -1 where the pixel does not count.
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

double mean_square_of_half_differences(const std::vector<Values>& pairs, size_t quantity) {
    double sum = 0;
    for (size_t k = 0; k < pairs.size(); k += 2) sum += std::pow((pairs[k][quantity] - pairs[k + 1][quantity]) / 2, 2);
    return 2 * sum / double(pairs.size());
}

bool by_jackknife(const Quantity& q) { return q.method == Quantity::Method::jackknife; }

std::vector<double> values_of(const std::vector<Values>& images, size_t quantity) {
    std::vector<double> out;
    for (const Values& v : images) out.push_back(v[quantity]);
    return out;
}

}  // namespace

int64_t Replicates::count() const { return std::accumulate(frames.begin(), frames.end(), int64_t(0)); }

Replicates replicate(const GrowingMean& mean, const Metrics& metrics, const Values& whole) {
    Replicates out;
    for (const image::Part& p : *mean.parts) out.frames.push_back(p.frames), out.from.push_back(p.from);
    out.whole = whole;
    const Frames& frames = out.frames;
    const int64_t n = out.count();
    if (frames.size() < 2) return out;

    const size_t size = size_t(mean.width) * size_t(mean.height);
    ThresholdFilter filter;
    if (metrics.threshold && metrics.filter_radius > 0) {
        const std::vector<float> variance = variances(mean);
        filter = {{mean.width, mean.height, mean.whole, variance.data()}, *metrics.threshold, metrics.filter_radius};
    }
    const Frame0Error& frame0 = mean.frame0_error;
    const bool moves_frame0 = !frame0.of_pixel.empty() && n > 2 && n <= frame0_matters * frame0.m;
    const float scale = moves_frame0 ? float(std::sqrt(missing_share(n, frame0.m))) : 0;
    // The half-samples, the whole mean, and the pairs of frame 0.
    const int images = half_samples + 1 + (moves_frame0 ? 2 * frame0_pairs : 0);
    const auto make = [&](int k, std::vector<float>& image) {
        if (k < half_samples) return weighted_mean(mean, half_sample(frames, k), image);
        image.assign(mean.whole, mean.whole + size);
        const int pair = (k - half_samples - 1) / 2;
        const float up = (k - half_samples - 1) % 2 ? -scale : scale;
        for (size_t i = 0; k > half_samples && i < size; ++i)
            image[i] += up * float(random_sign(uint32_t(i), pair)) * frame0.of_pixel[i];
    };
    const std::vector<Values> seen = measure_all(images, make, filter, metrics);
    out.half_samples = {seen.begin(), seen.begin() + half_samples};
    out.decided = seen[half_samples];
    out.frame0_pairs = {seen.begin() + half_samples + 1, seen.end()};

    std::vector<float> image;
    if (std::any_of(metrics.quantities.begin(), metrics.quantities.end(), by_jackknife))
        for (size_t p = 0; p < frames.size(); ++p) {
            weighted_mean(mean, all_but(frames, p), image);
            out.without.push_back(metrics.measure_regions(image));
        }
    return out;
}

std::vector<Estimate> estimate(const Replicates& of, const std::vector<Quantity>& quantities) {
    std::vector<Estimate> out(of.whole.size(), {no_value, no_value, 0, 0, false, of.count()});
    for (size_t c = 0; c < out.size() && of.frames.size() >= 2; ++c) {
        const Quantity& q = quantities[c];
        if (by_jackknife(q)) out[c] = jackknife(of.whole[c], values_of(of.without, c), of.frames, q.ratio);
        else
            out[c] = brr(q.bias == NoiseBias::none ? of.whole[c] : of.decided[c], values_of(of.half_samples, c),
                         of.frames, q.bias, q.bias_error);
        for (const auto* pairs : {&of.frame0_pairs, &of.lasting_pairs}) {
            if (pairs->empty()) continue;
            const double variance = mean_square_of_half_differences(*pairs, c);
            add_error(out[c], variance, double(pairs->size()) / 2);
            if (pairs == &of.lasting_pairs) out[c].lasting = std::sqrt(variance);
        }
        if (out[c].error < rounding_of_parts * std::fabs(out[c].value)) out[c].unreliable = false;
        if (q.method == Quantity::Method::none || of.count() < q.least)
            out[c].error = no_value, out[c].unreliable = false;
    }
    return out;
}

}  // namespace uncertainty
