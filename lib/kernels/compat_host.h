// SPDX-License-Identifier: BSD-3-Clause
// The words of the shared device code, for C++17.  compat_opencl.h holds the same words for OpenCL C 1.2.
// Rules (docs/architecture.md): static functions by the word FN, pointers are GLOBAL or PRIVATE, out-parameters by
// pointer, float3 only through F3() and the functions of vec.h, no recursion, literals with f, own math (math.h).
#pragma once
#include <cstdint>
#include <cstring>
#include <math.h>

#define LUX_HOST 1
#define LUX_DOUBLE 1
#define FN static inline
#define GLOBAL
#define PRIVATE
#define CONSTANT static const
typedef uint32_t uint;
typedef uint64_t ulong64;
typedef int64_t long64;
struct float2 { float x, y; };
struct float3 { float x, y, z; };
struct alignas(16) float4 { float x, y, z, w; };
struct uint4 { uint x, y, z, w; };
FN float3 F3(float x, float y, float z) { float3 v; v.x = x; v.y = y; v.z = z; return v; }
FN float as_float_(uint u) { float f; memcpy(&f, &u, 4); return f; }
FN uint as_uint_(float f) { uint u; memcpy(&u, &f, 4); return u; }
FN float sqrt_(float x) { return __builtin_sqrtf(x); }
FN float floor_(float x) { return __builtin_floorf(x); }
FN float fabs_(float x) { return __builtin_fabsf(x); }
