// SPDX-License-Identifier: BSD-3-Clause
// Sums without rounding (a superaccumulator: Kulisch and Miranker 1986), so that parts of a picture merge to the same
// bits in any order and grouping.  A sum is a whole number of 2^-149, the smallest float, written in digits of 32 bits.
// Digit k counts 2^(32 k - 149); ten digits hold 2^32 of the largest floats, and those that no value has touched take
// no memory.  Sums of floats that are alike enough are doubles (pair_sum.h) until something else is added.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include "film/pair_sum.h"
#include "image/picture.h"

namespace film {

class ExactSum {
public:
    static constexpr int digits = image::sum_digits;

    void clear(size_t count);
    size_t size() const { return count_; }
    // One value for each sum.  Values not finite, or from 2^164 on, count as 0; below 2^-149 a double is cut.
    bool add(const std::vector<float>& values, unsigned threads = 1);  // false: there was such a value
    void add(const std::vector<double>& values);
    // Adds a sum in the form of layers().  Throws Error (place) for layers that are no sum.
    void add(const std::vector<image::SumLayer>& layers, const std::string& place);

    // Sum i as a double: within 2^-53 of it, and a function of its value alone.
    double value(size_t i) const;
    void values(size_t i, size_t count, double* out) const;  // those from i on
    // As few as hold all sums, from the lowest digit up, without gaps; the same for the same sums.
    std::vector<image::SumLayer> layers() const;

private:
    void use_digits();
    double value_of_digits(size_t i) const;
    void about_to_add();
    void reach(int first, int last);
    size_t count_ = 0;
    std::optional<PairSum> pairs_;       // none: the sums are digits
    uint32_t added_ = 0;                 // values since the last carry: a lane has room for 2^29 of them
    int lowest_ = digits, end_ = 0;      // digits that there are
    double unit_ = 0;                    // of the lowest
    std::vector<int64_t> lane_[digits];  // a digit of all sums, not yet carried
};

}  // namespace film
