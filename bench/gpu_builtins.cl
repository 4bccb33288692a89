// SPDX-License-Identifier: BSD-3-Clause
// The few functions of OpenCL's library that lib/kernels calls, for NVIDIA's GPUs, and the kernels: clang turns this
// file into PTX on a machine that has neither a GPU nor its driver (bench/gpu_kernels.sh).
#define LIBRARY __attribute__((overloadable, always_inline))

LIBRARY float sqrt(float x) { return __builtin_sqrtf(x); }
LIBRARY float floor(float x) { return __builtin_floorf(x); }
LIBRARY float fabs(float x) { return __builtin_fabsf(x); }
LIBRARY uint clz(uint x) { return __builtin_clz(x); }
LIBRARY uint popcount(uint x) { return __builtin_popcount(x); }
LIBRARY size_t get_local_id(uint dimension) { return __nvvm_read_ptx_sreg_tid_x(); }
LIBRARY size_t get_global_id(uint dimension) {
    return __nvvm_read_ptx_sreg_ctaid_x() * __nvvm_read_ptx_sreg_ntid_x() + __nvvm_read_ptx_sreg_tid_x();
}
LIBRARY void barrier(cl_mem_fence_flags flags) { __syncthreads(); }
LIBRARY uint atomic_inc(volatile __local uint *p) { return __sync_fetch_and_add(p, 1u); }
LIBRARY uint atomic_add(volatile __global uint *p, uint x) { return __sync_fetch_and_add(p, x); }
LIBRARY void vstore3(float3 v, size_t i, __global float *p) {
    p[3 * i] = v.x;
    p[3 * i + 1] = v.y;
    p[3 * i + 2] = v.z;
}

#include "kernels/program.cl"
