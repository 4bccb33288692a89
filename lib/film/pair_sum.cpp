// SPDX-License-Identifier: BSD-3-Clause
// See pair_sum.h.
#include "film/pair_sum.h"

#include <algorithm>
#include <cstring>
#include <mutex>

#include "base/threads.h"
#include "base/wide.h"

namespace film {
namespace {

constexpr uint32_t magnitude = 0x7fffffff, infinite = 0x7f800000;

uint32_t bits_of(float v) {
    uint32_t bits;
    std::memcpy(&bits, &v, 4);
    return bits;
}
// The value, or 0 in place of one that is not finite.
uint32_t finite_bits(float v) {
    const uint32_t bits = bits_of(v);
    return bits & (0 - uint32_t((bits & magnitude) < infinite));
}
float finite(float v) {
    const uint32_t bits = finite_bits(v);
    std::memcpy(&v, &bits, 4);
    return v;
}

// As bits, which stand in the order of floats.
WIDE_LOOP PairSum::Extent extent_of(const float* values, size_t n) {
    uint32_t least = UINT32_MAX, most = 0, odd = 0;
    for (size_t i = 0; i < n; ++i) {
        const uint32_t bits = finite_bits(values[i]) & magnitude, less = bits - 1;  // of 0 the largest number
        odd |= bits_of(values[i]) ^ finite_bits(values[i]);
        most = bits > most ? bits : most;
        least = less < least ? less : least;
    }
    return {least + (most > 0), most, odd == 0};
}

WIDE_LOOP void add_to(const float* values, size_t n, double* high, double* low) {
    for (size_t i = 0; i < n; ++i) {
        const double v = double(finite(values[i])), h = high[i], sum = h + v, added = sum - h;
        high[i] = sum;
        low[i] += (h - (sum - added)) + (v - added);
    }
}

// Whether there is a rest.
WIDE_LOOP bool round(const double* high, const double* low, size_t n, double* nearest, double* rest) {
    uint64_t any = 0;
    for (size_t i = 0; i < n; ++i) {
        const double h = high[i], l = low[i], sum = h + l, added = sum - h;
        nearest[i] = sum;
        rest[i] = (h - (sum - added)) + (l - added);
    }
    for (size_t i = 0; i < n; ++i) {
        uint64_t bits;
        std::memcpy(&bits, rest + i, 8);
        any |= bits;
    }
    return any != 0;
}

}  // namespace

// All values are multiples of 2^lowest and below 2^highest.  Of n < 2^b values, the first double is below
// 2^(highest + b), and the second one, of n errors of half a unit in its last place, below 2^(highest + 2 b - 53).
bool PairSum::holds(const Extent& values, int64_t n) {
    if (values.most == 0) return true;
    int b = 0;
    while (n >> b > 0) ++b;
    const int highest = int(std::max(values.most >> 23, 1u)) - 126,
              lowest = int(std::max(values.least >> 23, 1u)) - 150;
    return highest + 2 * b - 53 - lowest <= 52;
}

bool PairSum::add(const std::vector<float>& values, unsigned threads, bool& finite) {
    Extent all = extent_;
    all.finite = true;
    std::mutex lock;
    base::in_shares(high_.size(), numbers_a_share, threads, [&](size_t from, size_t end) {
        const Extent here = extent_of(&values[from], end - from);
        const std::lock_guard<std::mutex> hold(lock);
        all = {std::min(all.least, here.least), std::max(all.most, here.most), all.finite && here.finite};
    });
    if (!holds(all, added_ + 1)) return false;
    extent_ = all;
    finite = all.finite;
    ++added_;
    base::in_shares(high_.size(), numbers_a_share, threads,
                    [&](size_t from, size_t end) { add_to(&values[from], end - from, &high_[from], &low_[from]); });
    return true;
}

bool PairSum::values(size_t i, size_t count, double* nearest, double* rest) const {
    return round(&high_[i], &low_[i], count, nearest, rest);
}

}  // namespace film
