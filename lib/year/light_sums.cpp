// SPDX-License-Identifier: BSD-3-Clause
// See light_sums.h.
#include "year/light_sums.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace year {

GridHour sum_of(const std::vector<std::pair<double, const GridHour*>>& hours) {
    using uncertainty::half_samples;
    GridHour sum = *hours.front().second;
    bool has_halves = true;
    for (const auto& [factor, h] : hours) {
        if (h->sensors.size() != sum.sensors.size())
            base::fail(name_of(h->time), "states of shades have grids of different sensors");
        has_halves = has_halves && !h->halves.empty();
        sum.degrees = std::min(sum.degrees, h->degrees), sum.strata = std::min(sum.strata, h->strata);
    }
    if (!has_halves) sum.halves.clear(), sum.strata = 0;
    for (size_t i = 0; i < sum.sensors.size(); ++i) {
        double value = 0, error = 0, squares = 0;
        std::vector<double> halves(half_samples);
        for (const auto& [factor, h] : hours) {
            const Lux& e = h->sensors[i];
            value += factor * double(e.value), error += std::fabs(factor) * double(e.error);
            if (!has_halves) continue;
            const auto off = uncertainty::off(h->halves[i]);
            for (size_t k = 0; k < half_samples; ++k) halves[k] += factor * double(e.error) * off[k];
        }
        for (const double h : halves) squares += h * h / half_samples;
        if (has_halves) error = std::sqrt(squares), sum.halves[i] = uncertainty::halves_of(halves, sum.strata).codes;
        sum.sensors[i] = {float(value < 0 ? 0 : value), float(error)};
    }
    return sum;
}

}  // namespace year
