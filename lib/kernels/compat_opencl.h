// SPDX-License-Identifier: BSD-3-Clause
// The words of the shared device code, for OpenCL C 1.2.  See compat_host.h for the rules.
#pragma OPENCL FP_CONTRACT OFF
#ifdef cl_khr_fp64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define LUX_DOUBLE 1
#endif
#define FN static inline
#define GLOBAL __global
#define PRIVATE __private
#define CONSTANT __constant
typedef ulong ulong64;
typedef long long64;
#define F3(x, y, z) ((float3)((x), (y), (z)))
#define as_float_(u) as_float(u)
#define as_uint_(f) as_uint(f)
#define sqrt_(x) sqrt(x)
#define floor_(x) floor(x)
#define fabs_(x) fabs(x)
