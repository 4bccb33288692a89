// SPDX-License-Identifier: BSD-3-Clause
// The whole device code in its order of inclusion, for C++ and OpenCL C alike, after the compat file of the device.
// LUX_BVH2 (GPUs) or LUX_EMBREE (the check: a header of the host) choose another traversal than the CPU's.
#include "kernels/vec.h"
#include "kernels/math.h"
#include "kernels/intersect.h"
#include "kernels/shapes.h"
#include "kernels/woop.h"
#if defined(LUX_BVH2)
#include "kernels/bvh2.h"
#elif defined(LUX_EMBREE)
#include LUX_EMBREE
#else
#include "kernels/bvh8.h"
#endif
#include "kernels/offset_ray.h"
#include "kernels/tables.h"
#include "kernels/cal_vm.h"
#include "kernels/sampler.h"
#include "kernels/view_ray.h"
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/lobes.h"
#include "kernels/modifier.h"
#include "kernels/clip.h"
#include "kernels/sources.h"
#include "kernels/source_sample.h"
#include "kernels/choose_source.h"
#include "kernels/portals.h"
#include "kernels/path/state.h"
#include "kernels/medium.h"
#include "kernels/bsdf.h"
#include "kernels/bsdf_sample.h"
#include "kernels/material.h"
#include "kernels/path.h"
