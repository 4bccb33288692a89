// SPDX-License-Identifier: BSD-3-Clause
// Some hundred of the sums of exact_sum.h: neighbours, whose values are mostly of like size.
// Floats come first to doubles.  As long as 53 bits hold every sum without rounding, as they do for tens to thousands
// of frames, that is all there is.  What they could not hold any more goes to digits of 32 bits, and the doubles begin
// anew.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>
#include "image/exact_loops.h"

namespace image {

class ExactBlock {
public:
    static constexpr size_t room = exact::room;
    static constexpr int digits = exact::most_digits;

    // False: some are not finite.  They count as 0.
    bool add(const float* values, size_t count);
    void add(double value, size_t i);  // not below 2^164 in magnitude: counts as 0; below 2^-149 it is cut
    // The k-th digits, to be added to: 32 bits, and of a number's highest digit with its sign.
    int64_t* digit(int k);
    void carry();  // before a lane of 64 bits could overflow

    // All sums: within 2^-53 of them, and functions of their value alone.  In `space`, or where they are.
    const double* values(double* space) const;

    // Digits from `lowest` to `end` - 1, not yet carried: those of sum i are lane[k * room + i].
    struct Digits {
        int lowest = digits, end = 0;
        std::vector<int64_t> lane;
        void reach(int first, int last);  // makes these digits and those between them
        const int64_t* at(int digit) const { return &lane[size_t(digit - lowest) * room]; }
        int64_t* at(int digit) { return &lane[size_t(digit - lowest) * room]; }
        bool has(int digit) const { return digit >= lowest && digit < end; }
    };
    Digits all_digits() const;

private:
    void to_digits();
    void add_to_digits(float value, size_t i);
    double sum_[room] = {};
    exact::Held held_;  // in them
    Digits digits_;     // of the rest
};

}  // namespace image
