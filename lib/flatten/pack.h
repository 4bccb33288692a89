// SPDX-License-Identifier: BSD-3-Clause
// Numbers into and out of the words of flat records (kernels/tables.h).
#pragma once
#include <cstdint>
#include <cstring>
#include "base/span.h"
#include "base/vec.h"
#include "kernels/dialect/host.h"

namespace flatten {

inline uint32_t bits(float f) {
    uint32_t u;
    std::memcpy(&u, &f, 4);
    return u;
}
inline float from_bits(uint32_t u) {
    float f;
    std::memcpy(&f, &u, 4);
    return f;
}

inline void put(float* q, base::Vec3 v) {
    q[0] = float(v.x);
    q[1] = float(v.y);
    q[2] = float(v.z);
}
inline base::Vec3 get(const float* q) { return {q[0], q[1], q[2]}; }
inline kernels::Packed3 packed(base::Vec3 v) { return {float(v.x), float(v.y), float(v.z)}; }
inline base::Vec3 vec_of(const kernels::Packed3& v) { return {v.x, v.y, v.z}; }

// Three real arguments of a primitive
inline base::Vec3 vec_at(const base::Span<double>& reals, size_t i) { return {reals[i], reals[i + 1], reals[i + 2]}; }

}  // namespace flatten
