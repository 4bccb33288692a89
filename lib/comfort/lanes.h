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

}  // namespace comfort
