// SPDX-License-Identifier: BSD-3-Clause
// See exact_sum.h.
#include "image/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/threads.h"
#include "image/exact_loops.h"

namespace image {
namespace {

constexpr uint64_t low_half = 0xffffffff;
constexpr uint32_t room = 1u << 29;

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
    exact::Exponents all;
    exact::widen(all, values.data(), count_);
    add({&values, 1}, all, 1);
    return all.finite();
}

void ExactSum::add(base::Span<std::vector<float>> frames, const exact::Exponents& all, unsigned threads) {
    for (size_t k = 0; k < frames.size(); ++k) about_to_add();
    if (!all.any()) return;
    reach(all.first_digit(), all.last_digit());

    base::in_shares(count_, share, threads, [&](size_t from, size_t end) {
        const float* values[exact::most_frames];
        for (size_t k = 0; k < frames.size(); k += exact::most_frames) {
            const size_t some = std::min(exact::most_frames, frames.size() - k);
            for (size_t i = from; i < end; i += exact::room) {
                for (size_t f = 0; f < some; ++f) values[f] = &frames[k + f][i];
                add_block(values, some, i, std::min(exact::room, end - i));
            }
        }
    });
}

void ExactSum::add_block(const float* const* frames, size_t frame_count, size_t first, size_t count) {
    exact::Exponents here;
    for (size_t f = 0; f < frame_count; ++f) exact::widen(here, frames[f], count);
    if (!here.any()) return;
    if (exact::fit_a_word(here)) {
        const auto at = [&](int k) { return k < end_ ? &lane_[size_t(k)][first] : nullptr; };
        int64_t* const lane[3] = {at(here.first_digit()), at(here.first_digit() + 1), at(here.first_digit() + 2)};
        return exact::add(frames, frame_count, count, here.least, lane);
    }
    for (size_t f = 0; f < frame_count; ++f)
        for (size_t i = 0; i < count; ++i) add_one(frames[f][i], first + i);
}

void ExactSum::add_one(float value, size_t i) {
    if (value == 0 || !std::isfinite(value)) return;
    uint32_t bits;
    std::memcpy(&bits, &value, 4);
    const uint32_t field = bits << 1 >> 24, exponent = field > 0 ? field - 1 : 0;
    const uint64_t wide = uint64_t((bits & 0x7fffff) | (field > 0 ? 0x800000 : 0)) << (exponent & 31);
    const int64_t sign = bits >> 31 ? -1 : 1;
    lane_[exponent >> 5][i] += sign * int64_t(wide & low_half);
    if (wide >> 32) lane_[(exponent >> 5) + 1][i] += sign * int64_t(wide >> 32);
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
    double v;
    values(i, 1, &v);
    return v;
}

void ExactSum::values(size_t first, size_t count, double* out) const {
    std::fill(out, out + count, 0.);
    if (lowest_ >= end_) return;
    const double unit = std::ldexp(1., 32 * lowest_ - 149);
    for (size_t i = 0; i < count; i += exact::room) {
        const int64_t* lane[digits];
        for (int k = lowest_; k < end_; ++k) lane[k - lowest_] = &lane_[size_t(k)][first + i];
        exact::to_doubles(lane, end_ - lowest_, unit, std::min(exact::room, count - i), out + i);
    }
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
