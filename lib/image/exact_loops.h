// SPDX-License-Identifier: BSD-3-Clause
// The loops of exact sums (exact_block.h), side by side without branches, over a few hundred sums at a time, which stay
// in the processor's nearest memory.
#pragma once
#include <cstddef>
#include <cstdint>

namespace image::exact {

constexpr size_t room = 256;  // sums of a block
constexpr int most_digits = 10;

// Exponents of floats, as a float's fields count them: 2^-149 is 1.
struct Exponents {
    static constexpr uint32_t not_finite = 0xff;
    uint32_t least = not_finite, most = 1;  // of those that are not 0
    bool any() const { return least != not_finite; }
    bool finite() const { return most != not_finite; }
    int first_digit() const { return int(least - 1) / 32; }
    int last_digit() const { return int(most - 1) / 32 + 1; }  // 24 bits may reach into the next one
};
void widen(Exponents& exponents, const float* values, size_t count);

// What doubles hold that sum floats: whole numbers of 2^(least - 1) smallest floats, and of these never more than a
// double's 53 bits.
struct Held {
    uint32_t least = Exponents::not_finite;
    double most = 0;  // smallest floats that a sum may have reached
    bool any() const { return most > 0; }
    bool take(const Exponents& more);  // false: such values might be rounded, nothing is taken
    int first_digit() const { return int(least - 1) / 32; }
    int last_digit() const;
};
void add(const float* values, size_t count, double* sums);

// Such sums of a block in 32-bit digits, to the lanes of digits from first_digit to last_digit, `room` numbers each.
void add_digits(const double* sums, const Held& held, int64_t* lane);

// Numbers of `digits` lanes, the first in `unit`, as doubles (ExactSum::value).
void to_doubles(const int64_t* lane, int digits, double unit, double* out);

}  // namespace image::exact
