// SPDX-License-Identifier: BSD-3-Clause
// See exact_sum.h.
#include "image/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace image {
namespace {

constexpr uint64_t low_half = 0xffffffff;
constexpr uint32_t room = 1u << 29;

// The widest lanes of the processor that runs it, for loops over all pixels.  (Sanitizers start before such a choice.)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define WIDE_LOOP __attribute__((target_clones("avx2", "default")))
#else
#define WIDE_LOOP
#endif

// What floats add to the sums' digits `digit` and the one above, a few at a time: without branches, so that they are
// taken side by side.
struct Terms {
    static constexpr size_t room = 256;
    int64_t digit[room], low[room], high[room];
};

WIDE_LOOP void split(const float* values, size_t count, Terms& terms) {
    for (size_t i = 0; i < count; ++i) {
        uint32_t bits;
        std::memcpy(&bits, values + i, 4);
        const uint32_t field = bits << 1 >> 24, exponent = field > 0 ? field - 1 : 0;
        const uint32_t fraction = field == 0xff ? 0 : (bits & 0x7fffff) | (field > 0 ? 0x800000 : 0);
        const uint64_t wide = uint64_t(fraction) << (exponent & 31);
        const int64_t sign = -int64_t(bits >> 31);
        terms.digit[i] = exponent >> 5;
        terms.low[i] = (int64_t(wide & low_half) ^ sign) - sign;
        terms.high[i] = (int64_t(wide >> 32) ^ sign) - sign;
    }
}

WIDE_LOOP void add_terms(const Terms& terms, size_t count, int64_t digit, int64_t* lane) {
    for (size_t i = 0; i < count; ++i)
        lane[i] += (terms.digit[i] == digit ? terms.low[i] : 0) + (terms.digit[i] == digit - 1 ? terms.high[i] : 0);
}

// Exponent fields of the least and the greatest value that are not 0.
WIDE_LOOP void exponents(const float* values, size_t count, uint32_t& least, uint32_t& most) {
    uint32_t lo = least, hi = most;
    for (size_t i = 0; i < count; ++i) {
        uint32_t bits;
        std::memcpy(&bits, values + i, 4);
        const uint32_t field = bits << 1 >> 24, exponent = field > 0 ? field : 1;
        const uint32_t seen = bits << 1 ? exponent : 0xff;
        lo = seen < lo ? seen : lo;
        hi = exponent > hi ? exponent : hi;
    }
    least = lo;
    most = hi;
}

// A word of ones or of zeros, as the sign goes on above this word.
uint32_t sign_of(uint32_t word) { return word >> 31 ? 0xffffffffu : 0; }

}  // namespace

void ExactSum::clear(size_t count) {
    count_ = count;
    added_ = 0;
    lowest_ = digits, end_ = 0;
    for (auto& lane : lane_) lane.clear();
}

void ExactSum::reach(int first, int last) {
    lowest_ = std::min(lowest_, first), end_ = std::max(end_, last + 1);
    for (int k = lowest_; k < end_; ++k)
        if (lane_[size_t(k)].empty()) lane_[size_t(k)].assign(count_, 0);
}

void ExactSum::about_to_add() {
    if (++added_ >= room) carry();
}

// A float's 24 bits lie in two digits at most.
bool ExactSum::add(const std::vector<float>& values) {
    about_to_add();
    constexpr uint32_t not_finite = 0xff;
    uint32_t least = not_finite, most = 1;  // exponent fields of those that are not 0
    exponents(values.data(), count_, least, most);
    if (least == not_finite) return most != not_finite;
    const int first = int(least - 1) / 32, last = int(most - 1) / 32 + 1;
    reach(first, last);

    Terms terms;
    for (size_t i = 0; i < count_; i += Terms::room) {
        const size_t n = std::min(Terms::room, count_ - i);
        split(&values[i], n, terms);
        for (int k = first; k <= last; ++k) add_terms(terms, n, k, &lane_[size_t(k)][i]);
    }
    return most != not_finite;
}

