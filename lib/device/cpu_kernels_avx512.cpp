// SPDX-License-Identifier: BSD-3-Clause
// The kernels compiled for avx512 (flags in CMakeLists.txt); cpu_device.cpp chooses at run time.
#define LUX_ISA avx512
#define LUX_ISA_NAME "avx512"
#ifdef LUXPIPE_LANES16
#define LANE_CALL(name) lanes16_##name
#define LUX_LANES_OF_ISA cpu_lanes16
#define LUX_LANES_NAME "avx512, 16 lanes"
#endif
#include "device/cpu_kernels.inl"
