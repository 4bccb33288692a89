// SPDX-License-Identifier: BSD-3-Clause
// See exact_loops.h.  Four numbers at a time, in the compiler's words for that, which every processor can follow.
#include "image/exact_loops.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/wide.h"

namespace image::exact {
namespace {

using Word = uint64_t __attribute__((vector_size(32)));
using Int = int64_t __attribute__((vector_size(32)));
using Double = double __attribute__((vector_size(32)));
constexpr size_t lanes = 4;
constexpr uint64_t low_half = 0xffffffff;
constexpr double two_32 = 4294967296.;

template <class Vector, class T>
inline __attribute__((always_inline)) Vector load(const T* from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
template <class Vector, class T>
inline __attribute__((always_inline)) void store(const Vector& v, T* to) {
    std::memcpy(to, &v, sizeof v);
}
template <class T>
inline __attribute__((always_inline)) void add_to(const Int& v, T* to) {
    store(load<Int>(to) + v, to);
}

// 2^exponent.
inline double power(int exponent) {
    const uint64_t bits = uint64_t(exponent + 1023) << 52;
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// Of words of 32 bits: written below the point of 2^52, as not every processor converts such side by side.
inline __attribute__((always_inline)) Double to_double(const Word& word) {
    const Word bits = word | 0x4330000000000000;
    Double sum;
    std::memcpy(&sum, &bits, sizeof sum);
    return sum - 0x1p52;
}

}  // namespace

// The sign is shifted out, so that words are in the order of magnitudes; a 0 less 1 is above all of them.
WIDE_LOOP void widen(Exponents& exponents, const float* values, size_t count) {
    uint32_t lo = ~0u, hi = 0;
    for (size_t i = 0; i < count; ++i) {
        uint32_t bits;
        std::memcpy(&bits, values + i, 4);
        bits <<= 1;
        lo = bits - 1 < lo ? bits - 1 : lo;
        hi = bits > hi ? bits : hi;
    }
    if (hi == 0) return;
    const auto exponent = [](uint32_t magnitude) { return magnitude >> 24 ? magnitude >> 24 : 1; };
    exponents.least = std::min(exponents.least, exponent(lo + 1));
    exponents.most = std::max(exponents.most, exponent(hi));
}

bool Held::take(const Exponents& more) {
    const uint32_t new_least = std::min(least, more.least);
    const double new_most = most + power(int(more.most) - 1 + 24);
    if (!more.finite() || new_most > power(int(new_least) - 1 + 53)) return false;
    least = new_least, most = new_most;
    return true;
}

int Held::last_digit() const { return std::max(first_digit() + 1, std::ilogb(most) / 32); }

WIDE_LOOP void add(const float* values, size_t count, double* sums) {
    for (size_t i = 0; i < count; ++i) sums[i] += double(values[i]);
}

WIDE_LOOP void add_digits(const double* sums, const Held& held, int64_t* lane) {
    const int shift = int(held.least - 1) % 32;
    const double whole = power(149 - int(held.least - 1));
    const bool third = held.last_digit() > held.first_digit() + 1;
    for (size_t i = 0; i < room; i += lanes) {
        const Int sum = __builtin_convertvector(load<Double>(sums + i) * whole, Int);
        const Word low = (Word(sum) & low_half) << shift;
        const Int high = Int(Word(sum >> 32) << shift) + Int(low >> 32);
        add_to(Int(low & low_half), lane + i);
        add_to(third ? Int(Word(high) & low_half) : high, lane + room + i);
        if (third) add_to(high >> 32, lane + 2 * room + i);
    }
}

// The digits are carried to words of 32 bits, of which the last has the sign; a negative number is turned; then the
// highest word that is not 0 and the two below it make the double.
WIDE_LOOP void to_doubles(const int64_t* lane, int digits, double unit, double* out) {
    Word word[most_digits + 3] = {};  // two of zeros below the lowest
    for (size_t i = 0; i < room; i += lanes) {
        Int carried = {};
        for (int k = 0; k < digits; ++k) {
            carried += load<Int>(lane + size_t(k) * room + i);
            word[k + 2] = Word(carried) & low_half;
            carried >>= 32;
        }
        word[digits + 2] = Word(carried) & low_half;

        const Word negative = Word(carried < 0);
        Word one = negative & 1;
        Double magnitude = {};
        double worth = unit / two_32 / two_32;  // of the word two below
        for (int k = 0; k <= digits; ++k, worth *= two_32) {
            const Word turned = ((word[k + 2] ^ negative) & low_half) + one;
            word[k + 2] = turned & low_half;
            one = turned >> 32;
            const Double upper = to_double(word[k + 2]) * two_32 + to_double(word[k + 1]);
            const Double here = (upper * two_32 + to_double(word[k])) * worth;
            const Word is_top = Word(word[k + 2] != 0);
            magnitude = Double((is_top & Word(here)) | (~is_top & Word(magnitude)));
        }
        store(Double(Word(magnitude) ^ (negative << 63)), out + i);
    }
}

}  // namespace image::exact