void ExactSum::add(const std::vector<double>& values) {
    about_to_add();
    for (size_t i = 0; i < count_; ++i) {
        if (!(std::fabs(values[i]) < 0x1p164) || values[i] == 0) continue;
        int exponent;
        auto mantissa = uint64_t(std::ldexp(std::frexp(std::fabs(values[i]), &exponent), 53));
        int place = exponent - 53 + 149;
        if (place < 0) mantissa = place > -64 ? mantissa >> -place : 0, place = 0;
        const int digit = place / 32, shift = place % 32;
        const int64_t sign = values[i] < 0 ? -1 : 1;
        const uint64_t low = (mantissa & low_half) << shift;
        const uint64_t high = ((mantissa >> 32) << shift) + (low >> 32);
        reach(digit, high >> 32 ? digit + 2 : high ? digit + 1 : digit);
        lane_[size_t(digit)][i] += sign * int64_t(low & low_half);
        if (high) lane_[size_t(digit) + 1][i] += sign * int64_t(high & low_half);
        if (high >> 32) lane_[size_t(digit) + 2][i] += sign * int64_t(high >> 32);
    }
}

void ExactSum::add(const std::vector<SumLayer>& layers, const std::string& place) {
    about_to_add();
    for (size_t n = 0; n < layers.size(); ++n) {
        const SumLayer& layer = layers[n];
        if (layer.digit < 0 || layer.digit >= digits || layer.digit != layers[0].digit + int(n))
            base::fail(place, "its layers of exact sums have a gap, or a number that there is not");
        if (layer.words.size() != count_) base::fail(place, "its layers of exact sums have another size");
        reach(layer.digit, layer.digit);
        std::vector<int64_t>& lane = lane_[size_t(layer.digit)];
        const bool highest = n + 1 == layers.size();
        for (size_t i = 0; i < count_; ++i)
            lane[i] += highest ? int64_t(int32_t(layer.words[i])) : int64_t(layer.words[i]);
    }
}

// Of the words those from lowest_ to end_ are set; the last one has the sign.
ExactSum::Number ExactSum::number(size_t i) const {
    Number n;
    int64_t carried = 0;
    for (int k = lowest_; k <= end_; ++k) {
        if (k < end_) carried += lane_[size_t(k)][i];
        n[size_t(k)] = uint32_t(uint64_t(carried) & low_half);
        carried >>= 32;
    }
    return n;
}

// Before a lane of 64 bits could overflow.
void ExactSum::carry() {
    added_ = 1;
    if (end_ < digits) reach(end_, end_);
    for (int k = lowest_; k + 1 < end_; ++k) {
        std::vector<int64_t>&lane = lane_[size_t(k)], &next = lane_[size_t(k) + 1];
        for (size_t i = 0; i < count_; ++i) {
            next[i] += lane[i] >> 32;
            lane[i] &= int64_t(low_half);
        }
    }
}

double ExactSum::value(size_t i) const {
    static const std::array<double, digits + 3> worth = [] {  // of a digit, from two below the lowest up
        std::array<double, digits + 3> all;
        for (int k = 0; k < digits + 3; ++k) all[size_t(k)] = std::ldexp(1., 32 * (k - 2) - 149);
        return all;
    }();
    if (lowest_ >= end_) return 0;
    Number n = number(i);
    const bool negative = sign_of(n[size_t(end_)]) != 0;
    uint64_t carried = 1;
    for (int k = lowest_; negative && k <= end_; ++k) {
        carried += uint32_t(~n[size_t(k)]);
        n[size_t(k)] = uint32_t(carried & low_half);
        carried >>= 32;
    }
    int top = end_;
    while (top > lowest_ && n[size_t(top)] == 0) --top;
    const auto word = [&](int k) { return k < lowest_ ? 0 : uint64_t(n[size_t(k)]); };
    const double leading = double(word(top) << 32 | word(top - 1)) * 4294967296. + double(word(top - 2));
    const double magnitude = leading * worth[size_t(top)];
    return negative ? -magnitude : magnitude;
}

std::vector<SumLayer> ExactSum::layers() const {
    if (lowest_ >= end_) return {};
    const int end = std::min(end_ + 1, digits);
    std::vector<SumLayer> all;
    for (int k = lowest_; k < end; ++k) all.push_back({k, std::vector<uint32_t>(count_)});
    for (size_t i = 0; i < count_; ++i) {
        const Number n = number(i);
        for (SumLayer& layer : all) layer.words[i] = n[size_t(layer.digit)];
    }
    const auto only_sign = [&](size_t k) {  // of the layer below
        for (size_t i = 0; i < count_; ++i)
            if (all[k].words[i] != sign_of(k > 0 ? all[k - 1].words[i] : 0)) return false;
        return true;
    };
    const auto is_zero = [](uint32_t w) { return w == 0; };
    while (!all.empty() && only_sign(all.size() - 1)) all.pop_back();
    while (!all.empty() && std::all_of(all[0].words.begin(), all[0].words.end(), is_zero)) all.erase(all.begin());
    return all;
}

}  // namespace image
