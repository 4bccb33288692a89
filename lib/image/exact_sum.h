// SPDX-License-Identifier: BSD-3-Clause
// Sums without rounding, so that parts of a picture merge to the same bits in any order and grouping.
// A sum is a whole number of 2^-149, the smallest float, written in digits of 32 bits.  Digit k counts 2^(32 k - 149);
// ten digits hold 2^32 of the largest floats, and those that no value has touched take no memory (exact_block.h).
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>
#include "image/exact_block.h"

namespace image {

// The k-th digit of all sums, two's complement: the highest layer has the sign.
struct SumLayer {
    int digit = 0;
    std::vector<uint32_t> words;
};

class ExactSum {
public:
    static constexpr int digits = ExactBlock::digits;
    static constexpr size_t room = ExactBlock::room;

    void clear(size_t count);
    size_t size() const { return count_; }
    // One value for each sum.  Those that are not finite, or reach 2^164, count as 0; below 2^-149 a double is cut.
    bool add(const std::vector<float>& values, unsigned threads = 1);  // false: there was such a value
    void add(const std::vector<double>& values);
    // Those that layers() gave.  Throws Error (place) for layers that are no sum.
    void add(const std::vector<SumLayer>& layers, const std::string& place);

    // Sum i as a double: within 2^-53 of it, and a function of its value alone.
    double value(size_t i) const;
    // Those of block b, which begins with sum b * room.  In `space` (for room numbers), or where they are.
    const double* values(size_t block, double* space) const { return blocks_[block].values(space); }
    size_t blocks() const { return blocks_.size(); }
    size_t size_of(size_t block) const { return std::min(room, count_ - block * room); }
    // As few as hold all sums, from the lowest digit up, without gaps; the same for the same sums.
    std::vector<SumLayer> layers() const;

private:
    void about_to_add(uint32_t values);
    size_t count_ = 0;
    uint32_t added_ = 0;  // values since the last carry: a lane has room for 2^29 of them
    std::vector<ExactBlock> blocks_;
};

}  // namespace image
