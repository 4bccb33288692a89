// SPDX-License-Identifier: BSD-3-Clause
// See difference.h.
#include "uncertainty/difference.h"

#include <algorithm>
#include <cmath>

#include "base/hypot.h"

namespace uncertainty {
namespace {

Values less(const Values& a, Values b) {
    for (size_t c = 0; c < b.size(); ++c) b[c] -= a[c];
    return b;
}

// Differences of the images that both have.
std::vector<Values> less(const std::vector<Values>& a, std::vector<Values> b) {
    b.resize(std::min(a.size(), b.size()));
    for (size_t k = 0; k < b.size(); ++k) b[k] = less(a[k], b[k]);
    return b;
}

// The pairs of one run alone stay as they are: only their differences count.
std::vector<Values> less_pairs(const std::vector<Values>& a, const std::vector<Values>& b) {
    return a.empty() ? b : b.empty() ? a : less(a, b);
}

Replicates less(const Replicates& a, Replicates b) {
    b.whole = less(a.whole, b.whole), b.decided = less(a.decided, b.decided);
    b.half_samples = less(a.half_samples, b.half_samples), b.without = less(a.without, b.without);
    b.frame0_pairs = less_pairs(a.frame0_pairs, b.frame0_pairs);
    b.lasting_pairs = less_pairs(a.lasting_pairs, b.lasting_pairs);
    return b;
}

Estimate independent(const Estimate& a, Estimate b) {
    b.value -= a.value;
    if (!a.known() || !b.known()) b.error = std::nan("");
    add_error(b, a.error * a.error, a.degrees);
    b.lasting = base::hypot(a.lasting, b.lasting);
    if (a.error > 0) b.skewness -= a.skewness * std::pow(a.error / b.error, 3);
    return b;
}

}  // namespace

Replicates select(const Replicates& of, const std::vector<size_t>& quantities) {
    Replicates out = of;
    const auto choose = [&](Values& v) {
        Values chosen;
        for (const size_t q : quantities) chosen.push_back(v[q]);
        v = std::move(chosen);
    };
    choose(out.whole);
    if (!out.decided.empty()) choose(out.decided);
    for (auto* images : {&out.half_samples, &out.without, &out.frame0_pairs, &out.lasting_pairs})
        std::for_each(images->begin(), images->end(), choose);
    return out;
}

bool same_frames(const Replicates& a, const Replicates& b) { return a.frames == b.frames && a.from == b.from; }

std::vector<Estimate> difference(const Replicates& a, const Replicates& b, const std::vector<Quantity>& quantities) {
    if (same_frames(a, b)) return estimate(less(a, b), quantities);
    const std::vector<Estimate> of_a = estimate(a, quantities);
    std::vector<Estimate> out = estimate(b, quantities);
    for (size_t c = 0; c < out.size(); ++c) out[c] = independent(of_a[c], out[c]);
    return out;
}

}  // namespace uncertainty
