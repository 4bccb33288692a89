// SPDX-License-Identifier: BSD-3-Clause
// Half pictures, and what they say of the whole one (unbiased.h).
#include "comfort/unbiased.h"

#include <cmath>

namespace comfort {
namespace {

// f(a, b, weight) for every pair of parts that holds a frame; the weights sum to 1.
template <class Function>
void for_pairs(const Batches::Parts& parts, const Function& f) {
    double all = 0;
    for (const int64_t n : parts.frames) all += double(n);
    for (int a = 0; a < Batches::parts; ++a)
        for (int b = a + 1; b < Batches::parts; ++b) {
            const double n = double(parts.frames[a] + parts.frames[b]);
            if (n > 0) f(a, b, n / ((Batches::parts - 1) * all));
        }
}

}  // namespace

double noise_of_halves(const Batches::Parts& parts, double power) {
    double sum = 0;
    for_pairs(parts, [&](int, int, double weight) {
        sum += weight * std::pow(1 / ((Batches::parts - 1) * weight), power);  // the pair's share of all frames
    });
    return sum;
}

double extrapolated(double whole, double halves, double noise) { return (noise * whole - halves) / (noise - 1); }

HalvesSources sources_of_halves(SourceFinder& finder, const Batches::Parts& parts, const Settings& settings,
                                double threshold) {
    HalvesSources out;
    GreyPicture half = parts.mean[0];
    for_pairs(parts, [&](int a, int b, double weight) {
        const double all = double(parts.frames[a] + parts.frames[b]);
        const float share_a = float(double(parts.frames[a]) / all), share_b = float(double(parts.frames[b]) / all);
        const float *from_a = parts.mean[a].grey.data(), *from_b = parts.mean[b].grey.data();
        for (size_t i = 0; i < half.grey.size(); ++i) half.grey[i] = share_a * from_a[i] + share_b * from_b[i];
        const Luminance lum = half.luminance();
        GlareTerms terms = glare_terms(finder, lum, settings, threshold, finder.find(lum, threshold));
        for (GlareTerm& t : terms) t.weight = weight;
        out.terms.insert(out.terms.end(), terms.begin(), terms.end());
        out.direct_lux += weight * finder.direct_lux();
    });
    return out;
}

}  // namespace comfort
