// SPDX-License-Identifier: BSD-3-Clause
// The kernels compiled for avx2 (flags in CMakeLists.txt); cpu_device.cpp chooses at run time.
#define LUX_ISA avx2
#define LUX_ISA_NAME "avx2"
#include "trace/cpu_kernels.inl"
