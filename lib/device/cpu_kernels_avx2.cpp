// SPDX-License-Identifier: BSD-3-Clause
// The kernels compiled for avx2 (flags in CMakeLists.txt); cpu_device.cpp chooses at run time.
#define LUX_ISA avx2
#define LUX_ISA_NAME "avx2"
#ifdef LUXPIPE_LANES8
#define LANE_CALL(name) lanes8_##name
#define LUX_LANES_OF_ISA cpu_lanes8
#define LUX_LANES_NAME "avx2, 8 lanes"
#endif
#include "device/cpu_kernels.inl"
