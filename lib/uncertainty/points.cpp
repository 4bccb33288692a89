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

constexpr double most_prior_degrees = 8;
constexpr size_t least_scatter = 16;  // values whose scatter says how much their variances differ
constexpr Interval unknown{NAN, NAN};

// Variance of a value: of a mean of N frames from the means of groups of n_j, sum n_j (x_j - x)^2 / ((groups - 1) N).
double own_variance(const NoisyValues& v, size_t i) {
    double sum = 0;
    for (const auto& [weight, off] : v.parts) sum += weight * double(off[i]) * double(off[i]);
    return sum;
}

// r^2 of points.h.
double share_in_common(const NoisyValues& v, double at) {
    constexpr double far = 6;  // standard errors beyond the nearest value, whose weight is 1
    double nearest = INFINITY, apart = 0;
    for (size_t i = 0; i < v.value.size(); ++i)
        if (v.error[i] > 0) nearest = std::min(nearest, std::fabs(v.value[i] - at) / v.error[i]);
    std::vector<double> together(v.parts.size(), 0.0);
    for (size_t i = 0; i < v.value.size(); ++i) {
        if (!(v.error[i] > 0)) continue;
        const double z = std::fabs(v.value[i] - at) / v.error[i];
        if (z > nearest + far) continue;
        const double weight = std::exp((nearest * nearest - z * z) / 2) / v.error[i];
        apart += weight * std::sqrt(own_variance(v, i));
        for (size_t p = 0; p < v.parts.size(); ++p) together[p] += weight * double(v.parts[p].second[i]);
    }
    double variance = 0;
    for (size_t p = 0; p < v.parts.size(); ++p) variance += v.parts[p].first * together[p] * together[p];
    return apart > 0 ? std::min(1., variance / (apart * apart)) : 1;
}

// psi'(x), the variance of the logarithm of a gamma variate of shape x: of a chi square of 2x degrees of freedom.
double trigamma(double x) { return 1 / x + 1 / (2 * x * x) + 1 / (6 * x * x * x); }

// Degrees of freedom of the distribution from which relative variances come, each of which was estimated with `own`
// degrees: the variance of their logarithms exceeds psi'(own/2) by psi'(degrees/2) (Smyth, Linear Models and Empirical
// Bayes Methods, 2004, section 6.2), whose first two terms are solved here.
double prior_degrees(const std::vector<double>& relative, double own) {
    double sum = 0, squares = 0, n = 0;
    for (const double r : relative)
        if (r > 0) sum += std::log(r), squares += std::log(r) * std::log(r), n++;
    if (n < 2) return 0;
    if (n < least_scatter) return most_prior_degrees;
    const double excess = (squares - sum * sum / n) / (n - 1) - trigamma(own / 2);
    if (excess <= 0) return most_prior_degrees;
    return std::min(most_prior_degrees, (1 + std::sqrt(1 + 2 * excess)) / excess);
}

