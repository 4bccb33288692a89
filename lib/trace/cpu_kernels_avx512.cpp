// SPDX-License-Identifier: BSD-3-Clause
// The kernels compiled for avx512 (flags in CMakeLists.txt); cpu_device.cpp chooses at run time.
#define LUX_ISA avx512
#define LUX_ISA_NAME "avx512"
#include "trace/cpu_kernels.inl"
