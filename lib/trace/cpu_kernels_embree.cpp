// SPDX-License-Identifier: BSD-3-Clause
// The kernels over Embree's traversal instead of ours.
#include "bvh/embree_scene.h"
#define LUX_ISA embree
#define LUX_ISA_NAME "embree"
#define LUX_EMBREE "trace/embree_traversal.h"
#include "trace/cpu_kernels.inl"
