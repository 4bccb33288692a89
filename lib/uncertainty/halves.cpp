// SPDX-License-Identifier: BSD-3-Clause
// See halves.h.
#include "uncertainty/halves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace uncertainty {

Halves halves_of(const std::vector<double>& values, double strata) {
    const double mean = std::accumulate(values.begin(), values.end(), 0.) / half_samples;
    if (!std::isfinite(mean)) return {};
    double most = 0;
    for (const double v : values) most = std::max(most, std::fabs(v - mean));
    Halves out;
    out.strata = strata;
    for (size_t k = 0; k < half_samples && most > 0; ++k)
        out.codes[k] = int8_t(std::lround(largest_code * (values[k] - mean) / most));
    return out;
}

std::array<double, half_samples> off(const HalfCodes& codes) {
    std::array<double, half_samples> out{};
    double squares = 0;
    for (const int code : codes) squares += code * code;
    for (size_t k = 0; k < half_samples; ++k)
        out[k] = squares > 0 ? codes[k] / std::sqrt(squares / half_samples) : k < strata ? 1 : -1;
    return out;
}

}  // namespace uncertainty
