// SPDX-License-Identifier: BSD-3-Clause
// See points.h.
#include "uncertainty/points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "uncertainty/half_samples.h"
#include "uncertainty/replication.h"
#include "uncertainty/student.h"

namespace uncertainty {
namespace {

constexpr double prior_degrees = 8;
constexpr Interval unknown{NAN, NAN};

// Variance of a mean of N frames from the means of groups of n_j: sum n_j (x_j - x)^2 / ((groups - 1) N).
double variance_of_mean(const std::vector<image::Part>& parts, size_t pixel, double mean, double scale) {
    double sum = 0, frames = 0;
    for (const image::Part& part : parts) {
        const double off = scale * double(part.grey[pixel]) - mean;
        sum += double(part.frames) * off * off;
        frames += double(part.frames);
    }
    return sum / (double(parts.size() - 1) * frames);
}

Estimate estimate_mean(const std::vector<image::Part>& parts, size_t first, size_t count, double whole, double scale) {
    Frames frames;
    std::vector<double> without;
    double total = 0;
    for (const image::Part& part : parts) frames.push_back(part.frames), total += double(part.frames);
    for (const image::Part& part : parts) {
        const auto begin = part.grey.begin() + long(first);
        const double own = scale * std::accumulate(begin, begin + long(count), 0.0) / double(count),
                     share = double(part.frames) / total;
        without.push_back((whole - share * own) / (1 - share));
    }
    return jackknife(whole, without, frames, false);
}

}  // namespace

NoisyValues noisy_values(const std::vector<image::Part>& parts, const float* whole, size_t first, size_t count,
                         double scale) {
    NoisyValues out;
    for (size_t i = first; i < first + count; ++i) out.value.push_back(scale * double(whole[i]));
    const double mean = std::accumulate(out.value.begin(), out.value.end(), 0.0) / double(count);
    out.mean.value = mean;
    out.mean.error = NAN;
    if (parts.size() < 2) return out;
    out.mean = estimate_mean(parts, first, count, mean, scale);
    std::vector<double> relative(count, 0.0);
    double pooled = 0, lit = 0;
    for (size_t i = 0; i < count; ++i) {
        const double v = out.value[i];
        if (!(v > 0)) continue;
        relative[i] = variance_of_mean(parts, first + i, v, scale) / (v * v);
        pooled += relative[i], lit++;
    }
    if (lit > 0) pooled /= lit;
    const double own = double(parts.size() - 1), prior = lit > 1 ? prior_degrees : 0;
    for (size_t i = 0; i < count; ++i)
        out.error.push_back(std::fabs(out.value[i]) * std::sqrt((own * relative[i] + prior * pooled) / (own + prior)));
    out.degrees = own + prior;
    return out;
}

Interval point_limits(const NoisyValues& v, size_t i, double alpha) {
    if (v.degrees <= 0) return unknown;
    const double half = student_quantile(alpha, v.degrees) * v.error[i];
    return {v.value[i] - half, v.value[i] + half};
}

Interval mean_limits(const NoisyValues& v, double alpha) {
    if (v.degrees <= 0) return unknown;
    const Interval off = v.mean.around(alpha, v.mean.frames);
    return {v.mean.value + off.low, v.mean.value + off.high};
}

Interval shifted_limits(const NoisyValues& v, double alpha, const std::function<double(std::vector<double>)>& of) {
    if (v.degrees <= 0) return unknown;
    const Interval mean = mean_limits(v, alpha);
    const double common = v.mean.value > 0 ? (mean.high - mean.low) / 2 / v.mean.value : 0;
    if (std::isnan(common)) return unknown;
    const double errors = student_quantile(alpha, v.degrees) / student_quantile(.05, v.degrees);
    std::vector<double> low, high;
    for (size_t i = 0; i < v.value.size(); ++i) {
        const double shift = std::hypot(errors * v.error[i], common * v.value[i]);
        low.push_back(v.value[i] - shift);
        high.push_back(v.value[i] + shift);
    }
    return {of(std::move(low)), of(std::move(high))};
}

Interval least_limits(const NoisyValues& v, double alpha) {
    if (v.degrees <= 0) return unknown;
    Interval out{INFINITY, INFINITY};
    const double each = student_quantile(alpha / double(v.value.size()), v.degrees);
    for (size_t i = 0; i < v.value.size(); ++i) {
        out.low = std::min(out.low, std::max(0.0, v.value[i] - each * v.error[i]));
        out.high = std::min(out.high, v.value[i] + each * v.error[i]);
    }
    return out;
}

double share_from(const std::vector<double>& values, double limit) {
    return double(std::count_if(values.begin(), values.end(), [&](double v) { return v >= limit; })) /
           double(values.size());
}

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double at = share * double(values.size() - 1);
    const size_t k = std::min(size_t(at), values.size() - 1), next = std::min(k + 1, values.size() - 1);
    return values[k] + (at - double(k)) * (values[next] - values[k]);
}

}  // namespace uncertainty
