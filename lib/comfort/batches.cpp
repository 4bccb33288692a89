// SPDX-License-Identifier: BSD-3-Clause
// Means at the batches' ends, and what follows from their differences (batches.h).
#include "comfort/batches.h"

#include <algorithm>
#include <cstdlib>

#include "image/picture.h"

namespace comfort {

Luminance GreyPicture::luminance() {
    Luminance out;
    out.width = width;
    out.height = height;
    out.grey = grey.data();
    return out;
}

void Batches::add(const Luminance& mean, int64_t n) {
    if (mean.width != width_ || mean.height != height_) ends_.clear();
    width_ = mean.width;
    height_ = mean.height;
    if (mean.grey != spare_.data()) spare_.assign(mean.grey, mean.grey + mean.size());
    ends_.push_back({n, std::move(spare_)});
    spare_ = image::forget_means(ends_, image::most_means);
}

void Batches::without(size_t batch, const std::vector<uint32_t>& pixels, GreyPicture& out) const {
    out.width = width_;
    out.height = height_;
    out.grey.resize(whole().size());
    const double n = double(frames()), rest = n - double(frames(batch));
    const float share = float(n / rest);
    // The batch's sum is b L'(b) - a L'(a) = (b - a) L'(b) + a (L'(b) - L'(a)): of two close floats the difference is
    // exact.
    const float* end = ends_[batch].grey.data();
    const float* start = batch ? ends_[batch - 1].grey.data() : end;
    const float growth = float(-1 / rest * double(frames(batch))), before = float(-1 / rest * double(begin(batch)));
    for (const uint32_t i : pixels) {
        out.grey[i] = whole()[i] * share;
        out.grey[i] += growth * end[i] + before * (end[i] - start[i]);
    }
}

Batches::Split Batches::halves() const {
    Split out{std::vector<bool>(count(), true), true};
    if (frames() < 2 * image::direct_samples && int64_t(count()) == frames()) {
        for (size_t k = 0; k < count(); ++k) out.first[k] = image::in_first_half(int64_t(k) + 1);
        return out;
    }
    size_t best = 0;
    for (size_t k = 1; k + 1 < count(); ++k)
        if (std::abs(2 * ends_[k].frames - frames()) < std::abs(2 * ends_[best].frames - frames())) best = k;
    std::fill(out.first.begin() + long(best) + 1, out.first.end(), false);
    out.knows_frame0 = ends_[best].frames >= image::direct_samples;
    return out;
}

}  // namespace comfort
