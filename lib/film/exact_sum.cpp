// SPDX-License-Identifier: BSD-3-Clause
// See exact_sum.h.
#include "film/exact_sum.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/threads.h"

namespace film {
namespace {

constexpr uint32_t most_added = 1u << 29;
constexpr double two_32 = 4294967296.;

// A float: 24 bits or fewer, in digit `digit` and the next one.
struct Split {
    int digit;
    int64_t low, high;
};
Split split(float value) {
    uint32_t bits;
    std::memcpy(&bits, &value, 4);
    const uint32_t field = bits << 1 >> 24, exponent = field > 0 ? field - 1 : 0;
    const uint64_t wide = uint64_t((bits & 0x7fffff) | (field > 0 ? 0x800000 : 0)) << (exponent & 31);
    const int64_t sign = bits >> 31 ? -1 : 1;
    return {int(exponent >> 5), sign * int64_t(uint32_t(wide)), sign * int64_t(wide >> 32)};
}

// A word of ones or of zeros, as the sign goes on above this word.
uint32_t sign_of(uint32_t word) { return word >> 31 ? 0xffffffffu : 0; }

// Without the layers above that only go on with the sign, and those below that are 0.
std::vector<image::SumLayer> without_empty(std::vector<image::SumLayer> all) {
    const auto only_sign = [&](size_t k) {  // of the layer below
        for (size_t i = 0; i < all[k].words.size(); ++i)
            if (all[k].words[i] != sign_of(k > 0 ? all[k - 1].words[i] : 0)) return false;
        return true;
    };
    const auto is_zero = [](uint32_t w) { return w == 0; };
    while (!all.empty() && only_sign(all.size() - 1)) all.pop_back();
    while (!all.empty() && std::all_of(all[0].words.begin(), all[0].words.end(), is_zero)) all.erase(all.begin());
    return all;
}

}  // namespace

void ExactSum::clear(size_t count) {
    *this = {};
    count_ = count;
    pairs_.emplace(count);
}

void ExactSum::use_digits() {
    if (!pairs_) return;
    std::vector<double> nearest(count_), rest(count_);
    pairs_->values(0, count_, nearest.data(), rest.data());
    pairs_.reset();
    add(nearest);
    add(rest);
}

// Carries before a lane could overflow.
void ExactSum::about_to_add() {
    if (++added_ < most_added || lowest_ >= end_) return;
    added_ = 1;
    reach(lowest_, std::min(end_, digits - 1));
    for (int k = lowest_; k + 1 < end_; ++k)
        for (size_t i = 0; i < count_; ++i) {
            lane_[k + 1][i] += lane_[k][i] >> 32;
            lane_[k][i] = int64_t(uint32_t(lane_[k][i]));
        }
}

// Makes digits `first` to `last`, and those between them and the others.
void ExactSum::reach(int first, int last) {
    lowest_ = std::min(lowest_, first), end_ = std::max(end_, last + 1);
    unit_ = std::ldexp(1., 32 * lowest_ - 149);
    for (int k = lowest_; k < end_; ++k) lane_[k].resize(count_);
}

bool ExactSum::add(const std::vector<float>& values, unsigned threads) {
    bool all_finite = true;
    if (pairs_ && pairs_->add(values, threads, all_finite)) return all_finite;
    use_digits();
    about_to_add();
    std::atomic<uint32_t> touched{0};  // a bit for each digit
    std::atomic<bool> finite{true};
    base::in_shares(count_, numbers_a_share, threads, [&](size_t from, size_t end) {
        uint32_t here = 0;
        for (size_t i = from; i < end; ++i) {
            if (!std::isfinite(values[i])) finite = false;
            else if (values[i] != 0) here |= 3u << split(values[i]).digit;
        }
        touched |= here;
    });
    for (int k = 0; k < digits; ++k)
        if (touched >> k & 1) reach(k, k);
    base::in_shares(count_, numbers_a_share, threads, [&](size_t from, size_t end) {
        for (size_t i = from; i < end; ++i) {
            if (values[i] == 0 || !std::isfinite(values[i])) continue;
            const Split s = split(values[i]);
            lane_[s.digit][i] += s.low;
            lane_[s.digit + 1][i] += s.high;
        }
    });
    return finite;
}

void ExactSum::add(const std::vector<double>& values) {
    use_digits();
    about_to_add();
    for (size_t i = 0; i < count_; ++i) {
        if (!(std::fabs(values[i]) < 0x1p164) || values[i] == 0) continue;
        int exponent;
        auto mantissa = uint64_t(std::ldexp(std::frexp(std::fabs(values[i]), &exponent), 53));
        int place = exponent - 53 + 149;
        if (place < 0) mantissa = place > -64 ? mantissa >> -place : 0, place = 0;
        const int k = place / 32, shift = place % 32;
        const int64_t sign = values[i] < 0 ? -1 : 1;
        const uint64_t low = (mantissa & 0xffffffff) << shift;
        const uint64_t high = ((mantissa >> 32) << shift) + (low >> 32);
        const uint32_t words[] = {uint32_t(low), uint32_t(high), uint32_t(high >> 32)};
        for (int n = 0; n < 3; ++n) {
            if (words[n] == 0) continue;
            reach(k + n, k + n);
            lane_[k + n][i] += sign * int64_t(words[n]);
        }
    }
}

void ExactSum::add(const std::vector<image::SumLayer>& layers, const std::string& place) {
    use_digits();
    about_to_add();
    for (size_t n = 0; n < layers.size(); ++n) {
        const image::SumLayer& layer = layers[n];
        if (layer.digit < 0 || layer.digit >= digits || layer.digit != layers[0].digit + int(n))
            base::fail(place, "its layers of exact sums have a gap or an invalid number");
        if (layer.words.size() != count_) base::fail(place, "its layers of exact sums have another size");
        const bool highest = n + 1 == layers.size();
        reach(layer.digit, layer.digit);
        std::vector<int64_t>& lane = lane_[layer.digit];
        for (size_t i = 0; i < count_; ++i)
            lane[i] += highest ? int64_t(int32_t(layer.words[i])) : int64_t(layer.words[i]);
    }
}

// The digits are carried to words of 32 bits, the last with the sign; a negative number is negated; then the
// highest word that is not 0 and the two below it make the double.  Three digits or fewer are mostly one number of 128
// bits, with the same result.
double ExactSum::value_of_digits(size_t i) const {
    if (end_ - lowest_ <= 3) {
        __extension__ __int128 sum = 0;
        for (int k = end_ - 1; k >= lowest_; --k) sum = sum * (int64_t(1) << 32) + lane_[k][i];
        const bool negative = sum < 0;
        __extension__ const auto size = static_cast<unsigned __int128>(negative ? -sum : sum);
        if (size >> 96 == 0) {
            const double upper = double(uint64_t(size >> 32)) * two_32;
            const double magnitude = size >> 64 == 0 ? double(uint64_t(size)) : upper + double(uint32_t(size));
            return (negative ? -magnitude : magnitude) * unit_;
        }
    }
    uint32_t word[digits + 3] = {};  // two of zeros below the lowest
    int64_t carried = 0;
    for (int k = lowest_; k < end_; ++k) {
        carried += lane_[k][i];
        word[k + 2] = uint32_t(carried);
        carried >>= 32;
    }
    word[end_ + 2] = uint32_t(carried);
    uint64_t one = 1;
    for (int k = lowest_; carried < 0 && k <= end_; ++k, one >>= 32) {
        one += ~word[k + 2];
        word[k + 2] = uint32_t(one);
    }

    int top = end_ + 2;
    while (top > 2 && word[top] == 0) --top;
    const double upper = double(word[top]) * two_32 + double(word[top - 1]);
    const double magnitude = std::ldexp(upper * two_32 + double(word[top - 2]), 32 * (top - 4) - 149);
    return carried < 0 ? -magnitude : magnitude;
}

void ExactSum::values(size_t i, size_t count, double* out) const {
    if (!pairs_) {
        for (size_t k = 0; k < count; ++k) out[k] = value_of_digits(i + k);
        return;
    }
    constexpr size_t block = 256;
    double rest[block];
    for (size_t from = 0; from < count; from += block) {
        const size_t n = std::min(block, count - from);
        if (!pairs_->values(i + from, n, out + from, rest)) continue;
        for (size_t k = 0; k < n; ++k) {
            if (rest[k] == 0) continue;
            ExactSum one;
            one.count_ = 1;
            one.add(std::vector<double>{out[from + k]});
            one.add(std::vector<double>{rest[k]});
            out[from + k] = one.value_of_digits(0);
        }
    }
}

double ExactSum::value(size_t i) const {
    double out;
    values(i, 1, &out);
    return out;
}

std::vector<image::SumLayer> ExactSum::layers() const {
    if (pairs_) {
        ExactSum digits = *this;
        digits.use_digits();
        return digits.layers();
    }
    std::vector<image::SumLayer> layers;
    std::vector<int64_t> carried(count_);
    for (int k = lowest_; k < std::min(end_ + 1, digits) && lowest_ < end_; ++k) {  // the last word has the sign
        layers.push_back({k, std::vector<uint32_t>(count_)});
        for (size_t i = 0; i < count_; ++i) {
            if (k < end_) carried[i] += lane_[k][i];
            layers.back().words[i] = uint32_t(carried[i]);
            carried[i] >>= 32;
        }
    }
    return without_empty(std::move(layers));
}

}  // namespace film
