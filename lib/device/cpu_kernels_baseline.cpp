// SPDX-License-Identifier: BSD-3-Clause
// The kernels compiled for baseline (flags in CMakeLists.txt); cpu_device.cpp chooses at run time.
#define LUX_ISA baseline
#define LUX_ISA_NAME "baseline"
#include "device/cpu_kernels.inl"
