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
    Words out;
    for (int k = 0; k < lanes; ++k) out[k] = k < n ? ~0u : 0;
    return out;
}
inline __attribute__((always_inline)) Floats distance(const Floats& a, const Floats& b,
                                                      const Words& wanted = all_lanes) {
    return Floats(Words(a - b) & 0x7fffffffu & wanted);
}

}  // namespace comfort
