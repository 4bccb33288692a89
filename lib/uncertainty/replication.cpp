// SPDX-License-Identifier: BSD-3-Clause
// See replication.h.
#include "uncertainty/replication.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "uncertainty/student.h"

namespace uncertainty {
namespace {

constexpr double cochran_level = 0.001;
constexpr size_t least_for_skewness = 6;  // parts
constexpr double reach = 0.92;            // the interval of this level holds all replicates

// Cochran's C (Cochran, Annals of Eugenics 11, 1941): the largest of `terms` squares has a share of their sum that
// chance gives it with a probability below the level.  One term against the others is t^2 = share/(1 - share) degrees.
bool one_dominates(double share, double terms, double degrees) {
    if (degrees < 2 || !(share < 1)) return share >= 1;
    return terms * student_outside(std::sqrt(share / (1 - share) * degrees), degrees) < cochran_level;
}

double ratio_of_noise(const Frames& frames, NoiseBias bias) {
    // An absolute difference that is all noise has a bias in proportion to the square root of the variance, and many
    // differences of all sizes have one in proportion to the variance: the power lies between 1/2 and 1.  Rooms had
    // 0.46 to 0.79 (docs/decisions/0019-intervals.md).
    constexpr double power_of_deviation = 0.66;
    const double r = variance_ratio(frames);
    return bias == NoiseBias::deviation ? std::pow(r, power_of_deviation) : r;
}

// The part of b on which the rows of the matrix agree; variance: of b among rows.
double agreed(double b, double variance) { return b == 0 ? 0 : b * std::max(0., 1 - 2 * variance / (b * b)); }

double farthest(const std::vector<double>& replicates, double from) {
    double out = 0;
    for (const double r : replicates) out = std::max(out, std::fabs(r - from));
    return out;
}

}  // namespace

Estimate brr(double whole, const std::vector<double>& replicates, const Frames& frames, NoiseBias bias, double q) {
    Estimate out;
    const double mean = std::accumulate(replicates.begin(), replicates.end(), 0.) / half_samples;
    double odd[strata], of_odd = 0, of_even = 0, squares = 0, largest = 0;
    for (int j = 0; j < strata; ++j) {
        const double a = replicates[size_t(j)], b = replicates[size_t(j + strata)];
        odd[j] = (a - b) / 2;
        of_odd += odd[j] * odd[j] / strata, of_even += std::pow((a + b) / 2 - mean, 2) / strata;
    }
    const double variance = of_odd + of_even;
    const size_t pairs = frames.size() / 2;
    for (size_t s = 0; s < pairs; ++s) {
        double difference = 0;
        for (int j = 0; j < strata; ++j) difference += hadamard(j, int(s)) * odd[j] / strata;
        squares += difference * difference, largest = std::max(largest, difference * difference);
    }
    out.frames = std::accumulate(frames.begin(), frames.end(), int64_t(0));
    out.degrees = degrees_of_freedom(frames);
    const double excess = ratio_of_noise(frames, bias) - 1;
    const double b = bias == NoiseBias::none ? 0 : (mean - whole) / excess;
    const double taken_off = bias == NoiseBias::variance ? agreed(b, of_even / (excess * excess)) : b;
    out.value = whole - taken_off;
    out.error = std::sqrt(variance + std::pow(q * taken_off, 2) + std::pow(b - taken_off, 2));
    if (bias == NoiseBias::variance)
        out.error = std::max(out.error, farthest(replicates, out.value) / student_quantile(1 - reach, out.degrees));
    out.unreliable = pairs > 2 && squares > 0 && one_dominates(largest / squares, double(pairs), double(pairs - 1));
    return out;
}

Estimate jackknife(double whole, const std::vector<double>& without, const Frames& frames, bool ratio) {
    const double n = double(std::accumulate(frames.begin(), frames.end(), int64_t(0))), count = double(without.size());
    std::vector<double> x;
    double mean = 0, corrected = count * whole, squares = 0, cubes = 0, largest = 0;
    for (size_t j = 0; j < without.size(); ++j) {
        const double m = double(frames[j]);
        x.push_back((n - m) / m * (whole - without[j]));
        mean += m / n * x[j];
        corrected -= (1 - m / n) * without[j];
    }
    for (size_t j = 0; j < without.size(); ++j) {
        const double m = double(frames[j]), d = x[j] - mean;
        squares += m * d * d, cubes += std::pow(m * d, 3), largest = std::max(largest, m * d * d);
    }
    Estimate out;
    out.value = ratio ? corrected : whole;
    out.frames = int64_t(n);
    out.degrees = count - 1;
    out.error = std::sqrt(squares / out.degrees / n);
    out.unreliable = squares > 0 && one_dominates(largest / squares, count, out.degrees - 1);
    if (without.size() >= least_for_skewness && squares > 0)
        out.skewness = cubes / std::pow(n * out.error, 3) * count * count / ((count - 1) * (count - 2));
    return out;
}

void add_error(Estimate& to, double variance, double degrees) {
    if (!(variance > 0)) return;
    const double own = to.error * to.error, both = own + variance;
    to.degrees = both * both / ((own > 0 ? own * own / to.degrees : 0) + variance * variance / degrees);
    to.skewness *= std::pow(own / both, 1.5);
    to.error = std::sqrt(both);
}

}  // namespace uncertainty