// Standard errors by which blur may move a number down and up.  If values without noise are normal with k standard
// errors, those with it have sqrt(1 + k^2), and a percentile is farther from the median by the difference times its
// normal quantile.  k is that of the values beyond the median on the side of `at`, less two standard errors of its own.
// At least 1 to either side: distributions are not normal.
Interval blur_errors(const NoisyValues& v, double at, double tail) {
    const double median = percentile(v.value, .5);
    double spread = 0, noise = 0, n = 0;
    for (size_t i = 0; i < v.value.size(); ++i) {
        if ((v.value[i] < median) != (at < median)) continue;
        spread += (v.value[i] - median) * (v.value[i] - median), noise += v.error[i] * v.error[i], n++;
    }
    if (!(noise > 0)) return {1, 1};
    const double k2 = std::max(0.0, spread / noise * std::max(0.0, 1 - 2 * std::sqrt(2 / n)) - 1),
                 quantile = student_quantile(2 * std::max(tail, .5 / double(v.value.size())), v.degrees),
                 inward = std::max(1.0, quantile * (std::sqrt(1 + k2) - std::sqrt(k2)));
    return at < median ? Interval{1, inward} : Interval{inward, 1};
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
    double frames = 0;
    Frames of_parts;
    for (const image::Part& part : parts) frames += double(part.frames), of_parts.push_back(part.frames);
    for (int k = 0; k < half_samples; ++k) out.half_weights.push_back(half_sample(of_parts, k));
    out.strata = degrees_of_freedom(of_parts);
    for (const image::Part& part : parts) {
        auto& [weight, off] = out.parts.emplace_back(double(part.frames) / (double(parts.size() - 1) * frames),
                                                     std::vector<float>(count));
        for (size_t i = 0; i < count; ++i) off[i] = float(scale * double(part.grey[first + i]) - out.value[i]);
    }
    std::vector<double> relative(count, 0.0);
    double pooled = 0, lit = 0;
    for (size_t i = 0; i < count; ++i) {
        const double v = out.value[i];
        if (!(v > 0)) continue;
        relative[i] = own_variance(out, i) / (v * v);
        pooled += relative[i], lit++;
    }
    if (lit > 0) pooled /= lit;
    const double own = double(parts.size() - 1), prior = prior_degrees(relative, own);
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

Halves point_halves(const NoisyValues& v, size_t i) {
    std::vector<double> values(v.half_weights.size(), 0.);
    for (size_t k = 0; k < values.size(); ++k)
        for (size_t p = 0; p < v.parts.size(); ++p) values[k] += v.half_weights[k][p] * double(v.parts[p].second[i]);
    return values.empty() ? Halves{} : halves_of(values, v.strata);
}

Interval mean_limits(const NoisyValues& v, double alpha) {
    if (v.degrees <= 0) return unknown;
    if (!v.mean.known()) return {v.mean.value, v.mean.value};  // no frame differs from another one
    const Interval off = v.mean.around(alpha, v.mean.frames);
    return {v.mean.value + off.low, v.mean.value + off.high};
}

Interval shifted_limits(const NoisyValues& v, double alpha, double at, double tail,
                        const std::function<double(std::vector<double>)>& of) {
    if (v.degrees <= 0) return unknown;
    const double t = student_quantile(alpha, v.degrees), common = share_in_common(v, at);
    const Interval blur = blur_errors(v, at, tail);
    const auto errors = [&](double blurred) {  // blur is of 95 %
        return std::sqrt(1 - common) * blurred * t / student_quantile(.05, v.degrees) + std::sqrt(common) * t;
    };
    const double down = errors(blur.low), up = errors(blur.high);
    std::vector<double> low, high;
    for (size_t i = 0; i < v.value.size(); ++i) {
        low.push_back(v.value[i] - down * v.error[i]);
        high.push_back(v.value[i] + up * v.error[i]);
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

Interval greatest_limits(const NoisyValues& v, double alpha) {
    if (v.degrees <= 0) return unknown;
    Interval out{-INFINITY, -INFINITY};
    const double each = student_quantile(alpha / double(v.value.size()), v.degrees);
    for (size_t i = 0; i < v.value.size(); ++i) {
        out.low = std::max(out.low, v.value[i] - each * v.error[i]);
        out.high = std::max(out.high, v.value[i] + each * v.error[i]);
    }
    return out;
}

double share_from(const std::vector<double>& values, double limit) {
    return double(std::count_if(values.begin(), values.end(), [&](double v) { return v >= limit; })) /
           double(values.size());
}

double percentile(std::vector<double> values, double share) {
    const double at = share * double(values.size() - 1);
    const auto k = values.begin() + long(std::min(size_t(at), values.size() - 1));
    std::nth_element(values.begin(), k, values.end());
    const double next = k + 1 == values.end() ? *k : *std::min_element(k + 1, values.end());
    return *k + (at - std::floor(at)) * (next - *k);
}

}  // namespace uncertainty
