// SPDX-License-Identifier: BSD-3-Clause
// See exact_block.h.
#include "image/exact_block.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace image {
namespace {
constexpr uint64_t low_half = 0xffffffff;
}

void ExactBlock::Digits::reach(int first, int last) {
    if (has(first) && has(last)) return;
    const int new_lowest = std::min(lowest, first), new_end = std::max(end, last + 1);
    std::vector<int64_t> more(size_t(new_end - new_lowest) * room);
    if (lowest < end) std::copy(lane.begin(), lane.end(), &more[size_t(lowest - new_lowest) * room]);
    lowest = new_lowest, end = new_end;
    lane.swap(more);
}

bool ExactBlock::add(const float* values, size_t count) {
    exact::Exponents here;
    exact::widen(here, values, count);
    if (held_.take(here)) {
        exact::add(values, count, sum_);
        return true;
    }
    if (!here.finite()) {
        float finite[room];
        for (size_t i = 0; i < count; ++i) finite[i] = std::isfinite(values[i]) ? values[i] : 0;
        add(finite, count);
        return false;
    }
    to_digits();
    if (held_.take(here)) {
        exact::add(values, count, sum_);
    } else {
        digits_.reach(here.first_digit(), here.last_digit());
        for (size_t i = 0; i < count; ++i) add_to_digits(values[i], i);
    }
    return true;
}

void ExactBlock::to_digits() {
    if (!held_.any()) return;
    digits_.reach(held_.first_digit(), held_.last_digit());
    exact::add_digits(sum_, held_, digits_.at(held_.first_digit()));
    std::fill_n(sum_, room, 0.);
    held_ = {};
}

// A float's 24 bits lie in two digits at most.
void ExactBlock::add_to_digits(float value, size_t i) {
    if (value == 0) return;
    uint32_t bits;
    std::memcpy(&bits, &value, 4);
    const uint32_t field = bits << 1 >> 24, exponent = field > 0 ? field - 1 : 0;
    const uint64_t wide = uint64_t((bits & 0x7fffff) | (field > 0 ? 0x800000 : 0)) << (exponent & 31);
    const int64_t sign = bits >> 31 ? -1 : 1;
    digits_.at(int(exponent >> 5))[i] += sign * int64_t(wide & low_half);
    if (wide >> 32) digits_.at(int(exponent >> 5) + 1)[i] += sign * int64_t(wide >> 32);
}

void ExactBlock::add(double value, size_t i) {
    if (!(std::fabs(value) < 0x1p164) || value == 0) return;
    int exponent;
    auto mantissa = uint64_t(std::ldexp(std::frexp(std::fabs(value), &exponent), 53));
    int place = exponent - 53 + 149;
    if (place < 0) mantissa = place > -64 ? mantissa >> -place : 0, place = 0;
    const int k = place / 32, shift = place % 32;
    const int64_t sign = value < 0 ? -1 : 1;
    const uint64_t low = (mantissa & low_half) << shift;
    const uint64_t high = ((mantissa >> 32) << shift) + (low >> 32);
    digit(k)[i] += sign * int64_t(low & low_half);
    if (high) digit(k + 1)[i] += sign * int64_t(high & low_half);
    if (high >> 32) digit(k + 2)[i] += sign * int64_t(high >> 32);
}

int64_t* ExactBlock::digit(int k) {
    digits_.reach(k, k);
    return digits_.at(k);
}

void ExactBlock::carry() {
    if (digits_.lowest >= digits_.end) return;
    if (digits_.end < digits) digits_.reach(digits_.end, digits_.end);
    for (int k = digits_.lowest; k + 1 < digits_.end; ++k) {
        int64_t *lane = digits_.at(k), *next = digits_.at(k + 1);
        for (size_t i = 0; i < room; ++i) {
            next[i] += lane[i] >> 32;
            lane[i] &= int64_t(low_half);
        }
    }
}

ExactBlock::Digits ExactBlock::all_digits() const {
    Digits all = digits_;
    if (held_.any()) {
        all.reach(held_.first_digit(), held_.last_digit());
        exact::add_digits(sum_, held_, all.at(held_.first_digit()));
    }
    return all;
}

const double* ExactBlock::values(double* space) const {
    if (digits_.lane.empty()) return sum_;
    const Digits all = all_digits();
    exact::to_doubles(all.lane.data(), all.end - all.lowest, std::ldexp(1., 32 * all.lowest - 149), space);
    return space;
}

}  // namespace image
