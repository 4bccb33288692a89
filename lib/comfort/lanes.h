// SPDX-License-Identifier: BSD-3-Clause
// Eight floats side by side, in the compiler's words for that, which every processor can follow.  Functions that use
// them are WIDE_LOOPs.
#pragma once
#include <cstdint>
#include <cstring>

namespace comfort {

constexpr int lanes = 8;
using Floats = float __attribute__((vector_size(4 * lanes)));
using Words = uint32_t __attribute__((vector_size(4 * lanes)));

inline __attribute__((always_inline)) Floats load(const float* from) {
    Floats v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

inline __attribute__((always_inline)) void store(const Floats& v, float* to) { std::memcpy(to, &v, sizeof v); }

// |a - b|, or 0 in lanes that are not wanted.
constexpr Words all_lanes = ~Words{};
inline __attribute__((always_inline)) Words first_lanes(int n) {
    using Numbers = int32_t __attribute__((vector_size(4 * lanes)));
    return Words(Numbers{0, 1, 2, 3, 4, 5, 6, 7} < n);
}
inline __attribute__((always_inline)) Floats distance(const Floats& a, const Floats& b,
                                                      const Words& wanted = all_lanes) {
    return Floats(Words(a - b) & 0x7fffffffu & wanted);
}

// A number with the signs turned that have their bit, and values by their place.
inline __attribute__((always_inline)) Floats turned(float value, const Words& flip) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return Floats(flip ^ bits);
}
inline __attribute__((always_inline)) Floats pick(const Floats& from, const Words& places) {
#ifdef __clang__
    Floats out;
    for (int k = 0; k < lanes; ++k) out[k] = from[places[k]];
    return out;
#else
    return __builtin_shuffle(from, places);
#endif
}

inline __attribute__((always_inline)) Floats at_least(const Floats& v, const Floats& low) { return v > low ? v : low; }

// Which of 32 pixels pass: bit k.  test(first) is that of the eight from there on, as all ones or none in each.
constexpr int in_a_word = 4 * lanes;
template <class Test>
inline __attribute__((always_inline)) uint32_t which(Test test) {
    constexpr Words bit{1, 2, 4, 8, 16, 32, 64, 128};
    Words found = {};
    for (int k = 0; k < in_a_word; k += lanes) found |= Words(test(k)) & bit << uint32_t(k);
    uint64_t two[lanes / 2];
    std::memcpy(two, &found, sizeof two);
    const uint64_t all = (two[0] | two[1]) | (two[2] | two[3]);
    return uint32_t(all) | uint32_t(all >> 32);
}

}  // namespace comfort
