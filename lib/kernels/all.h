// SPDX-License-Identifier: BSD-3-Clause
// The device code in its order of inclusion, for C++ and OpenCL C alike, after the compat file of the device.
//
// Letters and short words have the same meaning in all of these files; the numerical ones (math*.h, cal_noise.h,
// shapes.h, woop.h, bvh*.h) also use the letters of their formulas.
//   s        SceneTables; s->u its words, s->f its floats     par     Params
//   paths    Paths, indexed by path                           vertex  Vertex: state of one step of a path (integrator/)
//   g        Surface: the point to be shaded                  lobes   Lobes: scattering of its material there
//   light    LightSample                                      rnd     Sampler
//   m        record of a modifier in s->u                     arg     its real arguments in s->f
//   source   number of an active source                       src     its record in s->f
//   p, at    points, relative to the scene's centre           n       normal
//   v        direction to the viewer                          l       direction to the light
//   dir      where a ray goes                                 e1, e2  axes across a normal
//   t        distance along a ray                             T       transmittance, rgb
//   r        radius, or a random number in use                x, y    random numbers; coordinates
//   w        solid angle of a sample, or a weight             sn, cs  sine and cosine of one angle
//   _r, _t   of reflection, of transmission                   k, i    counters, or a factor
// A trailing underscore marks the words of the compat files (sqrt_, as_uint_, MAX_), and nothing else.
//
// LUX_COMPACT (GPUs) chooses another traversal than the CPU's; LUX_LANES (many paths side by side on a CPU) leaves
// traversal and .cal programs to the kernels of one path.  LUX_HAS: see features.h.
#include "kernels/math/vec.h"
#include "kernels/math/math.h"
#include "kernels/bvh/intersect.h"
#include "kernels/geom/shapes.h"
#include "kernels/bvh/woop.h"
#include "kernels/cal/cal_vars.h"
#if defined(LUX_COMPACT)
#include "kernels/bvh/bvh_compact.h"
#elif defined(LUX_LANES)
#include "kernels/lanes_calls.isph"
#else
#include "kernels/bvh/bvh8.h"
#endif
#include "kernels/bvh/offset_ray.h"
#include "kernels/tables.h"
#ifndef LUX_LANES
#include "kernels/cal/cal_vm.h"
#endif
#include "kernels/sampling/sampler.h"
#include "kernels/geom/view_ray.h"
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#ifndef LUX_LANES
#include "kernels/bvh/coincide.h"
#endif
#include "kernels/material/lobes.h"
#include "kernels/material/modifier.h"
#include "kernels/geom/clip.h"
#include "kernels/light/sources.h"
#include "kernels/light/source_sample.h"
#include "kernels/light/relay_aperture.h"
#include "kernels/light/light_tree.h"
#include "kernels/light/choose_source.h"
#include "kernels/sampling/mixture.h"
#include "kernels/integrator/path_reuse.h"
#include "kernels/integrator/state.h"
#include "kernels/material/medium.h"
#include "kernels/material/bsdf.h"
#include "kernels/material/bsdf_sample.h"
#include "kernels/material/material.h"
#include "kernels/integrator/path.h"
