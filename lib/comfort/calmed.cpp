// SPDX-License-Identifier: BSD-3-Clause
// Few pixels are in doubt: they are found by their numbers (calmed.h).
#include "comfort/calmed.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"

namespace comfort {
namespace {

WIDE_LOOP bool one_exceeds(const float* mean, int n, float limit) {
    int found = 0;
    for (int i = 0; i < n; ++i) found |= mean[i] > limit;
    return found;
}

}  // namespace

float Calmed::most_in_doubt() const {
    float most = 0;
    for (const Doubtful& d : in_doubt_) most = std::max(most, d.mean + std::fabs(d.sway));
    return most;
}

const Doubtful* Calmed::from(size_t pixel) const {
    return std::lower_bound(in_doubt_.data(), end(), pixel, [](const Doubtful& d, size_t p) { return d.pixel < p; });
}

Calmed::Pixel Calmed::at(size_t pixel) const {
    const Doubtful* d = from(pixel);
    if (d == end() || d->pixel != pixel) return {lum_.mean[pixel], 0};
    return {d->mean, d->sway};
}

bool Calmed::doubtful_exceeds(size_t first, int n, float limit) const {
    for (const Doubtful* d = from(first); d != end() && d->pixel < first + size_t(n); ++d)
        if (d->mean + std::fabs(d->sway) > limit) return true;
    return false;
}

bool Calmed::mean_exceeds(size_t first, int n, float limit) const { return one_exceeds(lum_.mean + first, n, limit); }

GreyPicture Calmed::mean() const {
    GreyPicture out{lum_.width, lum_.height, {lum_.mean, lum_.mean + size_t(lum_.width) * size_t(lum_.height)}};
    for (const Doubtful& d : in_doubt_) out.grey[d.pixel] = d.mean;
    return out;
}

void Calmed::picture(int number, GreyPicture& out) const {
    out = mean();
    for (const Doubtful& d : in_doubt_)
        out.grey[d.pixel] = lum_.minus(d.pixel) >> number & 1 ? d.mean - d.sway : d.mean + d.sway;
}

}  // namespace comfort
