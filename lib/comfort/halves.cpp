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

uint32_t row_of(unsigned row) {
    uint32_t bits = 0;
    for (unsigned column = 0; column < unsigned(Halves::count); ++column)
        bits |= uint32_t(negative(row, column)) << column;
    return bits;
}

}  // namespace

Halves::Halves() : signs_(count, {row_of(1), row_of(2), row_of(4), row_of(8)}) {}

bool Halves::take(const Batches& batches) {
    const bool found = begin(batches);
    for (int row = 0; found && row < height_; ++row) find_row(row);
    return found;
}

bool Halves::begin(const Batches& batches, std::vector<float>&& room) {
    if (batches.count() < 2) return false;
    if (!room.empty()) off_ = std::move(room);
    whole_ = &batches.whole();
    if (width_ != batches.width() || height_ != batches.height()) {
        width_ = batches.width(), height_ = batches.height();
        pattern_ = Signs::weave(width_, height_, 1);
    }
    off_.resize(whole_->size());
    apart_ = batches.halves();
    return true;
}

double Halves::degrees(const OffAtEye& off) {
    if (!(off.fourths > 0)) return sums;  // no pixel is off, or by no number
    return 1 / (1. / sums + off.fourths / (3 * off.squares * off.squares));
}

Swayed Halves::pictures() const { return {width_, height_, whole_->data(), off_.data(), pattern_.data(), &signs_}; }

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
