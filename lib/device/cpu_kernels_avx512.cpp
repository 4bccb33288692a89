// SPDX-License-Identifier: BSD-3-Clause
// The kernels of lanes16 compiled for avx512 (flags in CMakeLists.txt); cpu_device.cpp chooses at run time.
#ifdef LUXPIPE_LANES16
#define LUX_ISA avx512
#define LANE_CALL(name) lanes16_##name
#define LUX_LANES_OF_ISA cpu_lanes16
#define LUX_LANES_NAME "avx512, 16 lanes"
#include "device/cpu_kernels.inl"
#endif
