// SPDX-License-Identifier: BSD-3-Clause
// The words of the shared device code, for C++17.  compat_opencl.h holds the same words for OpenCL C 1.2.
// Rules (docs/architecture.md): static functions by the word FN; pointers are GLOBAL to the scene's tables, PRIVATE(T)
// to what belongs to one path, TABLES(T) to what all paths have in common, PARAMS(T) to the parameters of a pass;
// structs by STRUCT(name); out-parameters by pointer; float3 only through F3() and the functions of vec.h; no
// recursion; literals with f; own math (math.h).  For paths in lanes (compat_lanes.isph): a counter that goes the same
// way for all paths is UNIFORM; an initial value does not refer to a name of its own declaration; no f(x)[i] or
// f(x)->m; no pointer into a PRIVATE array that depends on the path.
#pragma once
#include <cstdint>
#include <cstring>
#include <math.h>

#define LUX_DOUBLE 1
#define FN static inline
#define FN_RARE static __attribute__((noinline, unused))  // for rare cases: kept out of the common path
#define GLOBAL
#define PRIVATE(T) T*
#define TABLES(T) T*
#define CONSTANT static const
#define PARAMS(T) T*
#define UNIFORM
#define STRUCT(name) struct name
typedef uint32_t uint;
typedef uint64_t ulong64;
typedef int64_t long64;
struct float2 {
    float x, y;
};
struct float3 {
    float x, y, z;
};
struct alignas(16) float4 {
    float x, y, z, w;
};
struct uint4 {
    uint x, y, z, w;
};
FN float3 F3(float x, float y, float z) {
    float3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

FN float as_float_(uint u) {
    float f;
    memcpy(&f, &u, 4);
    return f;
}

FN uint as_uint_(float f) {
    uint u;
    memcpy(&u, &f, 4);
    return u;
}
#define MIN_(a, b) ((a) < (b) ? (a) : (b))
#define MAX_(a, b) ((a) > (b) ? (a) : (b))
FN float sqrt_(float x) { return __builtin_sqrtf(x); }
FN float floor_(float x) { return __builtin_floorf(x); }
FN float fabs_(float x) { return __builtin_fabsf(x); }
FN uint highest_bit_(uint u) { return 31u - (uint)__builtin_clz(u); }  // u != 0
FN uint bit_count_(uint u) { return (uint)__builtin_popcount(u); }
#define quotient_(a, b) ((a) / (b))  // b the same for all paths

// Four words of a path: float4 or uint4.  In lanes a plain [i] takes three times as long.
#define read4_(from, i) ((from)[i])
#define write4_(to, i, v) ((to)[i] = (v))

// p on a 16-byte boundary
FN float4 loadf4_(const float* p) {
    float4 v;
    memcpy(&v, p, 16);
    return v;
}

// Wide words (bvh8.h): gcc vectors, whose operators are those of OpenCL's float4 and float8.  A comparison gives -1 or
// 0 in each lane; lanes4_/lanes8_ convert it to a LaneMask, to be iterated by lane_first_ and lane_drop_; lane_odd_:
// parity of their number.
#define WIDE_WORDS 1  // are they fast?
#pragma GCC diagnostic ignored "-Wpsabi"
typedef float v4f __attribute__((vector_size(16)));
typedef int v4i __attribute__((vector_size(16)));
typedef float v8f __attribute__((vector_size(32)));
typedef int v8i __attribute__((vector_size(32)));
typedef uint v8u __attribute__((vector_size(32)));
FN v4f load4_(const float* p) {
    v4f v;
    memcpy(&v, p, 16);
    return v;
}

FN v8f load8_(const float* p) {
    v8f v;
    memcpy(&v, p, 32);
    return v;
}

FN v4f splat4_(float x) {
    v4f v = {x, x, x, x};
    return v;
}

FN v8f splat8_(float x) {
    v8f v = {x, x, x, x, x, x, x, x};
    return v;
}

FN v8u splat8u_(uint x) {
    v8u v = {x, x, x, x, x, x, x, x};
    return v;
}

// {a, a + step, a + 2 step, a + 3 step} twice
FN v8u count4_(uint a, uint step) {
    v8u v = {0u, 1u, 2u, 3u, 0u, 1u, 2u, 3u};
    return v * step + a;
}

// mask with all bits set in lanes 4 to 7
FN v8u second_half8_(void) {
    v8u v = {0u, 0u, 0u, 0u, ~0u, ~0u, ~0u, ~0u};
    return v;
}

FN v8f float8_(const v8u& v) { return __builtin_convertvector((v8i)v, v8f); }
FN void store4_(v4f v, float* p) { memcpy(p, &v, 16); }
FN void store8_(const v8f& v, float* p) { memcpy(p, &v, 32); }
#if defined(__AVX__)
typedef uint LaneMask;
FN LaneMask lanes4_(v4i c) { return (uint)__builtin_ia32_movmskps((v4f)c); }
FN LaneMask lanes8_(v8i c) { return (uint)__builtin_ia32_movmskps256((v8f)c); }
FN uint lane_first_(LaneMask m) { return (uint)__builtin_ctz(m); }
FN LaneMask lane_drop_(LaneMask m, uint) { return m & (m - 1u); }
FN int lane_odd_(LaneMask m) { return __builtin_parity(m); }
FN uint lane_bits_(LaneMask m) { return m; }
#else
typedef uint64_t LaneMask;
typedef signed char v4c_ __attribute__((vector_size(4)));
typedef signed char v8c_ __attribute__((vector_size(8)));
FN LaneMask lanes4_(const v4i& c) {
    uint u;
    v4c_ b = __builtin_convertvector(c, v4c_);
    memcpy(&u, &b, 4);
    return u;
}

FN LaneMask lanes8_(const v8i& c) {
    uint64_t u;
    v8c_ b = __builtin_convertvector(c, v8c_);
    memcpy(&u, &b, 8);
    return u;
}

FN uint lane_first_(LaneMask m) { return (uint)__builtin_ctzll(m) >> 3; }
FN LaneMask lane_drop_(LaneMask m, uint lane) { return m & ~((LaneMask)255u << (8u * lane)); }
FN int lane_odd_(LaneMask m) { return __builtin_parityll(m & 0x0101010101010101u); }
FN uint lane_bits_(LaneMask m) { return (uint)((m & 0x0101010101010101u) * 0x0102040810204080u >> 56); }
#endif
