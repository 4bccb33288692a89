// SPDX-License-Identifier: BSD-3-Clause
// The first half of the frames against the second, pixel by pixel (halves.h).
#include "comfort/halves.h"

#include <algorithm>
#include <cmath>

namespace comfort {
namespace {

// Element of the Hadamard matrix of Sylvester: -1 where row and column have an odd number of bits in common.
bool negative(unsigned row, unsigned column) {
    unsigned bits = row & column;
    bits ^= bits >> 2;
    bits ^= bits >> 1;
    return bits & 1;
}

// Rows 1 to 15, each as it is and turned round.
std::vector<uint16_t> sign_patterns() {
    std::vector<uint16_t> out;
    for (unsigned row = 1; row < unsigned(Halves::count); ++row) {
        unsigned bits = 0;
        for (unsigned column = 0; column < unsigned(Halves::count); ++column)
            bits |= unsigned(negative(row, column)) << column;
        out.push_back(uint16_t(bits));
        out.push_back(uint16_t(~bits));
    }
    return out;
}

}  // namespace

bool Halves::take(const Batches& batches) {
    const size_t middle = batches.middle();
    if (middle == batches.count()) return false;
    whole_ = &batches.whole();
    if (width_ != batches.width() || height_ != batches.height()) {
        width_ = batches.width(), height_ = batches.height();
        const std::vector<uint16_t> patterns = sign_patterns();
        uint32_t random = 1;
        signs_.resize(whole_->size());
        pattern_.resize(whole_->size());
        for (size_t i = 0; i < signs_.size(); ++i) {
            random = random * 1664525u + 1013904223u;
            pattern_[i] = uint8_t((uint64_t(random) * patterns.size()) >> 32);
            signs_[i] = patterns[pattern_[i]];
        }
    }
    const double a = double(batches.begin(middle) + batches.frames(middle)), b = double(batches.frames()) - a;
    const float factor = float(std::sqrt(a / b));
    const std::vector<float>& first = batches.mean_at(middle);
    off_.resize(whole_->size());
    for (size_t i = 0; i < off_.size(); ++i) off_[i] = factor * (first[i] - (*whole_)[i]);
    return true;
}

void Halves::picture(int number, GreyPicture& out) const {
    out.width = width_, out.height = height_;
    out.grey.resize(off_.size());
    for (size_t i = 0; i < off_.size(); ++i) out.grey[i] = swayed(number, i, (*whole_)[i], off_[i]);
}

std::array<double, Halves::count> Halves::sums(const std::vector<double>& weight) const {
    const std::vector<uint16_t> patterns = sign_patterns();
    std::vector<double> off(patterns.size(), 0);
    double whole = 0;
    for (size_t i = 0; i < off_.size(); ++i) {
        const double w = std::max(weight[i], 0.);
        whole += w * double((*whole_)[i]);
        off[pattern_[i]] += w * double(off_[i]);
    }
    std::array<double, count> out;
    for (int k = 0; k < count; ++k) {
        out[size_t(k)] = whole;
        for (size_t p = 0; p < patterns.size(); ++p) out[size_t(k)] += patterns[p] >> k & 1 ? -off[p] : off[p];
    }
    return out;
}

Halves::Variance Halves::variance(const double* values) {
    Variance out;
    for (unsigned row = 1; row < unsigned(count); ++row) {
        double sum = 0;
        for (unsigned k = 0; k < unsigned(count); ++k) sum += negative(row, k) ? -values[k] : values[k];
        const double square = std::pow(sum / count, 2);
        out.sum += square, out.largest = std::max(out.largest, square);
    }
    return out;
}

double Halves::without_bias(double whole, const double* values, double r) {
    double mean = 0;
    for (int k = 0; k < count; ++k) mean += values[k] / count;
    return (r * whole - mean) / (r - 1);
}

}  // namespace comfort
