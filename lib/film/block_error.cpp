// SPDX-License-Identifier: BSD-3-Clause
// See block_error.h.
#include "film/block_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "image/grey.h"

namespace film {

namespace {
constexpr size_t side = 8;
constexpr double share = .98;          // of the blocks, the nearest ones
constexpr int64_t least_freedom = 30;  // degrees of freedom, of all blocks together
}  // namespace

std::vector<double> BlockError::sums_of(const image::Picture& picture) const {
    const size_t width = size_t(picture.width), across = (width + side - 1) / side;
    std::vector<double> sums(across * ((size_t(picture.height) + side - 1) / side));
    const float* rgb = picture.rgb.data();
    for (size_t y = 0; y < size_t(picture.height); ++y)
        for (size_t x = 0; x < width; ++x, rgb += 3) sums[y / side * across + x / side] += image::grey(rgb);
    return sums;
}

void BlockError::restart(const image::Picture& frame0) {
    frames_ = 0;
    frame0_ = sums_of(frame0);
    sum_.assign(frame0_.size(), 0);
    squares_ = sum_;
}

void BlockError::add(const image::Picture& frame) {
    const std::vector<double> sums = sums_of(frame);
    if (frames_++ == 0 && sum_.empty()) frame0_ = sum_ = squares_ = std::vector<double>(sums.size());  // no frame 0
    for (size_t i = 0; i < sums.size(); ++i) {
        sum_[i] += sums[i];
        squares_[i] += sums[i] * sums[i];
    }
}

double BlockError::relative() const {
    if ((frames_ - 1) * int64_t(sum_.size()) < least_freedom) return std::numeric_limits<double>::infinity();
    const double n = double(frames_);
    std::vector<double> errors;  // squared, of the blocks that are not black
    for (size_t i = 0; i < sum_.size(); ++i) {
        const double mean = frame0_[i] + sum_[i] / n;
        const double variance = std::max(0.0, squares_[i] - sum_[i] * sum_[i] / n) / (n * (n - 1));
        if (mean > 0) errors.push_back(variance / (mean * mean));
    }
    const auto end = errors.begin() + long(std::ceil(share * double(errors.size())));
    if (end == errors.begin()) return 0;
    if (end != errors.end()) std::nth_element(errors.begin(), end, errors.end());
    return std::sqrt(std::accumulate(errors.begin(), end, 0.0) / double(end - errors.begin()));
}

}  // namespace film
