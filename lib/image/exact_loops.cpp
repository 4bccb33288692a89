// SPDX-License-Identifier: BSD-3-Clause
// See exact_loops.h.  Four numbers at a time, in the compiler's words for that, which every processor can follow.
#include "image/exact_loops.h"

#include <cstring>

#include "base/wide.h"

namespace image::exact {
namespace {

using Bits = uint32_t __attribute__((vector_size(16)));
using Signed = int32_t __attribute__((vector_size(16)));
using Word = uint64_t __attribute__((vector_size(32)));
using Int = int64_t __attribute__((vector_size(32)));
using Double = double __attribute__((vector_size(32)));
constexpr size_t lanes = 4;
constexpr uint64_t low_half = 0xffffffff;
constexpr double two_32 = 4294967296.;

// The end of an array may be less than four.
template <class Vector, class T>
inline __attribute__((always_inline)) Vector load(const T* from, size_t left) {
    Vector v = {};
    if (left >= lanes) std::memcpy(&v, from, sizeof v);
    else std::memcpy(&v, from, left * sizeof(T));
    return v;
}
template <class Vector, class T>
inline __attribute__((always_inline)) void store(const Vector& v, T* to, size_t left) {
    if (left >= lanes) std::memcpy(to, &v, sizeof v);
    else std::memcpy(to, &v, left * sizeof(T));
}

// Of words of 32 bits: written below the point of 2^52, as not every processor converts such side by side.
inline __attribute__((always_inline)) Double to_double(const Word& word) {
    const Word bits = word | 0x4330000000000000;
    Double sum;
    std::memcpy(&sum, &bits, sizeof sum);
    return sum - 0x1p52;
}

}  // namespace

WIDE_LOOP void widen(Exponents& exponents, const float* values, size_t count) {
    uint32_t lo = exponents.least, hi = exponents.most;
    for (size_t i = 0; i < count; ++i) {
        uint32_t bits;
        std::memcpy(&bits, values + i, 4);
        const uint32_t field = bits << 1 >> 24, exponent = field > 0 ? field : 1;
        const uint32_t seen = bits << 1 ? exponent : Exponents::not_finite;
        lo = seen < lo ? seen : lo;
        hi = exponent > hi ? exponent : hi;
    }
    exponents.least = lo;
    exponents.most = hi;
}

WIDE_LOOP void add(const float* const* frames, size_t frame_count, size_t count, uint32_t least_exponent,
                   int64_t* const lane[3]) {
    const int shift = int(least_exponent - 1) % 32;
    for (size_t i = 0; i < count; i += lanes) {
        const size_t left = count - i;
        Int sum = {};
        for (size_t k = 0; k < frame_count; ++k) {
            const Bits bits = load<Bits>(frames[k] + i, left);
            const Bits field = bits << 1 >> 24;
            const Bits normal = Bits(field != 0), finite = Bits(field != Exponents::not_finite);
            const Bits fraction = ((bits & 0x7fffff) | (normal & 0x800000)) & finite;
            const Bits above = (field + (~normal & 1)) - least_exponent;  // of a 0 it may be anything
            const Int sign = __builtin_convertvector(Signed(bits) >> 31, Int);
            const Word wide = __builtin_convertvector(fraction, Word) << __builtin_convertvector(above & 63, Word);
            sum += (Int(wide) ^ sign) - sign;
        }
        const Word low = (Word(sum) & low_half) << shift;
        const Int high = Int(Word(sum >> 32) << shift) + Int(low >> 32);
        store(load<Int>(lane[0] + i, left) + Int(low & low_half), lane[0] + i, left);
        if (lane[2]) {
            store(load<Int>(lane[1] + i, left) + Int(Word(high) & low_half), lane[1] + i, left);
            store(load<Int>(lane[2] + i, left) + (high >> 32), lane[2] + i, left);
        } else {
            store(load<Int>(lane[1] + i, left) + high, lane[1] + i, left);
        }
    }
}

// The digits are carried to words of 32 bits, of which the last has the sign; a negative number is turned; then the
// highest word that is not 0 and the two below it make the double.
WIDE_LOOP void to_doubles(const int64_t* const* lane, int digits, double unit, size_t count, double* out) {
    Word word[most_digits + 3] = {};  // two of zeros below the lowest
    for (size_t i = 0; i < count; i += lanes) {
        const size_t left = count - i;
        Int carried = {};
        for (int k = 0; k < digits; ++k) {
            carried += load<Int>(lane[k] + i, left);
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
        store(Double(Word(magnitude) ^ (negative << 63)), out + i, left);
    }
}

}  // namespace image::exact
