// SPDX-License-Identifier: BSD-3-Clause
// Means at the batches' ends, and what follows from their differences (batches.h).
#include "comfort/batches.h"

#include <cstdlib>

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

// Adds factor * (sum over the batch's frames), row 0 = top.
void Batches::add_sum(size_t batch, double factor, std::vector<float>& to) const {
    const float* end = ends_[batch].grey.data();
    const float at_end = float(factor * double(ends_[batch].frames));
    if (batch == 0) {
        for (size_t i = 0; i < to.size(); ++i) to[i] += at_end * end[i];
        return;
    }
    // b L'(b) - a L'(a) = (b - a) L'(b) + a (L'(b) - L'(a)): of two close floats the difference is exact
    const float* start = ends_[batch - 1].grey.data();
    const float growth = float(factor * double(frames(batch))), before = float(factor * double(begin(batch)));
    for (size_t i = 0; i < to.size(); ++i) to[i] += growth * end[i] + before * (end[i] - start[i]);
}

void Batches::without(size_t batch, GreyPicture& out) const {
    out.width = width_;
    out.height = height_;
    out.grey = ends_.back().grey;
    const double n = double(frames()), rest = n - double(frames(batch));
    const float share = float(n / rest);
    for (float& v : out.grey) v *= share;
    add_sum(batch, -1 / rest, out.grey);
}

size_t Batches::middle() const {
    if (count() < 2) return count();
    size_t best = 0;
    for (size_t k = 1; k + 1 < count(); ++k)
        if (std::abs(2 * ends_[k].frames - frames()) < std::abs(2 * ends_[best].frames - frames())) best = k;
    return best;
}

}  // namespace comfort
