// SPDX-License-Identifier: BSD-3-Clause
// See shared_counts.h.
#include "uncertainty/shared_counts.h"

#include <cmath>
#include <functional>

#include "uncertainty/student.h"

namespace uncertainty {
namespace {

using Quantity = std::function<double(const std::vector<Uncertain>&)>;

// With what is unknown at its `side` in all values.
Images at_side(const std::vector<Shared>& values, double side, const Quantity& quantity) {
    std::vector<Uncertain> image = apart(values);
    const auto of = [&](const auto& value) {
        for (size_t i = 0; i < image.size(); ++i) {
            Uncertain moved = values[i].of;
            moved.value = value(values[i]);
            image[i].value = moved.at(side);
        }
        return quantity(image);
    };
    Images out;
    out.whole = of([](const Shared& s) { return s.of.value; });
    for (size_t k = 0; k < half_samples; ++k) out.halves[k] = of([k](const Shared& s) { return s.half(k); });
    return out;
}

// A quantity that rises with the values; its limits reach no further than values that are surely not passed let it.
Interval around(const std::vector<Shared>& values, double strata, double alpha, const Quantity& quantity) {
    std::vector<Uncertain> lowest = apart(values), highest = lowest;
    for (Uncertain& u : lowest) u.value = u.least;
    for (Uncertain& u : highest) u.value = u.most;
    return {std::max(quantity(lowest), limits_of(at_side(values, -1, quantity), strata, alpha).low),
            std::min(quantity(highest), limits_of(at_side(values, 1, quantity), strata, alpha).high)};
}

// Whole numbers within the limits.
Interval whole_numbers(const Interval& of, size_t most) {
    constexpr double rounding = 1e-9;
    return {std::max(0., std::ceil(of.low - rounding)), std::min(double(most), std::floor(of.high + rounding))};
}

}  // namespace

std::vector<Uncertain> apart(const std::vector<Shared>& values) {
    std::vector<Uncertain> out;
    for (const Shared& s : values) out.push_back(s.of);
    return out;
}

// Noise moves a count by a bias, which half-samples have twice: limits reach over it on its side.
Interval limits_of(const Images& q, double degrees, double alpha) {
    double mean = 0, squares = 0;
    for (const double h : q.halves) mean += h / half_samples;
    for (const double h : q.halves) squares += (h - mean) * (h - mean) / half_samples;
    const double bias = mean - q.whole, half = squares > 0 ? student_quantile(alpha, degrees) * std::sqrt(squares) : 0;
    return {q.whole - std::max(bias, 0.) - half, q.whole + std::max(-bias, 0.) + half};
}

Interval widest(const Interval& a, const Interval& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Images counts_within(const std::vector<Shared>& values, double from, double to) {
    Images n;
    for (const Shared& s : values) {
        n.whole += s.of.value >= from && s.of.value < to;
        for (size_t k = 0; k < half_samples; ++k) n.halves[k] += s.half(k) >= from && s.half(k) < to;
    }
    return n;
}

Interval count_within(const std::vector<Shared>& values, const Images& counts, double strata, double from, double to,
                      double alpha) {
    const Interval independent = count_within(apart(values), from, to, alpha);
    return whole_numbers(widest(independent, limits_of(counts, strata, alpha)), values.size());
}

Interval count_above(const std::vector<Shared>& values, double strata, double limit, double alpha) {
    const auto count = [&](const std::vector<Uncertain>& image) {
        return double(std::count_if(image.begin(), image.end(), [&](const Uncertain& u) { return u.value > limit; }));
    };
    const Interval independent = count_above(apart(values), limit, alpha);
    return whole_numbers(widest(independent, around(values, strata, alpha, count)), values.size());
}

Interval exceeded_interval(const std::vector<Shared>& values, double strata, size_t exceeding, double alpha) {
    const auto of = [&](const std::vector<Uncertain>& image) { return exceeded(image, exceeding); };
    return widest(exceeded_interval(apart(values), exceeding, alpha), around(values, strata, alpha, of));
}

}  // namespace uncertainty
