// SPDX-License-Identifier: BSD-3-Clause
// See counts.h.
#include "uncertainty/counts.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "uncertainty/student.h"

namespace uncertainty {
namespace {

// The distribution of a count: values that are sure to be above, and the others' chances.
struct Count {
    size_t sure = 0;
    std::vector<double> chances;
};

template <class Chance>
Count count_of(const std::vector<Uncertain>& values, const Chance& chance) {
    constexpr double never = 1e-6;  // of 10,000 values, a hundredth of one
    Count c;
    for (const Uncertain& u : values) {
        const double p = chance(u);
        if (p > 1 - never) ++c.sure;
        else if (p >= never) c.chances.push_back(p);
    }
    return c;
}

Count count_at(const std::vector<Uncertain>& values, double limit, double side) {
    return count_of(values, [&](const Uncertain& u) { return chance_above(u, limit, side); });
}

Interval limits_of(const Count& low, const Count& high, double alpha) {
    const std::vector<double> below = count_distribution(low.chances), above = count_distribution(high.chances);
    size_t first = 0, last = above.size() - 1;
    for (double sum = below[0]; sum <= alpha / 2 && first + 1 < below.size(); sum += below[first]) ++first;
    for (double sum = above[last]; sum <= alpha / 2 && last > 0; sum += above[last]) --last;
    return {double(low.sure + first), double(high.sure + last)};
}

// P(N > n)
double chance_of_more(const Count& c, size_t n) {
    if (n < c.sure) return 1;
    const std::vector<double> distribution = count_distribution(c.chances);
    double sum = 0;
    for (size_t k = distribution.size(); k-- > n - c.sure + 1;) sum += distribution[k];
    return sum;
}

// The smallest x at which `falls`, a falling function of x, is at most p; x lies between the values' extremes.
double where(const std::vector<Uncertain>& values, double p, const std::function<double(double)>& falls) {
    double low = 0, high = 0;
    for (const Uncertain& u : values) {
        constexpr double far = 40;  // standard errors, of four degrees of freedom: a chance of one in a million
        const double least = u.at(-1, far), most = u.at(1, far);
        low = &u == &values.front() ? least : std::min(low, least);
        high = &u == &values.front() ? most : std::max(high, most);
    }
    low -= 1e-6;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        (falls(middle) <= p ? high : low) = middle;
    }
    return high;
}

}  // namespace

double chance_above(const Uncertain& u, double limit, double side) {
    if (limit < u.least || limit >= u.most) return limit < u.least ? 1 : 0;
    const double apart = u.at(side) - limit;
    if (!(u.error > 0)) return apart > 0 ? 1 : 0;
    return std::erfc(-normal_of_student(apart / u.error, u.degrees) / std::sqrt(2.)) / 2;
}

// One event after another.
std::vector<double> count_distribution(const std::vector<double>& chances) {
    std::vector<double> p{1};
    for (const double chance : chances) {
        p.push_back(0);
        for (size_t k = p.size(); k-- > 0;) p[k] = p[k] * (1 - chance) + (k > 0 ? p[k - 1] * chance : 0);
    }
    return p;
}

Interval count_above(const std::vector<Uncertain>& values, double limit, double alpha) {
    return limits_of(count_at(values, limit, -1), count_at(values, limit, 1), alpha);
}

Interval count_within(const std::vector<Uncertain>& values, double from, double to, double alpha) {
    const auto at_least = [](const Uncertain& u, double limit) {
        return chance_above(u, std::nextafter(limit, -INFINITY));
    };
    const Count c = count_of(values, [&](const Uncertain& u) { return at_least(u, from) - at_least(u, to); });
    return limits_of(c, c, alpha);
}

double exceeded(const std::vector<Uncertain>& values, size_t exceeding) {
    if (exceeding >= values.size()) return 0;
    std::vector<double> sorted;
    for (const Uncertain& u : values) sorted.push_back(u.value);
    std::nth_element(sorted.begin(), sorted.begin() + long(exceeding), sorted.end(), std::greater<>());
    return sorted[exceeding];
}

Interval exceeded_interval(const std::vector<Uncertain>& values, size_t exceeding, double alpha) {
    if (exceeding >= values.size()) return {0, 0};
    const auto more = [&](double side) {
        return [&, side](double x) { return chance_of_more(count_at(values, x, side), exceeding); };
    };
    return {where(values, 1 - alpha / 2, more(-1)), where(values, alpha / 2, more(1))};
}

}  // namespace uncertainty
