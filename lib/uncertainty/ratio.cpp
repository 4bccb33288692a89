// SPDX-License-Identifier: BSD-3-Clause
// See ratio.h.
#include "uncertainty/ratio.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "uncertainty/difference.h"

namespace uncertainty {
namespace {

// Ratios of two lists of images; of one that is empty all images are the whole mean.
std::vector<Values> over_each(const std::vector<Values>& a, double whole_a, size_t of_a, const std::vector<Values>& b,
                              double whole_b, size_t of_b) {
    std::vector<Values> out(std::max(a.size(), b.size()));
    for (size_t k = 0; k < out.size(); ++k)
        out[k] = {(k < a.size() ? a[k][of_a] : whole_a) / (k < b.size() ? b[k][of_b] : whole_b)};
    return out;
}

Replicates replicates_of(const Measured& over, const Measured& under) {
    const Replicates &a = *over.replicates, &b = *under.replicates;
    const double whole_a = a.whole[over.quantity], whole_b = b.whole[under.quantity];
    const auto each = [&](const std::vector<Values> Replicates::*images) {
        return over_each(a.*images, whole_a, over.quantity, b.*images, whole_b, under.quantity);
    };
    Replicates out;
    out.frames = a.frames, out.from = a.from;
    out.whole = out.decided = {whole_a / whole_b};
    out.half_samples = each(&Replicates::half_samples);
    out.frame0_pairs = each(&Replicates::frame0_pairs), out.lasting_pairs = each(&Replicates::lasting_pairs);
    return out;
}

bool are_pairs(const Measured& over, const Measured& under) {
    return over.replicates->frames.size() >= 2 && same_frames(*over.replicates, *under.replicates);
}

// Relative errors add up, as do those of small ones.
Estimate independent_ratio(const Estimate& over, const Estimate& under) {
    Estimate out = over;
    out.value = over.value / under.value;
    out.error = over.error / under.value;
    if (!over.known() || !under.known()) out.error = std::numeric_limits<double>::quiet_NaN();
    add_error(out, std::pow(out.value * under.error / under.value, 2), under.degrees);
    out.frames = std::min(over.frames, under.frames);
    return out;
}

}  // namespace

Estimate ratio(const Measured& over, const Measured& under) {
    if (!are_pairs(over, under)) return independent_ratio(over.estimate, under.estimate);
    return estimate(replicates_of(over, under), {{Quantity::Method::half_samples, NoiseBias::none, 0, false, 2}})[0];
}

std::vector<double> ratio_of_half_samples(const Measured& over, const Measured& under) {
    std::vector<double> out;
    if (!are_pairs(over, under)) return out;
    for (const Values& v : replicates_of(over, under).half_samples) out.push_back(v[0]);
    return out;
}

}  // namespace uncertainty
