// SPDX-License-Identifier: BSD-3-Clause
// The words of the shared device code, for OpenCL C 1.2.  See compat_host.h for the rules.
#pragma OPENCL FP_CONTRACT OFF
#ifdef cl_khr_fp64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define LUX_DOUBLE 1
#endif
#define FN static inline
#define FN_RARE static
#define GLOBAL __global
#define PRIVATE(T) __private T*
#define TABLES(T) __private T*
#define CONSTANT __constant
#define PARAMS(T) __constant T*
#define UNIFORM
#define STRUCT(name)          \
    typedef struct name name; \
    struct name
typedef ulong ulong64;
typedef long long64;
#define F3(x, y, z) ((float3)((x), (y), (z)))
#define as_float_(u) as_float(u)
#define as_uint_(f) as_uint(f)
#define MIN_(a, b) ((a) < (b) ? (a) : (b))
#define MAX_(a, b) ((a) > (b) ? (a) : (b))
#define sqrt_(x) sqrt(x)
#define floor_(x) floor(x)
#define fabs_(x) fabs(x)
#define highest_bit_(u) (31u - clz(u))
#define bit_count_(u) popcount(u)
#define quotient_(a, b) ((a) / (b))
#define loadf4_(p) (*(__global const float4*)(p))
#define read4_(from, i) ((from)[i])
#define write4_(to, i, v) ((to)[i] = (v))

// Wide words (bvh8.h), see compat_host.h.
#ifdef LUX_COMPACT
#define WIDE_WORDS 0  // a GPU's lanes are its work items
#else
#define WIDE_WORDS 1
#endif
typedef float4 v4f;
typedef int4 v4i;
typedef float8 v8f;
typedef int8 v8i;
typedef uint8 v8u;
#define load4_(p) vload4(0, p)
#define load8_(p) vload8(0, p)
#define splat4_(x) ((float4)(x))
#define splat8_(x) ((float8)(x))
#define splat8u_(x) ((uint8)(x))
#define count4_(a, step) ((uint8)(0u, 1u, 2u, 3u, 0u, 1u, 2u, 3u) * (uint8)(step) + (uint8)(a))
#define second_half8_() ((uint8)(0u, 0u, 0u, 0u, ~0u, ~0u, ~0u, ~0u))
#define float8_(v) convert_float8(as_int8(v))
#define store4_(v, p) vstore4(v, 0, p)
#define store8_(v, p) vstore8(v, 0, p)
typedef ulong LaneMask;
#define lanes4_(c) ((ulong)as_uint(convert_char4(c)))
#define lanes8_(c) as_ulong(convert_char8(c))
#define lane_first_(m) ((uint)(63u - (uint)clz(m)) >> 3)
#define lane_drop_(m, lane) ((m) & ~(255ul << (8u * (lane))))
#define lane_odd_(m) ((int)(popcount((m)&0x0101010101010101ul) & 1ul))
