// SPDX-License-Identifier: BSD-3-Clause
// See sensor_counts.h.
#include "year/sensor_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "uncertainty/student.h"

namespace year {

using uncertainty::half_samples;
using uncertainty::Interval;

std::vector<size_t> all_hours(const Grid& grid) {
    std::vector<size_t> which(grid.hours.size());
    std::iota(which.begin(), which.end(), size_t(0));
    return which;
}

static uncertainty::Shared shared_of(const Grid& grid, const GridHour& h, size_t sensor) {
    const Lux& e = h.sensors[sensor];
    uncertainty::Shared s{{double(e.value), double(e.error), 0, 0, h.degrees}, {}};
    if (grid.strata > 0 && !h.halves.empty()) s.off = uncertainty::off(h.halves[sensor]);
    return s;
}

SensorHours hours_of(const Grid& grid, const std::vector<size_t>& which, size_t sensor) {
    SensorHours hours;
    hours.shared = grid.shared, hours.strata = grid.strata;
    for (const size_t i : which) {
        const GridHour& h = grid.hours[i];
        if (std::isnan(h.sensors[sensor].value)) {
            ++hours.missing;
            continue;
        }
        for (const GridHour& other : h.instead)
            hours.instead.emplace_back(hours.known.size(), shared_of(grid, other, sensor));
        hours.known.push_back(shared_of(grid, h, sensor));
    }
    return hours;
}

double errors_of(double alpha, double degrees) {
    constexpr double as_good_as_normal = 1e6;
    return uncertainty::student_quantile(alpha, std::min(degrees, as_good_as_normal));
}

// The hours as they are in the states of shades that score most (side 1) or least (-1).
template <class Score>
static std::vector<uncertainty::Shared> worst_of(const SensorHours& hours, double side, const Score& score) {
    std::vector<uncertainty::Shared> worst = hours.known;
    for (const auto& [i, other] : hours.instead)
        if (side * score(other) > side * score(worst[i])) worst[i] = other;
    return worst;
}

// A number of these hours, whose limits reach as far as the states that shades may have let it.
template <class Score, class Of>
static Number over_states(const SensorHours& hours, const Score& score, const Of& number_of) {
    Number n = number_of(hours);
    if (hours.instead.empty()) return n;
    SensorHours worst = hours;
    worst.known = worst_of(hours, -1, score);
    const Bounded fewest = number_of(worst).limits;
    worst.known = worst_of(hours, 1, score);
    const Bounded most = number_of(worst).limits;
    n.limits.low = fewest.low, n.limits.high = most.high;
    n.down = std::max(0., n.limits.value - fewest.value), n.up = std::max(0., most.value - n.limits.value);
    return n;
}

static Number count_known(const SensorHours& hours, double from, double to, double alpha, double scale) {
    Number n;
    n.images = uncertainty::counts_within(hours.known, from, to);
    const Interval i = hours.shared ? uncertainty::count_within(hours.known, n.images, hours.strata, from, to, alpha)
                                    : uncertainty::count_within(uncertainty::apart(hours.known), from, to, alpha);
    n.limits = {scale * n.images.whole, scale * i.low, scale * (i.high + double(hours.missing))};
    n.images.whole *= scale;
    for (double& h : n.images.halves) h *= scale;
    return n;
}

Number count(const SensorHours& hours, double from, double to, double alpha, double scale) {
    const auto inside = [&](const uncertainty::Shared& s) {
        const double far = std::min(s.of.value - from, to - s.of.value);
        return s.of.error > 0 ? far / s.of.error : far < 0 ? -INFINITY : INFINITY;
    };
    return over_states(hours, inside, [&](const SensorHours& h) { return count_known(h, from, to, alpha, scale); });
}

// Each hour's credit moves by half of its difference between one standard error above and below; where it bends, at
// `full`, its mean over the noise is lower than it, by which the limits reach further.
static Number credit_known(const SensorHours& hours, double full, double alpha, double scale) {
    const auto of = [&](double lux) { return std::clamp(lux / full, 0., 1.); };
    Number n;
    double variance = 0, squares = 0, bias = 0;
    for (const uncertainty::Shared& h : hours.known) {
        const double here = of(h.of.value), up = of(h.of.value + h.of.error), down = of(h.of.value - h.of.error);
        const double own = std::pow((up - down) / 2, 2);
        variance += own, squares += own * own / h.of.degrees, bias += (up + down) / 2 - here;
        n.images.whole += here;
        for (size_t k = 0; k < half_samples; ++k) n.images.halves[k] += of(h.half(k));
    }
    const double degrees = squares > 0 ? variance * variance / squares : uncertainty::Uncertain::infinite;
    const double half = variance > 0 ? errors_of(alpha, degrees) * std::sqrt(variance) : 0;
    Interval i{n.images.whole - std::max(bias, 0.) - half, n.images.whole + std::max(-bias, 0.) + half};
    if (hours.shared) i = uncertainty::widest(i, uncertainty::limits_of(n.images, hours.strata, alpha));
    const double most = double(hours.known.size());
    n.limits = {scale * n.images.whole, scale * std::max(i.low, 0.),
                scale * (std::min(i.high, most) + double(hours.missing))};
    n.images.whole *= scale;
    for (double& h : n.images.halves) h *= scale;
    return n;
}

Number credit(const SensorHours& hours, double full, double alpha, double scale) {
    const auto value = [](const uncertainty::Shared& s) { return s.of.value; };
    return over_states(hours, value, [&](const SensorHours& h) { return credit_known(h, full, alpha, scale); });
}

Number reached(const Number& n, double least) {
    Number out;
    out.limits = {double(n.limits.value >= least), double(n.limits.low >= least), double(n.limits.high >= least)};
    out.images.whole = n.images.whole >= least;
    out.down = out.limits.value - double(n.limits.value - n.down >= least);
    out.up = double(n.limits.value + n.up >= least) - out.limits.value;
    for (size_t k = 0; k < half_samples; ++k) out.images.halves[k] = n.images.halves[k] >= least;
    return out;
}

// The limits by half-samples, not narrower than those of independent sensors and not wider than if all err alike;
// these where half-samples do not tell all.
Bounded mean(const std::vector<Number>& sensors, double strata, double alpha) {
    Bounded outer;              // if all sensors err alike
    double down2 = 0, up2 = 0;  // squares of the distances of the limits if they err independently
    double down = 0, up = 0;
    uncertainty::Images images;
    const double share = 1 / double(sensors.size());
    for (const Number& n : sensors) {
        const Bounded& b = n.limits;
        outer.value += share * b.value, outer.low += share * b.low, outer.high += share * b.high;
        const double noise_down = std::max(0., b.value - n.down - b.low),
                     noise_up = std::max(0., b.high - b.value - n.up);
        down2 += std::pow(share * noise_down, 2), up2 += std::pow(share * noise_up, 2);
        down += share * n.down, up += share * n.up;
        images.whole += share * n.images.whole;
        for (size_t k = 0; k < half_samples; ++k) images.halves[k] += share * n.images.halves[k];
    }
    if (!(strata > 0)) return outer;
    const Interval by_halves = uncertainty::limits_of(images, strata, alpha);
    const double low = std::min(by_halves.low, outer.value - std::sqrt(down2)) - down,
                 high = std::max(by_halves.high, outer.value + std::sqrt(up2)) + up;
    return {outer.value, std::max(outer.low, low), std::min(outer.high, high)};
}

double strata_over(const Grid& grid, const std::vector<size_t>& which) {
    const bool is_whole = std::none_of(which.begin(), which.end(), [&](size_t i) { return is_missing(grid.hours[i]); });
    return is_whole ? grid.strata : 0;
}

}  // namespace year
