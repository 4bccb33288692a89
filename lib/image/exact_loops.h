// SPDX-License-Identifier: BSD-3-Clause
// The loops of exact sums (exact_sum.h), side by side without branches, over a few hundred sums at a time, which stay
// in the processor's nearest memory.
#pragma once
#include <cstddef>
#include <cstdint>

namespace image::exact {

constexpr size_t room = 256;  // sums at a time
constexpr int most_digits = 10;

// Exponents of floats, as a float's fields count them: 2^-149 is 1.
struct Exponents {
    static constexpr uint32_t not_finite = 0xff;
    uint32_t least = not_finite, most = 1;  // of those that are not 0
    void take(const Exponents& other) {
        least = other.least < least ? other.least : least;
        most = other.most > most ? other.most : most;
    }
    bool any() const { return least != not_finite; }
    bool finite() const { return most != not_finite; }
    int first_digit() const { return int(least - 1) / 32; }
    int last_digit() const { return int(most - 1) / 32 + 1; }  // 24 bits may reach into the next one
};
void widen(Exponents& exponents, const float* values, size_t count);

// How many frames, of which range, can be added in one word of 64 bits before the sums see them.
constexpr size_t most_frames = 8;
inline bool fit_a_word(const Exponents& e) { return e.most - e.least <= 63 - 1 - 24 - 3; }

// The sum of such frames: 32-bit digits for lane[0], lane[1] and, where it is not null, lane[2].
// Values that are not finite are 0.
void add(const float* const* frames, size_t frame_count, size_t count, uint32_t least_exponent, int64_t* const lane[3]);

// Numbers of `digits` lanes, lane[0] in `unit`, as doubles (ExactSum::value).
void to_doubles(const int64_t* const* lane, int digits, double unit, size_t count, double* out);

}  // namespace image::exact
