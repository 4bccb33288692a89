// SPDX-License-Identifier: BSD-3-Clause
// Means at the batches' ends, and what follows from their differences (batches.h).
#include "comfort/batches.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/wide.h"
#include "image/picture.h"

namespace comfort {
namespace {

constexpr double growth_between_looks = 1.41421356;
constexpr int64_t frames_of_halves = 2 * image::direct_samples;  // fewer are dealt to halves one by one

WIDE_LOOP void add_difference(float factor, const float* a, const float* b, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] += factor * (a[i] - b[i]);
}

WIDE_LOOP void set_difference(float factor, const float* a, const float* b, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] = factor * (a[i] - b[i]);
}

WIDE_LOOP void set_multiple(float factor, const float* a, size_t n, float* to) {
    for (size_t i = 0; i < n; ++i) to[i] = factor * a[i];
}

// Of the frames 1 to n.
int64_t in_first_half(int64_t n) {
    int64_t count = 0;
    for (int64_t k = 1; k <= n; ++k) count += image::in_first_half(k);
    return count;
}

}  // namespace

Luminance GreyPicture::luminance() {
    Luminance out;
    out.width = width;
    out.height = height;
    out.grey = grey.data();
    return out;
}

void Batches::restart() {
    for (image::GreyMean& m : middle_) release(std::move(m.grey));
    release(std::move(whole_));
    ends_.clear(), middle_.clear(), whole_.clear();
    whole_is_middle_ = false;
}

std::vector<float>& Batches::room_for_next() {
    if (spare_.empty() && !whole_is_middle_ && alternate_.empty()) release(std::exchange(whole_, {}));
    return room();
}

std::vector<float>& Batches::room() {
    if (spare_.empty() && !unused_.empty()) {
        spare_ = std::move(unused_.back());
        unused_.pop_back();
    }
    return spare_;
}

void Batches::release(std::vector<float>&& picture) {
    if (!picture.empty()) unused_.push_back(std::move(picture));
}

int64_t Batches::look_after(int64_t n) { return int64_t(std::ceil(double(n) * growth_between_looks)); }

void Batches::add(const Luminance& mean, int64_t n, int64_t next_look, std::optional<int64_t> last) {
    if (mean.width != width_ || mean.height != height_) restart();
    width_ = mean.width;
    height_ = mean.height;
    if (mean.grey != spare_.data()) room().assign(mean.grey, mean.grey + mean.size());
    const int64_t step = n - frames();
    std::vector<float> before = std::move(whole_);
    whole_ = std::move(spare_);
    spare_.clear();
    ends_.push_back({n, {}});
    for (const uint32_t i : watched_) ends_.back().grey.push_back(whole_[i]);
    const int64_t look = std::min(next_look, last.value_or(next_look));
    if (alternate() && look < frames_of_halves) follow_alternate(before, n);
    else release(std::exchange(alternate_, {}));
    if (whole_is_middle_) middle_.push_back({n - step, std::move(before)});
    else release(std::move(before));
    image::forget_means(ends_, image::most_means);
    // Half of the next look's frames, or of a later one's, is nearer to the next one.
    const int64_t next = std::max(n, alternate_.empty() ? look : frames_of_halves);
    while (middle_.size() > 1 && middle_[0].frames + middle_[1].frames < next) {
        release(std::move(middle_[0].grey));
        middle_.erase(middle_.begin());
    }
    whole_is_middle_ = may_be_half(n, step, next_look, last);
}

// If more means come in steps like the last one.
bool Batches::may_be_half(int64_t n, int64_t step, int64_t next_look, std::optional<int64_t> last) const {
    if (middle_.empty() || 3 * middle_.back().frames < n) return true;
    const auto is_half = [&](int64_t look) {
        const bool at_frames = step == 1 && alternate() && look < frames_of_halves;
        return !at_frames && std::abs(2 * n - look) <= step;
    };
    if (last && is_half(*last)) return true;
    for (int64_t due = next_look; due <= 2 * n + step;) {
        const int64_t look = n + std::max<int64_t>(0, due - n + step - 1) / step * step;
        if (is_half(look)) return true;
        due = look_after(look);
    }
    return false;
}

void Batches::without(size_t batch, GreyPicture& out) const {
    out.width = width_;
    out.height = height_;
    out.grey.resize(whole().size());
    const double n = double(frames()), rest = n - double(frames(batch));
    const float share = float(n / rest);
    // The batch's sum is b L'(b) - a L'(a) = (b - a) L'(b) + a (L'(b) - L'(a)): of two close floats the difference is
    // exact.
    const std::vector<float>& now = ends_.back().grey;
    const std::vector<float>& end = ends_[batch].grey;
    const std::vector<float>& start = batch ? ends_[batch - 1].grey : end;
    const float growth = float(-1 / rest * double(frames(batch))), before = float(-1 / rest * double(begin(batch)));
    for (size_t k = 0; k < watched_.size(); ++k) {
        const float all = now[k] * share;
        out.grey[watched_[k]] = all + (growth * end[k] + before * (end[k] - start[k]));
    }
}

bool Batches::alternate() const { return frames() < frames_of_halves && int64_t(count()) == frames(); }

// Frame n is L'(n) + (n - 1) (L'(n) - L'(n-1)), and L' has grown for those before it.
void Batches::follow_alternate(const std::vector<float>& before, int64_t n) {
    if (n == 1) return alternate_.assign(whole_.size(), 0);
    if (alternate_.empty()) return;
    const int64_t factor = (image::in_first_half(n) ? n - 1 : 0) - in_first_half(n - 1);
    add_difference(float(factor), whole_.data(), before.data(), alternate_.size(), alternate_.data());
}

Batches::Distance Batches::halves() const {
    if (!alternate_.empty()) {
        const double a = double(in_first_half(frames())), b = double(frames()) - a;
        return {float(1 / std::sqrt(a * b)), alternate_.data(), nullptr, true};
    }
    const auto nearer = [&](const image::GreyMean& m, const image::GreyMean& other) {
        return std::abs(2 * m.frames - frames()) < std::abs(2 * other.frames - frames());
    };
    const image::GreyMean& half = *std::min_element(middle_.begin(), middle_.end(), nearer);
    const double a = double(half.frames), b = double(frames()) - a;
    return {float(std::sqrt(a / b)), half.grey.data(), whole_.data(), half.frames >= image::direct_samples};
}

void Batches::Distance::find(size_t first, size_t n, float* d) const {
    if (from) set_difference(factor, of + first, from + first, n, d);
    else set_multiple(factor, of + first, n, d);
}

}  // namespace comfort
