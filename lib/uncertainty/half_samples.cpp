// SPDX-License-Identifier: BSD-3-Clause
// See half_samples.h.
#include "uncertainty/half_samples.h"

#include <algorithm>
#include <bitset>
#include <numeric>

namespace uncertainty {
namespace {

struct Unit {
    size_t stratum;
    bool first;
};

// Parts p and p + h of 2 h; neighbours, 2 s and 2 s + 1, where ranges have grown, for units should have as many frames.
Unit unit_of(const Frames& frames, size_t part) {
    const auto [least, most] = std::minmax_element(frames.begin(), frames.end());
    if (*most > 2 * *least) return {part / 2, part % 2 == 0};
    const size_t h = (frames.size() + 1) / 2;
    return {part % h, part < h};
}

bool chosen(const Frames& frames, size_t part, int k) {
    const Unit unit = unit_of(frames, part);
    const int sign = hadamard(k % strata, int(unit.stratum));
    return unit.first == ((k < strata) == (sign > 0));
}

template <class Choice>
Weights weights_of(const Frames& frames, Choice chosen) {
    double n = 0;
    for (size_t p = 0; p < frames.size(); ++p) n += chosen(p) ? double(frames[p]) : 0;
    Weights out(n > 0 ? frames.size() : 0, 0);
    for (size_t p = 0; p < out.size(); ++p) out[p] = chosen(p) ? double(frames[p]) / n : 0;
    return out;
}

}  // namespace

int hadamard(int row, int column) { return std::bitset<8>(unsigned(row & column)).count() % 2 ? -1 : 1; }

Weights half_sample(const Frames& frames, int k) {
    return weights_of(frames, [&](size_t p) { return chosen(frames, p, k); });
}

Weights all_but(const Frames& frames, size_t part) {
    return weights_of(frames, [&](size_t p) { return p != part; });
}

double degrees_of_freedom(const Frames& frames) {
    if (frames.size() < 2) return 0;
    double sum = 0, squares = 0, of_stratum[strata] = {};
    for (size_t p = 0; p < frames.size(); ++p) of_stratum[unit_of(frames, p).stratum] += double(frames[p]);
    for (const double w : of_stratum) sum += w, squares += w * w;
    return sum * sum / squares;
}

double variance_ratio(const Frames& frames) {
    const double n = double(std::accumulate(frames.begin(), frames.end(), int64_t(0)));
    double inverse = 0;
    for (int k = 0; k < half_samples; ++k) {
        int64_t of_half = 0;
        for (size_t p = 0; p < frames.size(); ++p) of_half += chosen(frames, p, k) ? frames[p] : 0;
        inverse += 1 / double(of_half) / half_samples;
    }
    return n * inverse;
}

}  // namespace uncertainty
