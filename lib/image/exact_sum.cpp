// SPDX-License-Identifier: BSD-3-Clause
// See exact_sum.h.
#include "image/exact_sum.h"

#include <atomic>

#include "base/error.h"
#include "base/threads.h"

namespace image {
namespace {

constexpr uint32_t most_added = 1u << 29;
constexpr size_t blocks_a_share = 4096;

// A word of ones or of zeros, as the sign goes on above this word.
uint32_t sign_of(uint32_t word) { return word >> 31 ? 0xffffffffu : 0; }

// Without the layers above that only go on with the sign, and those below that are 0.
std::vector<SumLayer> without_empty(std::vector<SumLayer> all) {
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
    count_ = count;
    added_ = 0;
    blocks_.assign((count + room - 1) / room, ExactBlock());
}

void ExactSum::about_to_add(uint32_t values) {
    added_ += values;
    if (added_ < most_added) return;
    for (ExactBlock& block : blocks_) block.carry();
    added_ = values + 1;
}

bool ExactSum::add(const std::vector<float>& values, unsigned threads) {
    about_to_add(2);  // what the doubles of a block hold, and these
    std::atomic<bool> finite{true};
    base::in_shares(blocks_.size(), blocks_a_share, threads, [&](size_t from, size_t end) {
        for (size_t b = from; b < end; ++b)
            if (!blocks_[b].add(&values[b * room], size_of(b))) finite = false;
    });
    return finite;
}

void ExactSum::add(const std::vector<double>& values) {
    about_to_add(1);
    for (size_t i = 0; i < count_; ++i) blocks_[i / room].add(values[i], i % room);
}

void ExactSum::add(const std::vector<SumLayer>& layers, const std::string& place) {
    about_to_add(1);
    for (size_t n = 0; n < layers.size(); ++n) {
        const SumLayer& layer = layers[n];
        if (layer.digit < 0 || layer.digit >= digits || layer.digit != layers[0].digit + int(n))
            base::fail(place, "its layers of exact sums have a gap, or a number that there is not");
        if (layer.words.size() != count_) base::fail(place, "its layers of exact sums have another size");
        const bool highest = n + 1 == layers.size();
        for (size_t b = 0; b < blocks_.size(); ++b) {
            const uint32_t* words = &layer.words[b * room];
            int64_t* digit = blocks_[b].digit(layer.digit);
            if (highest)
                for (size_t i = 0; i < size_of(b); ++i) digit[i] += int32_t(words[i]);
            else
                for (size_t i = 0; i < size_of(b); ++i) digit[i] += words[i];
        }
    }
}

double ExactSum::value(size_t i) const {
    double space[room];
    return values(i / room, space)[i % room];
}

std::vector<SumLayer> ExactSum::layers() const {
    std::vector<ExactBlock::Digits> all;
    int lowest = digits, end = 0;
    for (const ExactBlock& block : blocks_) {
        all.push_back(block.all_digits());
        lowest = std::min(lowest, all.back().lowest);
        end = std::max(end, all.back().end);
    }
    if (lowest >= end) return {};
    end = std::min(end + 1, digits);  // the last word has the sign
    std::vector<SumLayer> layers;
    for (int k = lowest; k < end; ++k) layers.push_back({k, std::vector<uint32_t>(count_)});
    for (size_t b = 0; b < all.size(); ++b) {
        int64_t carried[room] = {};
        for (SumLayer& layer : layers) {
            const int64_t* lane = all[b].has(layer.digit) ? all[b].at(layer.digit) : nullptr;
            for (size_t i = 0; i < size_of(b); ++i) {
                if (lane) carried[i] += lane[i];
                layer.words[b * room + i] = uint32_t(uint64_t(carried[i]));
                carried[i] >>= 32;
            }
        }
    }
    return without_empty(std::move(layers));
}

}  // namespace image
