// SPDX-License-Identifier: BSD-3-Clause
// See merge_means.h.
#include "image/merge_means.h"

#include <algorithm>
#include <tuple>

#include "base/error.h"
#include "image/grey.h"

namespace image {
namespace {

std::vector<float> grey_of(const std::vector<float>& rgb) {
    std::vector<float> grey(rgb.size() / 3);
    to_grey(rgb.data(), grey.size(), grey.data());
    return grey;
}

}  // namespace

void MeansMerger::add(const Picture& picture, size_t seed, const std::string& name) {
    const Header& h = picture.header;
    ++inputs_;
    only_ = inputs_ == 1 ? picture.means : std::vector<GreyMean>();
    if (*h.frames == 0) return;
    if (picture.means.empty()) without_ = name;
    if (picture.means.empty() && picture.sum.empty()) coarse_ = name;
    if (!coarse_.empty()) return batches_.clear();

    std::vector<GreyMean> means = picture.means;
    add_mean(means, *h.frames, picture.rgb, most_means + 1);
    const std::vector<float> frame0 = grey_of(picture.frame0);
    const GreyMean* before = nullptr;
    for (const GreyMean& end : means) {
        const double a = before ? double(before->frames) : 0, b = double(end.frames);
        Batch batch{seed, h.ranges.front().first + int64_t(a), int64_t(b - a), end.grey};
        for (size_t i = 0; i < batch.grey.size(); ++i) {
            const double sum = b * end.grey[i] - (before ? a * before->grey[i] : 0);
            batch.grey[i] = float(sum / (b - a) - (frame0.empty() ? 0 : double(frame0[i])));
        }
        insert(std::move(batch));
        before = &end;
    }
    join();
}

void MeansMerger::insert(Batch batch) {
    const auto order = [](const Batch& x, const Batch& y) {
        return std::tie(x.seed, x.first) < std::tie(y.seed, y.first);
    };
    batches_.insert(std::upper_bound(batches_.begin(), batches_.end(), batch, order), std::move(batch));
}

// Neighbours of one seed that hold the fewest frames together, until there are few enough.
void MeansMerger::join() {
    while (batches_.size() > most()) {
        size_t least = batches_.size();
        const auto frames = [&](size_t k) { return batches_[k].frames + batches_[k + 1].frames; };
        for (size_t k = 0; k + 1 < batches_.size(); ++k)
            if (batches_[k].seed == batches_[k + 1].seed && (least == batches_.size() || frames(k) < frames(least)))
                least = k;
        if (least == batches_.size()) return;  // more seeds than batches: result() joins them
        Batch &to = batches_[least], &from = batches_[least + 1];
        const double a = double(to.frames), b = double(from.frames);
        for (size_t i = 0; i < to.grey.size(); ++i) to.grey[i] = float((a * to.grey[i] + b * from.grey[i]) / (a + b));
        to.frames += from.frames;
        batches_.erase(batches_.begin() + std::ptrdiff_t(least) + 1);
    }
}

void MeansMerger::result(const std::vector<const std::vector<float>*>& frame0, Picture& merged) const {
    merged.means.clear();
    if (!most_ && !without_.empty()) return;
    if (!coarse_.empty())
        return base::warn(coarse_, "holds no batches and no exact sum of frames to be one: no batches are kept");
    if (!only_.empty()) {
        merged.means = only_;
        forget_means(merged.means, most());
        return;
    }
    std::vector<double> sum(merged.rgb.size() / 3, 0);
    std::vector<float> zero;
    int64_t frames = 0, of_seed = 0;
    for (size_t k = 0; k < batches_.size(); ++k) {
        const Batch& batch = batches_[k];
        const bool begins = k == 0 || batches_[k - 1].seed != batch.seed;
        const bool ends = k + 1 == batches_.size() || batches_[k + 1].seed != batch.seed;
        if (begins) zero = grey_of(*frame0[batch.seed]), of_seed = 0;
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += double(batch.frames) * (double(batch.grey[i]) + (zero.empty() ? 0 : double(zero[i])));
        frames += batch.frames, of_seed += batch.frames;
        // Frames of another seed that share the direct samples of its frame 0 must not be batches beside each other.
        if (batch.seed > 0 && of_seed < direct_samples && !ends) continue;
        GreyMean mean{frames, std::vector<float>(sum.size())};
        for (size_t i = 0; i < sum.size(); ++i) mean.grey[i] = float(sum[i] / double(frames));
        merged.means.push_back(std::move(mean));
    }
    forget_means(merged.means, most());
}

}  // namespace image
